/// Find the inside of a point cloud by winding numbers, as a set of grid nodes with the topology of
/// a ball. Own construction: the kernel width is increased until the topology is simple, because
/// then the user sets no parameter for noise.

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
struct IndicatorSolid
{
  FreudenthalGrid Grid;
  Indicator Field;                  ///< winding numbers at the nodes
  std::vector<std::uint8_t> Inside; ///< 1 for the nodes of the solid, else 0; empty for no solid
  Points Cloud;                     ///< thinned samples, from which the solid was made
  double Width = 0.0;               ///< kernel width of the winding numbers
  double Noise = 0.0;               ///< standard deviation of the noise of the thinned points
  bool NormalsUsed = false;         ///< whether the normals of the samples were used
  /// Euler number of the solid before its handles were removed: 1 minus the number of handles.
  Index EulerNumber = 1;
  HandleRepair Repair;
};

/// Separate inside from outside by the winding numbers of all points.
///
/// 1. Select about 50,000 samples. Remove isolated samples (StrayPoints.h) and thin the others to
///    10,000 (CloudThinning.h).
/// 2. Use the normals of the samples if enough of them consistently indicate the inside. Otherwise,
///    estimate them (Orientation.h).
/// 3. Compute winding numbers on a grid (IndicatorGrid.h); nodes above the isovalue are inside. The
///    kernel width depends on the noise of the points (Orientation.h). While the solid has many
///    handles and cavities, repeat with a larger width. Keep the solid with the fewest handles and
///    cavities.
/// 4. Join components, fill cavities and open handles (SolidRepair.h), so that the solid has the
///    topology of a ball.
///
/// @param[in] samples  samples of affine rank 3
/// @return the solid; IndicatorSolid::Inside is empty if there are too few points
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
IndicatorSolid solidByWindingNumbers(
  const TrainingSamples& samples, double spacing, const Run& run = {});
}

#endif
