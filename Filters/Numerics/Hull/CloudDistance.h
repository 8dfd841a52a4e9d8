/// Distance to a point cloud at the nodes of a grid around it.
/// Propagation of nearest samples as in \cite Danielsson1980.

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
/// A grid around the samples, `margin` nodes wider than their bounding box on each side.
/// @throws std::invalid_argument if it would have more than MaximumNumberOfNodes; says which
/// spacing
///   would do
FreudenthalGrid gridAround(
  const TrainingSamples& samples, double spacing, int margin, const Run& run = {});

/// A grid around a box likewise.
FreudenthalGrid gridAround(const Box& bounds, double spacing, int margin);

constexpr Index MaximumNumberOfNodes = Index(1) << 28;

/// Distance of each node to the nearest sample, in units of the grid's spacing.
///
/// Exact, to float precision, up to a distance of 1. Beyond, it is the distance to a sample that is
/// nearest to some node nearby: too large by a few hundredths in the mean, by less than 1 at worst.
///
/// Implementation note: of a cloud with many more than 32 / h^2 samples (max radius 1, so a sphere
/// would have two or three for each square of the grid), about that many are taken, spread
/// evenly over their order. It saves time, and leaves outliers far from each other.
///
/// Implementation note: of a dense cloud, samples far from all others are left out as outliers: up
/// to a few of them together, no nearer to the rest than two spacings, as long as they are not more
/// than a twentieth of all.
///
/// Takes 9 bytes a node while it runs.
///
/// @param[in] grid  has the samples within
/// @post the result depends on the samples only, not on threads
std::vector<float> distanceToSamples(
  const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run = {});
}

#endif
