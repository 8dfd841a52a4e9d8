/// The inside of a point cloud by winding numbers, as a ball of grid nodes.
/// Own construction: the kernel width follows noise and topology without parameters.

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
  Indicator Field;                  ///< at the nodes
  std::vector<std::uint8_t> Inside; ///< 1 for the nodes of the solid, else 0; empty for no solid
  Points Cloud;                     ///< what it was made from: the samples, thinned
  double Width = 0.0;               ///< of the winding numbers
  double Noise = 0.0;               ///< of the thinned points, its standard deviation
  bool NormalsUsed = false;         ///< whether normals were given, and of use
  Index EulerNumber = 1;            ///< before handles were opened: 1 - handles
  HandleRepair Repair;
};

/// Separate inside from outside by the winding numbers of all points.
///
/// 1. Some 50,000 samples are selected, isolated ones left out (StrayPoints.h) and the others
///    thinned to 10,000 (CloudThinning.h).
/// 2. Normals are those of the samples, if these have some that agree on what is inside, else they
///    are found (Orientation.h).
/// 3. The winding number is found on a grid (IndicatorGrid.h); inside is what lies above its
///    level. Where the points are noisy (Orientation.h), the width is that of the noise, and while
///    what is inside has many handles and cavities, it is found anew with a larger width; what has
///    the fewest is taken.
/// 4. Pieces are joined, cavities filled and handles opened (SolidRepair.h), so that the solid is a
///    ball.
///
/// @param[in] samples  of rank 3
/// @return no solid if there are too few points
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
IndicatorSolid solidByWindingNumbers(
  const TrainingSamples& samples, double spacing, const Run& run = {});
}

#endif
