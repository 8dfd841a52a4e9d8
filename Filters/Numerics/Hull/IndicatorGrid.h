/// Compute winding numbers at the nodes of a grid around a cloud.
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
/// Winding number at each node: about 1 inside, 0 outside, and intermediate where data are missing.
struct Indicator
{
  std::vector<float> Values; ///< winding number at each node
  double Level = 0.5;        ///< isovalue of the surface: half of the points are inside of it
};

/// Compute winding numbers at the nodes, blurred over the adjacent nodes of each axis.
///
/// Every fourth node along each axis is evaluated. In cubes of evaluated nodes, all nodes are
/// evaluated if the cube is near points or may intersect the isosurface. The other nodes are
/// interpolated.
///
/// @param[in] cloud   cloud whose points are within the grid
/// @param[in] areas   #P by 3, area vector of each point
/// @param[in] width   kernel width of the winding numbers
/// @throws Aborted
Indicator indicatorOn(const FreudenthalGrid& grid, const WindingNumbers& cloud, const Points& areas,
  double width, const Run& run = {});
}

#endif
