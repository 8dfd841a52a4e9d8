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
/// Make a grid around the samples. It extends `margin` nodes beyond their bounding box on each
/// side.
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes; the message
///   contains a spacing that is large enough
FreudenthalGrid gridAround(
  const TrainingSamples& samples, double spacing, int margin, const Run& run = {});

/// Make a grid around a box. It extends `margin` nodes beyond the box on each side.
FreudenthalGrid gridAround(const Box& bounds, double spacing, int margin);

constexpr Index MaximumNumberOfNodes = Index(1) << 28;

/// Compute the distance of each node to the nearest sample, in units of the grid spacing.
///
/// Distances up to 1 are exact to float precision. A larger distance is measured to the nearest
/// sample of some neighboring node, and is never too small. The mean error is a few hundredths, the
/// maximum error is below 1.
///
/// Implementation note: if a cloud has many more than 32 / h^2 samples, about 32 / h^2 are selected
/// at equal steps of their sequence. Here h is the spacing in units of the maximum radius. A sphere
/// thus gets two or three samples for each square of the grid. The selection reduces the cost and
/// keeps outliers isolated.
///
/// Implementation note: outliers of a dense cloud are ignored. An outlier is a sample, or a group
/// of a few samples, at least two spacings away from all others. If more than a twentieth of all
/// samples are isolated, no sample is ignored.
///
/// Memory: 9 bytes per node during the computation.
///
/// @param[in] grid  grid that contains the samples
/// @post the result depends on the samples only, not on the number of threads
std::vector<float> distanceToSamples(
  const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run = {});
}

#endif
