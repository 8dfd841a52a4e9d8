/// Winding numbers at the nodes of a grid around a cloud.
/// Winding numbers of \cite Barill2018.

#ifndef ConformalIndicatorGrid_h
#define ConformalIndicatorGrid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/WindingNumbers.h"
#include "Hull/FreudenthalGrid.h"

#include <vector>

namespace conformal
{
/// The winding number at each node: about 1 inside and 0 outside, and between where data are
/// missing.
struct Indicator
{
  std::vector<float> Values; ///< of each node
  double Level = 0.5;        ///< that of the surface: half of the points are inside of it
};

/// Winding numbers at the nodes, blurred a little: over the next node in each direction.
///
/// Every fourth node along the axes is evaluated, and all nodes of the cubes between these that are
/// near points, or in which the surface may be that the level tells. The other nodes are
/// interpolated.
///
/// @param[in] cloud   its points within the grid
/// @param[in] areas   #P by 3, area vectors of the points
/// @param[in] width   of the winding numbers
/// @throws Aborted
Indicator indicatorOn(const FreudenthalGrid& grid, const WindingNumbers& cloud, const Points& areas,
  double width, const Run& run = {});
}

#endif
