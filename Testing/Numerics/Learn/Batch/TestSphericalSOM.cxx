#include "Learn/Batch/SphericalSOM.h"

#include "Base/Random.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using conformal::Columns;
using conformal::Index;
using conformal::learnSphericalSOM;
using conformal::SphericalSOMOptions;
using conformal::SphericalSOMResult;

namespace
{
double normal(conformal::Random& random)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.uniform();
  }
  return sum;
}

// Clusters around four corners of a cube in five dimensions.
Columns clusters(Index size)
{
  conformal::Random random(2);
  Columns rows(5, size);
  for (Index i = 0; i < size; ++i)
  {
    for (int c = 0; c < 5; ++c)
    {
      rows(c, i) = ((i % 4) >> (c % 2) & 1 ? 10.0 : 0.0) + normal(random);
    }
  }
  return rows;
}

// A sphere, rotated into five dimensions.
Columns sphere(Index size)
{
  conformal::Random random(3);
  Columns rows(5, size);
  for (Index i = 0; i < size; ++i)
  {
    const conformal::Vector3 x =
      conformal::Vector3(normal(random), normal(random), normal(random)).normalized();
    rows.col(i) << 0.6 * x[0], 0.8 * x[0], x[1], 0.6 * x[2] + 5.0, -0.8 * x[2];
  }
  return rows;
}

SphericalSOMOptions withNeurons(Index number, bool standardize = true)
{
  SphericalSOMOptions options;
  options.NumberOfNeurons = number;
  options.Standardize = standardize;
  return options;
}
}

// Winners, errors, hits and U-matrix, written out from the weight vectors.
TEST(SphericalSOM, ErrorsAreThoseOfTheWeights)
{
  const Columns rows = clusters(700);
  const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(92, false));
  ASSERT_EQ(map.Weights.cols(), 92);
  const conformal::Adjacency neighbors = conformal::vertexNeighbors(map.Network.Triangles, 92);
  double error = 0.0, apart = 0.0;
  std::vector<int> hits(92, 0);
  for (Index i = 0; i < rows.cols(); ++i)
  {
    const Eigen::VectorXd distances = (map.Weights.colwise() - rows.col(i)).colwise().norm();
    std::vector<int> order(92);
    std::iota(order.begin(), order.end(), 0);
    std::sort(
      order.begin(), order.end(), [&](int a, int b) { return distances[a] < distances[b]; });
    EXPECT_EQ(map.Winners[i], order[0]);
    EXPECT_EQ(map.SecondWinners[i], order[1]);
    EXPECT_NEAR(map.Distances[i], distances[order[0]], 1e-9);
    error += distances[order[0]] / 700.0;
    const int* end = neighbors.end(order[0]);
    apart += std::find(neighbors.begin(order[0]), end, order[1]) == end;
    ++hits[order[0]];
  }
  EXPECT_NEAR(map.QuantizationError, error, 1e-9);
  EXPECT_NEAR(map.TopographicError, apart / 700.0, 1e-12);
  EXPECT_EQ(map.Hits, hits);
  double sum = 0.0;
  for (const int* j = neighbors.begin(5); j != neighbors.end(5); ++j)
  {
    sum += (map.Weights.col(5) - map.Weights.col(*j)).norm();
  }
  EXPECT_NEAR(map.UMatrix[5], sum / neighbors.size(5), 1e-9);
}

// A sphere in five dimensions is learned like a surface: every neuron is near the sphere and near
// the neuron that is opposite to the opposite one.
TEST(SphericalSOM, UnfoldsASphereInFiveDimensions)
{
  const Columns rows = sphere(4000);
  const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(162, false));
  Eigen::VectorXd center = Eigen::VectorXd::Zero(5);
  center[3] = 5.0;
  for (Index i = 0; i < map.Weights.cols(); ++i)
  {
    EXPECT_NEAR((map.Weights.col(i) - center).norm(), 0.96, 0.06);
  }
  EXPECT_LT(map.TopographicError, 0.08);
  EXPECT_LT(map.QuantizationError, 0.14); // an edge has 0.28
}

// Neurons between clusters have few hits and large distances to their neighbors.
TEST(SphericalSOM, TheUMatrixSeparatesClusters)
{
  const Columns rows = clusters(2000);
  const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(162));
  std::vector<int> clusterOf(162, -1);
  for (Index i = 0; i < rows.cols(); ++i)
  {
    int& cluster = clusterOf[map.Winners[i]];
    EXPECT_TRUE(cluster == -1 || cluster == i % 4) << "a neuron is the winner of two clusters";
    cluster = static_cast<int>(i % 4);
  }
  double between = 0.0, within = 0.0;
  int numberBetween = 0, numberWithin = 0;
  for (int i = 0; i < 162; ++i)
  {
    (map.Hits[i] == 0 ? between : within) += map.UMatrix[i];
    ++(map.Hits[i] == 0 ? numberBetween : numberWithin);
    ASSERT_GE(map.Rows[i], 0);
    if (map.Hits[i] > 0)
    {
      EXPECT_EQ(map.Winners[map.Rows[i]], i);
    }
  }
  ASSERT_GT(numberBetween, 5);
  EXPECT_GT(between / numberBetween, 1.5 * within / numberWithin);
}

TEST(SphericalSOM, StandardizedColumnsHaveNoUnit)
{
  const Columns rows = clusters(500);
  Columns scaled = rows;
  scaled.row(1) = (1024.0 * scaled.row(1)).eval();
  const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(42)),
                           other = learnSphericalSOM(scaled, withNeurons(42));
  EXPECT_EQ(map.Winners, other.Winners);
  EXPECT_EQ(map.QuantizationError, other.QuantizationError);
  EXPECT_LT((1024.0 * map.Weights.row(1) - other.Weights.row(1)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(SphericalSOM, FewRowsAndColumnsWork)
{
  for (const Index size : { 1, 2, 5 })
  {
    for (const Index dimension : { 1, 2, 3 })
    {
      const Columns rows = clusters(size).topRows(dimension);
      for (const bool standardize : { false, true })
      {
        const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(42, standardize));
        EXPECT_TRUE(map.Weights.allFinite());
        EXPECT_TRUE(std::isfinite(map.QuantizationError));
        EXPECT_EQ(std::accumulate(map.Hits.begin(), map.Hits.end(), 0), size);
      }
    }
  }
  const Columns constant = Columns::Constant(3, 10, 7.0);
  const SphericalSOMResult map = learnSphericalSOM(constant);
  EXPECT_EQ(map.QuantizationError, 0.0);
  EXPECT_EQ(map.Weights, Columns::Constant(3, map.Weights.cols(), 7.0));
  Columns huge = clusters(50) * 1e307;
  EXPECT_TRUE(learnSphericalSOM(huge).Weights.allFinite());
}

TEST(SphericalSOM, TheNumberOfNeuronsFollowsTheRows)
{
  EXPECT_EQ(learnSphericalSOM(clusters(150)).Weights.cols(), 42);   // 5 sqrt(150) = 61
  EXPECT_EQ(learnSphericalSOM(clusters(1000)).Weights.cols(), 162); // 158
}

TEST(SphericalSOM, ThreadsChangeNoBit)
{
  const Columns rows = clusters(3000);
  const SphericalSOMResult map = learnSphericalSOM(rows, withNeurons(362)),
                           other = learnSphericalSOM(rows, withNeurons(362), runs::backwards());
  EXPECT_EQ(map.Weights, other.Weights);
  EXPECT_EQ(map.Winners, other.Winners);
  EXPECT_EQ(map.UMatrix, other.UMatrix);
  SphericalSOMOptions seeded = withNeurons(362);
  seeded.RandomSeed = 2;
  EXPECT_NE(map.Weights, learnSphericalSOM(rows, seeded).Weights);
}

TEST(SphericalSOM, ReportsProgressAndCanBeAborted)
{
  const Columns rows = clusters(2000);
  runs::Watch watch;
  learnSphericalSOM(rows, withNeurons(362), watch.run());
  EXPECT_GE(watch.calls(), 20);
  EXPECT_EQ(watch.last(), 1.0);
  for (const double fraction : { 0.01, 0.3, 0.9 })
  {
    EXPECT_THROW(
      learnSphericalSOM(rows, withNeurons(362), runs::stoppingAt(fraction)), conformal::Aborted);
  }
}

TEST(SphericalSOM, BadInputIsRefused)
{
  EXPECT_THROW(learnSphericalSOM(Columns(3, 0)), std::invalid_argument);
  EXPECT_THROW(learnSphericalSOM(Columns(0, 3)), std::invalid_argument);
  EXPECT_THROW(learnSphericalSOM(clusters(20), withNeurons(11)), std::invalid_argument);
}
