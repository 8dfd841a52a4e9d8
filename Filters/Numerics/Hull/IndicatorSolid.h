/// Find the region enclosed by a point cloud, using winding numbers. The result is a set of grid
/// nodes with the topology of a ball. The method is an own construction, not from a publication. If
/// noise causes many handles or cavities, the kernel width (smoothing radius) of the winding
/// numbers is increased automatically. No parameter for noise is thus required.

#ifndef ConformalIndicatorSolid_h
#define ConformalIndicatorSolid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Hull/FreudenthalGrid.h"
#include "Hull/IndicatorGrid.h"
#include "Hull/SolidRepair.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Region enclosed by a cloud (the solid), with measures of its construction.
struct IndicatorSolid
{
  FreudenthalGrid Grid;
  Indicator Field; ///< winding numbers at the nodes
  /// 1 for the nodes of the solid, else 0; empty if there is no solid
  std::vector<std::uint8_t> Inside;
  Points Cloud;             ///< means of nearby samples, from which the solid was made
  double Width = 0.0;       ///< kernel width of the winding numbers
  double Noise = 0.0;       ///< standard deviation of the noise of the points in Cloud
  bool NormalsUsed = false; ///< whether the normals of the samples were used
  /// Euler number of the solid before its handles were removed: 1 minus the number of handles.
  Index EulerNumber = 1;
  HandleRepair Repair; ///< changes that removed the handles
};

/// Value of `handleWidth` of solidByWindingNumbers() for a solid without handles.
constexpr double RemoveAllHandles = -1.0;

/// Classify grid nodes as inside or outside by the winding numbers of all points. The inside nodes
/// are called the solid.
///
/// 1. Select about 50,000 samples. Remove isolated samples (StrayPoints.h) and replace the others
///    by at most 10,000 means (CloudThinning.h).
/// 2. If the samples have normals that are consistently oriented, by turnOutward() (Orientation.h),
///    use these normals. Otherwise, estimate normals by orient().
/// 3. Compute winding numbers on a grid (IndicatorGrid.h). Nodes with winding numbers above the
///    isovalue (Indicator::Level) are inside. If the points are noisy, the kernel width is at least
///    2.5 times the standard deviation of the noise. If noisy points result in more than four
///    handles and cavities, repeat this step with the 1.5-fold width, at most twice. Keep the solid
///    with the fewest handles and cavities. If the positions of the scanners are known, nodes that
///    scanners have looked through are outside (FreeSpace.h).
/// 4. Join components, fill cavities and remove handles (SolidRepair.h). Without handles, the solid
///    has the topology of a ball.
///
/// @param[in] samples  samples of affine rank 3: samples that do not lie in one plane
/// @param[in] spacing  grid spacing, divided by the largest distance of a sample from the origin
/// @param[in] handleWidth  minimum width of handles and of their openings that are kept, in the
///   unit of GenusZeroHullOptions::HandleWidth; RemoveAllHandles to keep none
/// @return the solid; IndicatorSolid::Inside is empty if there are too few points or no inside
///   nodes
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
///   (CloudDistance.h)
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
IndicatorSolid solidByWindingNumbers(const TrainingSamples& samples, double spacing,
  double handleWidth = RemoveAllHandles, const Run& run = {});
}

#endif
