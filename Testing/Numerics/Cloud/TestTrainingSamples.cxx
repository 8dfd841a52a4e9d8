#include "Cloud/TrainingSamples.h"

#include "Base/Random.h"
#include "Ranks.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using conformal::Index;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
Points cloud(Index size)
{
  conformal::Random random(5);
  Points points(size, 3);
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] = random.uniform() * (1.0 + i % 3);
  }
  return points;
}
}

TEST(TrainingSamples, CentroidIsZeroAndMaximumRadiusOne)
{
  const Points points = cloud(3000);
  const TrainingSamples samples(points);
  ASSERT_EQ(samples.size(), 3000);
  Vector3 mean = Vector3::Zero();
  double radius = 0.0;
  for (Index i = 0; i < samples.size(); ++i)
  {
    mean += samples[i] / samples.size();
    radius = std::max(radius, samples[i].norm());
    EXPECT_LT((samples.restore(samples[i]) - Vector3(points.row(i))).norm(), 1e-14);
  }
  EXPECT_LT(mean.norm(), 1e-14);
  EXPECT_NEAR(radius, 1.0, 1e-14);
  EXPECT_EQ(samples.dimension(), 3);
}

TEST(TrainingSamples, FloatsAreReadInPlace)
{
  const Points points = cloud(100);
  const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> floats = points.cast<float>();
  const Points rounded = floats.cast<double>();
  const TrainingSamples a(PointView(floats.data(), 100)), b(rounded);
  for (Index i = 0; i < 100; ++i)
  {
    EXPECT_EQ(a[i], b[i]);
  }
}

TEST(TrainingSamples, PowersOfTwoChangeNoBit)
{
  const Points points = cloud(500);
  const TrainingSamples samples(points);
  for (int power : { -100, -7, 1, 60, 400 })
  {
    const double factor = std::ldexp(1.0, power);
    const Points scaled = factor * points;
    const TrainingSamples other(scaled);
    EXPECT_EQ(other.scale(), factor * samples.scale());
    for (Index i = 0; i < samples.size(); ++i)
    {
      EXPECT_EQ(other[i], samples[i]);
    }
  }
}

TEST(TrainingSamples, ExtremeUnitsStayFinite)
{
  for (double unit : { 1e-300, 1e-30, 1e30, 1e300 })
  {
    const Points points = unit * cloud(50);
    const TrainingSamples samples(points);
    EXPECT_EQ(samples.dimension(), 3) << unit;
    for (Index i = 0; i < samples.size(); ++i)
    {
      EXPECT_TRUE(samples[i].allFinite()) << unit;
      EXPECT_LE(samples[i].norm(), 1.0 + 1e-12) << unit;
    }
  }
}

TEST(TrainingSamples, DetailFarFromTheOriginIsKept)
{
  const Points points = 1e-3 * cloud(500);
  const Points far = points.rowwise() + Eigen::RowVector3d(1e7, -1e7, 1e7);
  Points shifted = far.rowwise() - Eigen::RowVector3d(1e7, -1e7, 1e7); // as rounded far away
  const TrainingSamples a(shifted), b(far);
  for (Index i = 0; i < 500; ++i)
  {
    EXPECT_LT((a[i] - b[i]).norm(), 1e-5); // of 1e-3, coordinates near 1e7 keep 1e-9
    EXPECT_LT((b.restore(b[i]) - Vector3(far.row(i))).norm(), 4e-9);
  }
}

TEST(TrainingSamples, LeavesOutWhatIsNotFiniteSkippedOrOfNoWeight)
{
  Points points = cloud(10);
  points(2, 1) = std::numeric_limits<double>::quiet_NaN();
  points(7, 0) = std::numeric_limits<double>::infinity();
  std::vector<double> weights(10, 4.0);
  weights[3] = 0.0;
  weights[5] = 1.0;
  const TrainingSamples samples(points, weights, [](Index i) { return i == 9; });
  EXPECT_EQ(samples.numberOfNonFinite(), 2);
  ASSERT_EQ(samples.size(), 6); // 0 1 4 5 6 8
  EXPECT_EQ(samples.weight(3), 0.25);
  EXPECT_EQ(samples.weight(4), 1.0);
  EXPECT_LT((samples.restore(samples[3]) - Vector3(points.row(5))).norm(), 1e-15);
  const std::vector<double> few = { 1.0, 2.0 };
  EXPECT_THROW(TrainingSamples(points, few), std::invalid_argument);
}

TEST(TrainingSamples, SelectedSamplesKeepTheirCoordinates)
{
  const Points points = cloud(100);
  std::vector<double> weights(points.rows(), 1.0);
  weights[2] = 0.0; // left out, so that sample 2 is point 3
  const TrainingSamples all(points, weights);
  const auto isThird = [](Index i) { return i % 3 == 2; };
  const TrainingSamples thirds = all.selected(isThird);
  const TrainingSamples others = all.selected([&](Index i) { return !isThird(i); });
  ASSERT_EQ(all.size(), 99);
  ASSERT_EQ(thirds.totalSize(), 33);
  ASSERT_EQ(others.totalSize(), 66);
  EXPECT_EQ(thirds.restore(thirds[0]), all.restore(all[2]));
  for (Index i = 0; i < thirds.size(); ++i)
  {
    EXPECT_EQ(thirds[i], all[3 * i + 2]);
    EXPECT_EQ(others[2 * i], all[3 * i]);
    EXPECT_EQ(others[2 * i + 1], all[3 * i + 1]);
  }
  ranks::run(2,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = 50 * reduce.Rank;
      const Points own = points.middleRows(first, 50);
      const std::vector<double> share(weights.begin() + first, weights.begin() + first + 50);
      const TrainingSamples part = TrainingSamples(own, share, {}, reduce).selected(isThird);
      EXPECT_EQ(part.totalSize(), 33);
      for (Index i = 0; i < part.size(); ++i)
      {
        EXPECT_EQ(part[i], thirds[part.firstOfTotal() + i]);
      }
    });
}

TEST(TrainingSamples, DimensionTellsFlatClouds)
{
  Points points = cloud(100);
  points.col(2) = 2.0 * points.col(0) - points.col(1);
  EXPECT_EQ(TrainingSamples(points).dimension(), 2);
  points.col(1) = 3.0 * points.col(0);
  points.col(2) = points.col(0);
  EXPECT_EQ(TrainingSamples(points).dimension(), 1);
  points.rowwise() = Eigen::RowVector3d(4, 5, 6);
  EXPECT_EQ(TrainingSamples(points).dimension(), 0);
  EXPECT_EQ(TrainingSamples(Points(0, 3)).dimension(), 0);
  EXPECT_TRUE(TrainingSamples(Points(0, 3)).empty());
}

TEST(TrainingSamples, ThreadsChangeNoBit)
{
  const Points points = cloud(200000);
  const TrainingSamples a(points), b(points, {}, {}, {}, runs::backwards());
  for (Index i = 0; i < points.rows(); i += 97)
  {
    EXPECT_EQ(a[i], b[i]);
  }
}
