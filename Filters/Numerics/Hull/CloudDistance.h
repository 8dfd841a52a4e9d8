/// Compute the distance to a point cloud at the nodes of a grid around the cloud.
/// The nearest sample of each node is propagated to neighboring nodes as in \cite Danielsson1980.

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
/// Make a grid of cubes around the samples, in their normalized coordinates (TrainingSamples.h). In
/// normalized coordinates, the largest distance of a sample from the origin is 1. On each side, the
/// grid extends `margin` nodes beyond the bounding box of the samples.
/// @throws std::invalid_argument if the grid would have more than MaximumNumberOfNodes; the message
///   contains a spacing that is large enough
FreudenthalGrid gridAround(
  const TrainingSamples& samples, double spacing, int margin, const Run& run = {});

/// Make a grid of cubes around a box. On each side, the grid extends `margin` nodes beyond the box.
FreudenthalGrid gridAround(const Box& bounds, double spacing, int margin);

/// Maximum number of nodes of a grid.
constexpr Index MaximumNumberOfNodes = Index(1) << 28;

/// Compute the distance of each node to the nearest sample, in units of the grid spacing.
///
/// Distances up to one grid spacing are exact to float precision. Larger distances are upper
/// bounds: a node gets the distance to the sample that is nearest to one of its neighbors. The mean
/// error of the upper bounds is a few hundredths of the grid spacing. The maximum error is below
/// one grid spacing.
///
/// Implementation note: if a cloud is large, only some samples are used. Let h be the grid spacing
/// divided by the largest distance of a sample from the origin. If there are many more than 32 /
/// h^2 samples, about 32 / h^2 are selected, evenly from their sequence. For samples on the unit
/// sphere, this is two or three samples for each area of one squared spacing. The selection reduces
/// the cost. The selection also keeps outliers isolated, so that the outliers can be detected.
///
/// Implementation note: two kinds of outliers are ignored:
/// - samples marked by strayPoints() (StrayPoints.h), which do not lie on the surface formed by
///   other samples.
/// - isolated samples: single samples or groups of a few, separated from all other samples by at
///   least about two grid spacings.
///
/// Isolated samples are kept in two cases: the cloud is sparse, or more than a twentieth of all
/// samples are isolated.
///
/// Memory: 9 bytes per node during the computation.
///
/// @param[in] grid  grid that contains the samples
/// @post the result depends only on the arguments, not on the number of threads
std::vector<float> distanceToSamples(
  const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run = {});
}

#endif
