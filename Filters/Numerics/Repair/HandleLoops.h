/// Find short loops around and through the handles of closed surfaces.

#ifndef ConformalHandleLoops_h
#define ConformalHandleLoops_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/GluedSurface.h"

#include <vector>

namespace conformal
{
/// Loop of glued sides that visits no vertex twice. Each side ends where the next one begins.
struct HandleLoop
{
  std::vector<int> Sides;
  double Length = 0.0;
};

/// Find short loops around handles or through their openings. The surface stays connected if it is
/// cut along all of them. No two loops share a vertex.
///
/// A tree of shortest paths and a dual tree across the remaining edges leave 2 g edges unused
/// (\cite Eppstein2003, \cite Erickson2005). Here g is the genus of the surface. Each unused edge
/// defines a loop. Candidates are the shortest loops through the vertices of these loops that do
/// not separate the surface. For each handle, one candidate runs around it and one through it.
/// Candidates are selected by length, the shortest first.
///
/// A surface with many handles, or with handles that share loops, may need several calls. Between
/// calls, cut the surface along the loops and close it. Each call returns at least one loop if the
/// surface has a handle.
///
/// The cost is about that of sorting the sides a few times, plus shortest paths in the neighborhood
/// of each handle.
/// @param[in] surface  closed and connected
/// @param[in] lengths  #3F, length of each side, at least 0; glued sides have equal lengths
std::vector<HandleLoop> findHandleLoops(
  const GluedSurface& surface, const std::vector<double>& lengths, const Run& run = {});

/// Compute the number of handles of a closed, orientable, connected surface.
Index numberOfHandles(const GluedSurface& surface);
}

#endif
