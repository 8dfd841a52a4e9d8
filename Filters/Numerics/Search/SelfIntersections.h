/// Find self-intersections of a triangle mesh: triangles that cross each other, \cite Moeller1997.

#ifndef ConformalSelfIntersections_h
#define ConformalSelfIntersections_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace conformal
{
/// Find pairs of triangles that cross each other. Triangles with a common vertex are not tested,
/// and neither are triangles that only touch or lie in one plane. Candidates are found by a tree of
/// bounding boxes.
/// @param[in] positions  #V by 3, finite
/// @param[in] triangles  #F by 3 ids
/// @return ids of the two triangles of each pair, the smaller first, in ascending order
/// @throws Aborted
std::vector<std::array<int, 2>> selfIntersections(
  const Points& positions, const Triangles& triangles, const Run& run = {});

/// Find pairs of triangles that cross each other, and of which one or both are chosen.
/// @param[in] chosen  ids of triangles, each at most once
std::vector<std::array<int, 2>> selfIntersections(const Points& positions,
  const Triangles& triangles, const std::vector<int>& chosen, const Run& run = {});
}

#endif
