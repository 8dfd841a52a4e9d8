#include "Cloud/CloudThinning.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using conformal::Index;
using conformal::OrientedPoints;
using conformal::Points;
using conformal::PointView;
using conformal::selectSamples;
using conformal::thin;
using conformal::TrainingSamples;
using conformal::Vector3;
using conformal::without;

namespace
{
OrientedPoints sphere(int frequency)
{
  const Points points = conformal::makeGeodesicSphere(frequency).Positions;
  return { points, points };
}
}

TEST(CloudThinning, SelectsAllOrAboutAsManyAsAsked)
{
  const Points points = sphere(30).Positions;
  const TrainingSamples samples{ PointView(points) };
  const OrientedPoints all = selectSamples(samples, 1e6);
  ASSERT_EQ(all.Positions.rows(), points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_EQ(Vector3(all.Positions.row(i)), samples[i]);
  }
  EXPECT_EQ(all.Normals.rows(), 0);
  EXPECT_NEAR(static_cast<double>(selectSamples(samples, 900).Positions.rows()), 900.0, 50.0);
}

TEST(CloudThinning, SelectsTheSameOnAllProcesses)
{
  const Points points = sphere(20).Positions, normals = 3.0 * points;
  TrainingSamples samples{ PointView(points) };
  samples.setNormals(PointView(normals));
  const OrientedPoints expected = selectSamples(samples, 700);
  EXPECT_NEAR(expected.Normals.row(5).norm(), 1.0, 1e-12);
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = points.rows() * reduce.Rank / 3;
      const Index last = points.rows() * (reduce.Rank + 1) / 3;
      const Points own = points.middleRows(first, last - first);
      const Points ownNormals = normals.middleRows(first, last - first);
      TrainingSamples part{ PointView(own), {}, {}, reduce };
      part.setNormals(PointView(ownNormals));
      const OrientedPoints found = selectSamples(part, 700);
      EXPECT_EQ(found.Positions, expected.Positions);
      EXPECT_EQ(found.Normals, expected.Normals);
    });
}

TEST(CloudThinning, KnowsNoNormalWhereItIsNoDirection)
{
  const Points points = sphere(2).Positions;
  Points normals = points;
  normals.row(3).setZero();
  normals.row(4).setConstant(std::numeric_limits<double>::quiet_NaN());
  TrainingSamples samples{ PointView(points) };
  samples.setNormals(PointView(normals));
  const OrientedPoints found = selectSamples(samples, 1e6);
  EXPECT_TRUE(found.Normals.row(3).isZero());
  EXPECT_TRUE(found.Normals.row(4).isZero());
  EXPECT_TRUE(found.Normals.row(5).isApprox(points.row(5)));
  const Points few = points.topRows(3);
  EXPECT_THROW(samples.setNormals(PointView(few)), std::invalid_argument);
}

TEST(CloudThinning, LeavesAboutAsManyAsAsked)
{
  const OrientedPoints dense = sphere(60);
  for (const Index count : { 100, 1000, 10000 })
  {
    const OrientedPoints thinned = thin(dense, count);
    EXPECT_LE(thinned.Positions.rows(), count);
    EXPECT_GE(thinned.Positions.rows(), 0.9 * static_cast<double>(count));
    ASSERT_EQ(thinned.Normals.rows(), thinned.Positions.rows());
    for (Index i = 0; i < thinned.Positions.rows(); ++i)
    {
      const Vector3 x = thinned.Positions.row(i), n = thinned.Normals.row(i);
      EXPECT_LE(x.norm(), 1.0 + 1e-12); // means
      EXPECT_NEAR(n.norm(), 1.0, 1e-12);
      EXPECT_GT(n.dot(x.normalized()), 0.99);
    }
  }
  EXPECT_EQ(thin(dense, dense.Positions.rows()).Positions, dense.Positions);
}

// A half a hundred times as dense as the other.
TEST(CloudThinning, EvensOutDensity)
{
  conformal::Random random(1);
  OrientedPoints cloud;
  cloud.Positions = Points::Zero(20200, 3);
  for (Index i = 0; i < cloud.Positions.rows(); ++i)
  {
    cloud.Positions.row(i) << random.uniform() + (i < 200 ? 0.0 : 1.0), random.uniform(), 0.0;
  }
  const OrientedPoints thinned = thin(cloud, 200);
  Index left = 0;
  for (Index i = 0; i < thinned.Positions.rows(); ++i)
  {
    left += thinned.Positions(i, 0) < 1.0;
  }
  EXPECT_GT(left, thinned.Positions.rows() / 3);
  EXPECT_LT(left, thinned.Positions.rows() * 2 / 3);
}

TEST(CloudThinning, AveragesNoise)
{
  conformal::Random random(1);
  OrientedPoints cloud = sphere(60);
  for (Index i = 0; i < cloud.Positions.rows(); ++i)
  {
    cloud.Positions.row(i) *= 1.0 + 0.01 * (random.uniform() - 0.5);
  }
  const auto spread = [](const Points& points)
  { return (points.rowwise().norm().array() - points.rowwise().norm().mean()).square().mean(); };
  EXPECT_LT(spread(thin(cloud, 2000).Positions), 0.3 * spread(cloud.Positions));
}

TEST(CloudThinning, TakesAnyPoints)
{
  OrientedPoints same;
  same.Positions = Points::Ones(50, 3);
  EXPECT_EQ(thin(same, 5).Positions.rows(), 50); // nothing tells them apart
  EXPECT_EQ(thin({ Points(0, 3), Points(0, 3) }, 5).Positions.rows(), 0);
}

TEST(CloudThinning, LeavesMarkedPointsOut)
{
  const OrientedPoints cloud = sphere(1);
  std::vector<std::uint8_t> marks(12, 0);
  marks[0] = marks[7] = 1;
  const OrientedPoints rest = without(cloud, marks);
  ASSERT_EQ(rest.Positions.rows(), 10);
  EXPECT_EQ(rest.Positions.row(0), cloud.Positions.row(1));
  EXPECT_EQ(rest.Normals.row(6), cloud.Normals.row(8));
}
