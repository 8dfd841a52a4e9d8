#include "Hull/CloudDistance.h"

#include "Cloud/StrayPoints.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/PointTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using conformal::distanceToSamples;
using conformal::FreudenthalGrid;
using conformal::gridAround;
using conformal::Index;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
// A noisy ellipsoid.
Points ellipsoid(Index size)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    const Vector3 x(normal(random), normal(random), normal(random));
    points.row(i) = x.normalized().cwiseProduct(Vector3(1.0, 0.7, 0.5)) * (1 + 0.01 * x[0]);
  }
  return points;
}

Points normalizedWithout(const std::vector<std::uint8_t>& left, const TrainingSamples& samples)
{
  Points kept(std::count(left.begin(), left.end(), 0), 3);
  Index size = 0;
  for (Index i = 0; i < samples.size(); ++i)
  {
    if (!left[i])
    {
      kept.row(size++) = samples[i];
    }
  }
  return kept;
}
}

TEST(CloudDistance, GridHoldsTheSamplesWithAMargin)
{
  const Points points = ellipsoid(500);
  const TrainingSamples samples{ PointView(points) };
  const FreudenthalGrid grid = gridAround(samples, 0.07, 3);
  double least = 1e9, most = -1e9;
  for (Index i = 0; i < samples.size(); ++i)
  {
    const Vector3 x = grid.toGrid(samples[i]);
    least = std::min(least, x.minCoeff());
    most = std::max(most, x[0] - (grid.Size[0] - 1));
  }
  EXPECT_GE(least, 3.0);
  EXPECT_LT(least, 3.6);
  EXPECT_LE(most, -3.0);
  EXPECT_THROW(gridAround(samples, 1e-4, 3), std::invalid_argument);
}

// Exact up to one spacing and never too small; beyond, close to it.
TEST(CloudDistance, AgreesWithATree)
{
  const Points points = ellipsoid(5000);
  // Of those that do not stray: these alone have to make the distance.
  const std::vector<std::uint8_t> stray = conformal::strayPoints(points);
  const TrainingSamples samples(points);
  const conformal::PointTree tree(normalizedWithout(stray, samples));
  const FreudenthalGrid grid = gridAround(samples, 0.05, 4);
  const std::vector<float> distances = distanceToSamples(grid, samples);
  double sum = 0.0, worst = 0.0;
  for (int node = 0; node < grid.numberOfNodes(); ++node)
  {
    const double exact = std::sqrt(tree.nearest(grid.position(node)).SquareDistance) / grid.Spacing;
    if (exact <= 1.0)
    {
      ASSERT_NEAR(distances[node], exact, 1e-4);
    }
    const double error = distances[node] - exact;
    ASSERT_GT(error, -1e-4);
    sum += error;
    worst = std::max(worst, error);
  }
  EXPECT_LT(sum / static_cast<double>(distances.size()), 0.06);
  EXPECT_LT(worst, 1.0);
}

TEST(CloudDistance, DoesNotDependOnTheOrderOfBlocks)
{
  const Points points = ellipsoid(20000);
  const TrainingSamples samples{ PointView(points) };
  const FreudenthalGrid grid = gridAround(samples, 0.05, 3);
  EXPECT_EQ(distanceToSamples(grid, samples), distanceToSamples(grid, samples, runs::backwards()));
}

// A sample in the middle is an outlier of a dense cloud, but not of a sparse one.
TEST(CloudDistance, LeavesOutliersOfDenseCloudsOut)
{
  for (const Index size : { 20000, 200 })
  {
    Points points = ellipsoid(size);
    points.row(77).setZero();
    const TrainingSamples samples{ PointView(points) };
    const FreudenthalGrid grid = gridAround(samples, 0.05, 3);
    const Eigen::Vector3i there = grid.toGrid(samples[77]).array().round().cast<int>();
    const std::vector<float> distances = distanceToSamples(grid, samples);
    const double distance = distances[grid.node(there[0], there[1], there[2])] * grid.Spacing;
    EXPECT_NEAR(distance, size == 200 ? 0.0 : 0.5, 0.06);
  }
}
