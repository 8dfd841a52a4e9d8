/// Decimation of a closed surface.

#ifndef ConformalMeshDecimation_h
#define ConformalMeshDecimation_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Some of the given points in their order, #W of them, with 2 #W - 4 triangles.
struct DecimatedMesh : Mesh
{
  std::vector<int> PointIds; ///< #W: which of the given points each is
};

/// Take vertices out of a closed surface of genus zero by half-edge collapses (QuadricCollapse),
/// so that it stays one.
///
/// @param[in] mesh              finite, consistently oriented; points of no triangle are dropped
/// @param[in] numberOfVertices  #W to be left, at least 4; nothing is done if there are no more
/// @throws std::invalid_argument with what is wrong, if the surface is another one
DecimatedMesh decimate(const Mesh& mesh, Index numberOfVertices, const Run& run = {});
}

#endif
