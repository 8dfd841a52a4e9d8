/// Make caps: disks of triangles that fill loops. The method is an own construction, not from a
/// publication. A cap consists of rings of vertices. Each ring has half as many vertices as the
/// surrounding ring, because this gives well-shaped triangles.

#ifndef ConformalLoopCap_h
#define ConformalLoopCap_h

#include "Base/Types.h"

#include <functional>
#include <utility>
#include <vector>

namespace conformal
{
/// Disk of triangles that fills a loop. Let #C be the number of corners of the loop. Vertex ids 0
/// to #C - 1 are the corners; ids from #C are added vertices. The triangles have the orientation of
/// the loop. Each edge of the loop belongs to one triangle.
struct LoopCap
{
  conformal::Triangles Triangles; ///< vertex ids of the triangles, #T by 3
  Points Added;                   ///< positions of the added vertices, #A by 3
  /// Range [first, last) of the ids of the nearest corners, for each added vertex, #A.
  std::vector<std::pair<int, int>> Parents;
};

/// Fill a loop with rings of vertices, and with a fan of triangles at the center. Each ring has
/// half as many vertices as the surrounding ring. The triangles are best shaped for a round loop. A
/// loop of three corners gets one triangle.
///
/// Rings can fold, for example where the loop is concave. If the rings fold, the corners are
/// triangulated without added vertices (PolygonTriangulation.h). If the triangulation would join
/// two corners that already share an edge, the rings are kept.
/// @param[in] corners  positions of at least three corners
/// @param[in] isJoined  function that returns whether corners i and j already share an edge. The
///   function is called only for corners that are not adjacent in the loop.
LoopCap capLoop(const Points& corners, const std::function<bool(int, int)>& isJoined);

/// Fill a loop with a fan of triangles around its center. The center is the mean of the midpoints
/// of the edges, weighted by edge length.
/// @param[in] corners  positions of at least two corners
LoopCap fanOf(const Points& corners);

/// Compute the total area of the triangles of a cap.
double areaOf(const LoopCap& cap, const Points& corners);
}

#endif
