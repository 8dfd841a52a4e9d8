/// Find short loops around and through the handles of closed surfaces.

#ifndef ConformalHandleLoops_h
#define ConformalHandleLoops_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/GluedSurface.h"

#include <vector>

namespace conformal
{
/// Loop of triangle sides that visits no vertex twice. Each side is glued to the side of another
/// triangle (GluedSurface.h). Each side ends where the next side begins.
struct HandleLoop
{
  std::vector<int> Sides;
  double Length = 0.0; ///< sum of the lengths of the sides
};

/// Find short loops around handles or through their openings. A cut along all of these loops leaves
/// the surface connected. No two loops share a vertex.
///
/// The method is that of \cite Eppstein2003 and \cite Erickson2005. Let g be the genus (number of
/// handles) of the surface. A tree of shortest paths is grown along edges. A second (dual) tree
/// joins neighboring triangles across the remaining edges. Exactly 2 g edges belong to neither
/// tree. Each of the 2 g edges, together with the shortest paths to its ends, forms a loop.
///
/// Each of the 2 g loops is then shortened. The candidates are loops that pass through a vertex of
/// the given loop, and do not separate the surface into two parts. The shortest candidate is kept.
/// For each handle, one loop runs around the handle and another one runs through its opening. The
/// loops to return are selected from all shortened loops, the shortest loops first.
///
/// If the surface has many handles, or if loops of several handles intersect, several calls can be
/// necessary. Between calls, cut the surface along the loops and close the cuts. If the surface has
/// a handle, each call returns at least one loop.
///
/// For few handles, the computing time is about that of sorting the sides a few times, plus that of
/// the shortest paths near each handle. For thousands of handles, it is at least quadratic in their
/// number, since each side and loop has one bit for each remaining edge, and since loops of
/// neighboring handles are shortened again in each call.
/// @param[in] surface  closed and connected surface
/// @param[in] lengths  length of each side, #3F, at least 0; glued sides must have equal lengths
/// @return the loops, sorted by length
std::vector<HandleLoop> findHandleLoops(
  const GluedSurface& surface, const std::vector<double>& lengths, const Run& run = {});

/// Compute the number of handles of a closed, orientable, connected surface.
Index numberOfHandles(const GluedSurface& surface);
}

#endif
