/// Find the space that scanners have looked through. The method is our own construction: no surface
/// lies between a scanner and a point that it has measured, as in the space carving of
/// \cite Curless1996. Only rays are needed, not the images of the scanners.

#ifndef ConformalFreeSpace_h
#define ConformalFreeSpace_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <vector>

namespace conformal
{
/// Compute at each node of a grid how empty the space there is, from the rays between points and
/// their scanners. Rays are marked on a coarser grid, whose nodes are twice the spacing of the
/// points apart, so that rays of neighboring points leave no gaps. Nodes within about three
/// spacings of a point are not marked, because the error of a point or of its ray may be as large.
///
/// @param[in] points  #P by 3
/// @param[in] toScanner  vector from each point to its scanner, #P by 3; 0 if unknown
/// @param[in] spacing  typical distance between neighboring points
/// @param[in] noise  standard deviation of the noise of the points
/// @return number in [0, 1] at each node: 1 where scanners have looked through, 0 elsewhere, and
///   intermediate between both
/// @throws Aborted
std::vector<float> freeSpace(const FreudenthalGrid& grid, const Points& points,
  const Points& toScanner, double spacing, double noise, const Run& run = {});
}

#endif
