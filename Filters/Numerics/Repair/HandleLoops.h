/// Short loops around and through the handles of closed surfaces.

#ifndef ConformalHandleLoops_h
#define ConformalHandleLoops_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/GluedSurface.h"

#include <vector>

namespace conformal
{
/// Simple loop of glued sides, each of which ends where the next begins.
struct HandleLoop
{
  std::vector<int> Sides;
  double Length = 0.0;
};

/// Find short loops along which a closed surface can be cut simultaneously and stays connected. No
/// two loops share a vertex.
///
/// A tree of shortest paths and a dual tree across the other edges leave 2 g edges over (\cite
/// Eppstein2003, \cite Erickson2005). Each of these defines a loop. The shortest loops through its
/// vertices that do not separate the surface are candidates: one around each handle and one through
/// it. Candidates are selected by length, the shortest first.
///
/// Many handles, or handles with shared loops, may need several calls: cut, close and search again.
/// Each call returns at least one loop if the surface has a handle.
///
/// The cost is about that of a few sorts of the sides and, for each handle, of the shortest paths
/// around it.
/// @param[in] surface  closed and connected
/// @param[in] lengths  #3F of the sides, at least 0, equal for glued ones
std::vector<HandleLoop> findHandleLoops(
  const GluedSurface& surface, const std::vector<double>& lengths, const Run& run = {});

/// Compute the number of handles of a closed, orientable, connected surface.
Index numberOfHandles(const GluedSurface& surface);
}

#endif
