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
/// Triangles of the corners of a loop, 0 to #C - 1, and of vertices added behind them. They turn as
/// the loop does; each of its edges belongs to one of them.
struct LoopCap
{
  conformal::Triangles Triangles;           ///< #T by 3
  Points Added;                             ///< #A by 3 positions
  std::vector<std::pair<int, int>> Parents; ///< #A: the corners [first, last) nearest to each
};

/// Fill a loop with rings of vertices, each of half as many as the one around it, down to a fan.
/// Its triangles are about as well shaped as the loop is round. Three corners get one triangle.
///
/// Where such rings would fold, as in bays of the loop, it is cut into triangles of its corners
/// instead (PolygonTriangulation.h), if that is possible without joining two that are joined.
/// @param[in] corners   at least three
/// @param[in] isJoined  whether corners i and j, which are not next to each other, have an edge
LoopCap capLoop(const Points& corners, const std::function<bool(int, int)>& isJoined);

/// Fill a loop with a fan around its middle, which is the mean of its edges' middles.
/// @param[in] corners  at least two
LoopCap fanOf(const Points& corners);

/// Sum of the areas of a cap's triangles.
double areaOf(const LoopCap& cap, const Points& corners);
}

#endif
