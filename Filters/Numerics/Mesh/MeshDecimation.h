/// Decimate a closed surface of genus zero. Vertices whose removal changes the shape least are
/// removed first, \cite Garland1997. The change is measured by the quadric error, a sum of squared
/// distances from planes of triangles.

#ifndef ConformalMeshDecimation_h
#define ConformalMeshDecimation_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Decimated mesh. The vertices are some of the input points, in the sequence of the input. A mesh
/// of #W vertices has 2 (#W - 2) triangles.
struct DecimatedMesh : Mesh
{
  std::vector<int> PointIds; ///< #W values: id of the input point at each vertex
};

/// Remove vertices of a closed surface of genus zero by half-edge collapses, which merge a vertex
/// into a neighbor. The class QuadricCollapse selects the collapses. The topology does not change.
///
/// @param[in] mesh              mesh to decimate; finite and consistently oriented. Points without
///   triangles are dropped.
/// @param[in] numberOfVertices  #W, at least 4. If the mesh has at most #W vertices, no vertex of a
///   triangle is removed.
/// @throws std::invalid_argument if #W is below 4, or the surface is not closed and of genus zero.
///   The message describes the faults.
DecimatedMesh decimate(const Mesh& mesh, Index numberOfVertices, const Run& run = {});
}

#endif
