/// Compute winding numbers at the nodes of a grid around a point cloud, by the method of
/// \cite Barill2018.

#ifndef ConformalIndicatorGrid_h
#define ConformalIndicatorGrid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/WindingNumbers.h"
#include "Hull/FreudenthalGrid.h"

#include <vector>

namespace conformal
{
/// Winding number at each node of a grid, which indicates the inside of a cloud. Values are about 1
/// inside, about 0 outside, and intermediate where the cloud has holes.
struct Indicator
{
  std::vector<float> Values; ///< winding number at each node
  double Level = 0.5; ///< isovalue of the surface: the median of the winding numbers at the points
};

/// Compute winding numbers at the nodes of a grid, and blur the values along each axis. A blurred
/// value is 1/2 of the value of the node plus 1/4 of the value of each neighbor along the axis.
///
/// Every fourth node along each axis forms a coarse grid, which is evaluated first. The isosurface
/// is where the winding number equals Indicator::Level. If a cube of the coarse grid is near
/// points, or possibly intersects the isosurface, all nodes in the cube are evaluated. At all other
/// nodes, winding numbers are interpolated between nodes of the coarse grid.
///
/// @param[in] grid  grid that contains the points of the cloud
/// @param[in] cloud  points of the cloud, with a hierarchy of clusters for fast sums
/// @param[in] areas  area vector of each point (area times outward unit normal), #P by 3
/// @param[in] width  kernel width (smoothing radius) of the winding numbers, in the unit of the
///   points
/// @throws Aborted
Indicator indicatorOn(const FreudenthalGrid& grid, const WindingNumbers& cloud, const Points& areas,
  double width, const Run& run = {});
}

#endif
