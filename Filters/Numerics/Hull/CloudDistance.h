/// Compute the distance to a point cloud at the nodes of a grid around it.
/// Nearest samples are propagated from node to node as in \cite Danielsson1980.

#ifndef ConformalCloudDistance_h
#define ConformalCloudDistance_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Hull/FreudenthalGrid.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Make a grid that extends `margin` nodes beyond the bounding box of the samples on each side.
/// @throws std::invalid_argument if it would have more than MaximumNumberOfNodes; the message names
///   a spacing that fits
FreudenthalGrid gridAround(
  const TrainingSamples& samples, double spacing, int margin, const Run& run = {});

/// Make a grid that extends `margin` nodes beyond a box on each side.
FreudenthalGrid gridAround(const Box& bounds, double spacing, int margin);

constexpr Index MaximumNumberOfNodes = Index(1) << 28;

/// Compute the distance of each node to the nearest sample, in units of the grid spacing.
///
/// Distances up to 1 are exact to float precision. A larger distance is that to a sample which is
/// nearest to some neighboring node. Its mean error is a few hundredths, its maximum error below 1,
/// and it is never too small.
///
/// Implementation note: if a cloud has many more than 32 / h^2 samples, about that many are
/// selected, evenly over their order. Here h is the spacing in units of the maximum radius, so a
/// sphere gets two or three samples for each square of the grid. The selection reduces the cost,
/// and leaves outliers isolated.
///
/// Implementation note: outliers of a dense cloud are ignored. An outlier is a sample, or a group
/// of a few, at least two spacings from all others. If more than a twentieth of all samples are
/// isolated, all are kept.
///
/// Memory: 9 bytes a node during the computation.
///
/// @param[in] grid  contains the samples
/// @post the result depends on the samples only, not on the number of threads
std::vector<float> distanceToSamples(
  const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run = {});
}

#endif
