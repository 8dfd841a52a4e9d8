/// Make disks of triangles (caps) that fill loops. Own construction: each ring of vertices has half
/// as many as the one around it, because this gives well-shaped triangles.

#ifndef ConformalLoopCap_h
#define ConformalLoopCap_h

#include "Base/Types.h"

#include <functional>
#include <utility>
#include <vector>

namespace conformal
{
/// Disk of triangles that fills a loop of #C corners. Ids 0 to #C - 1 are the corners, ids from #C
/// are added vertices. Triangles have the orientation of the loop. Each edge of the loop belongs to
/// one triangle.
struct LoopCap
{
  conformal::Triangles Triangles; ///< #T by 3
  Points Added;                   ///< #A by 3 positions
  /// #A, range [first, last) of the corners nearest to each added vertex.
  std::vector<std::pair<int, int>> Parents;
};

/// Fill a loop with rings of vertices and a fan of triangles at the center. Each ring has half as
/// many vertices as the one around it. The triangles are best shaped for a round loop. A loop of
/// three corners gets one triangle.
///
/// If rings would fold, for example in a bay of the loop, the corners are triangulated without
/// added vertices (PolygonTriangulation.h). This is done only if it duplicates no edge.
/// @param[in] corners   positions of at least three corners
/// @param[in] isJoined  function that returns whether corners i and j already share an edge; called
///   for corners that are not adjacent in the loop
LoopCap capLoop(const Points& corners, const std::function<bool(int, int)>& isJoined);

/// Fill a loop with a fan around its center, the mean of the midpoints of its edges.
/// @param[in] corners  positions of at least two corners
LoopCap fanOf(const Points& corners);

/// Compute the total area of a cap's triangles.
double areaOf(const LoopCap& cap, const Points& corners);
}

#endif
