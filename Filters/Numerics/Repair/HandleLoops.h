/// Short loops around and through the handles of closed surfaces.

#ifndef ConformalHandleLoops_h
#define ConformalHandleLoops_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/GluedSurface.h"

#include <vector>

namespace conformal
{
/// A loop of glued sides, each of which ends where the next begins, that passes no vertex twice.
struct HandleLoop
{
  std::vector<int> Sides;
  double Length = 0.0;
};

/// Loops along which a closed surface can be cut at the same time and stays in one piece: no two
/// have a vertex in common. Short ones: for each of the 2 g loops that a tree of shortest paths and
/// a tree across the other edges leave over (\cite Eppstein2003, \cite Erickson2005), the shortest
/// loops that cut no piece off are looked for through the vertices along it, of which there is one
/// around each handle and one through it; the shortest of all come first.
///
/// For many handles, or ones that share their loops, not all are found at once: cut, close and look
/// again. There is at least one as long as the surface has handles.
///
/// The time is about that of a few sorts of the sides, and for each handle that of the shortest
/// paths around it.
/// @param[in] surface  closed, of one piece
/// @param[in] lengths  #3F of the sides, at least 0, the same for glued ones
std::vector<HandleLoop> findHandleLoops(
  const GluedSurface& surface, const std::vector<double>& lengths, const Run& run = {});

/// Number of handles of a closed, orientable surface of one piece.
Index numberOfHandles(const GluedSurface& surface);
}

#endif
