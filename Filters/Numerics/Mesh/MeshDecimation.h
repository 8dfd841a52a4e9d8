/// Decimate a closed surface of genus zero by quadric error, \cite Garland1997.

#ifndef ConformalMeshDecimation_h
#define ConformalMeshDecimation_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Decimated mesh: #W of the given points in their order, and 2 #W - 4 triangles.
struct DecimatedMesh : Mesh
{
  std::vector<int> PointIds; ///< #W ids of the given points
};

/// Remove vertices of a closed surface of genus zero by half-edge collapses (QuadricCollapse),
/// which keep its topology.
///
/// @param[in] mesh              finite, consistently oriented; points without triangles are dropped
/// @param[in] numberOfVertices  #W, at least 4; a mesh without more vertices is returned unchanged
/// @throws std::invalid_argument with the faults, if the surface is not closed and of genus zero
DecimatedMesh decimate(const Mesh& mesh, Index numberOfVertices, const Run& run = {});
}

#endif
