/// Disks of triangles that fill loops.
/// Own construction: rings of halved size give well-shaped triangles.

#ifndef ConformalLoopCap_h
#define ConformalLoopCap_h

#include "Base/Types.h"

#include <functional>
#include <utility>
#include <vector>

namespace conformal
{
/// Triangles of the corners of a loop, 0 to #C - 1, and of added vertices, numbered from #C. They
/// are oriented as the loop; each edge of the loop belongs to one triangle.
struct LoopCap
{
  conformal::Triangles Triangles;           ///< #T by 3
  Points Added;                             ///< #A by 3 positions
  std::vector<std::pair<int, int>> Parents; ///< #A: range [first, last) of the nearest corners
};

/// Fill a loop with rings of vertices, each with half as many as the one around it, and a fan at
/// the center. The rounder the loop, the better shaped are its triangles. Three corners get one
/// triangle.
///
/// If rings would fold, as in bays of the loop, its corners are triangulated instead
/// (PolygonTriangulation.h), provided that no edge is duplicated.
/// @param[in] corners   at least three
/// @param[in] isJoined  whether corners i and j, which are not adjacent in the loop, share an edge
LoopCap capLoop(const Points& corners, const std::function<bool(int, int)>& isJoined);

/// Fill a loop with a fan around its center, the mean of the midpoints of its edges.
/// @param[in] corners  at least two
LoopCap fanOf(const Points& corners);

/// Compute the total area of a cap's triangles.
double areaOf(const LoopCap& cap, const Points& corners);
}

#endif
