/// The same closed surface with fewer vertices.

#ifndef ConformalMeshDecimation_h
#define ConformalMeshDecimation_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
struct DecimatedMesh
{
  conformal::Points Points;       ///< #W by 3, some of the given ones in their order
  conformal::Triangles Triangles; ///< 2 #W - 4 by 3
  std::vector<int> PointIds;      ///< #W: which of the given points each is
};

/// Take vertices out of a closed surface of genus zero by half-edge collapses (QuadricCollapse),
/// so that it stays one.
///
/// @param[in] points            #V by 3, finite
/// @param[in] triangles         #F by 3 vertex ids, consistently oriented; unused points are
/// dropped
/// @param[in] numberOfVertices  #W to be left, at least 4; nothing is done if there are no more
/// @throws std::invalid_argument with what is wrong, if the surface is another one
DecimatedMesh decimate(const Points& points, const Triangles& triangles, Index numberOfVertices,
  const Progress& progress = {});
}

#endif
