/// Decimate a closed surface of genus zero by quadric error, \cite Garland1997.

#ifndef ConformalMeshDecimation_h
#define ConformalMeshDecimation_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Decimated mesh. Its vertices are #W of the input points, in the order of the input. It has 2 #W
/// - 4 triangles.
struct DecimatedMesh : Mesh
{
  std::vector<int> PointIds; ///< #W ids: the input point of each vertex
};

/// Remove vertices of a closed surface of genus zero by half-edge collapses (QuadricCollapse). The
/// topology does not change.
///
/// @param[in] mesh              mesh to decimate, finite and consistently oriented; points without
///   triangles are dropped
/// @param[in] numberOfVertices  #W, at least 4; a mesh of at most #W vertices is returned unchanged
/// @throws std::invalid_argument if the surface is not closed and of genus zero; the message
///   describes its faults
DecimatedMesh decimate(const Mesh& mesh, Index numberOfVertices, const Run& run = {});
}

#endif
