#include "Hull/IndicatorSolid.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using conformal::Index;
using conformal::IndicatorSolid;
using conformal::Pi;
using conformal::Points;
using conformal::PointView;
using conformal::solidByWindingNumbers;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{

Points sphereWhere(const std::function<bool(const Vector3&)>& test)
{
  return spheres::geodesicWhere(24, test);
}

Points sphere()
{
  return sphereWhere([](const Vector3&) { return true; });
}

Points noisy(Points points, double size)
{
  conformal::Random random(1);
  for (Index i = 0; i < points.size(); ++i)
  {
    double sum = -6.0; // of twelve: about Gaussian
    for (int k = 0; k < 12; ++k)
    {
      sum += random.uniform();
    }
    points.data()[i] += size * sum;
  }
  return points;
}

// In the points' own unit.
double volumeOf(const IndicatorSolid& solid, const TrainingSamples& samples)
{
  const auto nodes = static_cast<double>(std::count(solid.Inside.begin(), solid.Inside.end(), 1));
  return nodes * std::pow(solid.Grid.Spacing * samples.scale(), 3);
}
}

TEST(IndicatorSolid, OfASphereIsABall)
{
  const Points points = sphere();
  const TrainingSamples samples{ PointView(points) };
  const IndicatorSolid solid = solidByWindingNumbers(samples, 0.05);
  EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.1);
  EXPECT_EQ(eulerNumber(solid.Grid, solid.Inside), 1);
  EXPECT_EQ(solid.EulerNumber, 1);
  EXPECT_FALSE(solid.NormalsUsed);
}

// The hole is closed by a part of about the sphere: flat, 0.33 of the volume would be missing.
TEST(IndicatorSolid, GoesOnOverAHole)
{
  const Points points = sphereWhere([](const Vector3& x) { return x[2] < 0.6; });
  const TrainingSamples samples{ PointView(points) };
  const IndicatorSolid solid = solidByWindingNumbers(samples, 0.05);
  EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.3);
}

TEST(IndicatorSolid, UsesNormalsThatAgree)
{
  const Points points = sphere();
  for (const double sign : { 1.0, -1.0 })
  {
    const Points normals = sign * points;
    TrainingSamples samples{ PointView(points) };
    samples.setNormals(PointView(normals));
    const IndicatorSolid solid = solidByWindingNumbers(samples, 0.05);
    EXPECT_TRUE(solid.NormalsUsed);
    EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.1);
  }
}

TEST(IndicatorSolid, FindsNormalsInsteadOfUselessOnes)
{
  const Points points = sphere();
  Points normals = points;
  conformal::Random random(1);
  for (Index i = 0; i < normals.rows(); ++i)
  {
    normals.row(i) *= random.uniform() < 0.5 ? -1.0 : 1.0;
  }
  TrainingSamples samples{ PointView(points) };
  samples.setNormals(PointView(normals));
  const IndicatorSolid solid = solidByWindingNumbers(samples, 0.05);
  EXPECT_FALSE(solid.NormalsUsed);
  EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.1);
}

TEST(IndicatorSolid, IsABallInNoise)
{
  const Points points = noisy(conformal::makeGeodesicSphere(40).Positions, 0.04);
  const TrainingSamples samples{ PointView(points) };
  const IndicatorSolid solid = solidByWindingNumbers(samples, 0.03);
  EXPECT_EQ(eulerNumber(solid.Grid, solid.Inside), 1);
  EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.25);
}

TEST(IndicatorSolid, LeavesOutliersOut)
{
  Points points = sphere();
  conformal::Random random(1);
  const Index outliers = points.rows() / 20, size = points.rows();
  points.conservativeResize(size + outliers, 3);
  for (Index i = size; i < points.rows(); ++i)
  {
    points.row(i) =
      2.4 * Vector3(random.uniform(), random.uniform(), random.uniform()) - Vector3::Constant(1.2);
  }
  const TrainingSamples samples{ PointView(points) };
  const IndicatorSolid solid = solidByWindingNumbers(samples, 0.03);
  EXPECT_NEAR(volumeOf(solid, samples), 4.0 / 3.0 * Pi, 0.1);
}

TEST(IndicatorSolid, IsNoneOfAFewPoints)
{
  const Points points = conformal::makeGeodesicSphere(1).Positions;
  EXPECT_TRUE(solidByWindingNumbers(TrainingSamples{ PointView(points) }, 0.05).Inside.empty());
}

TEST(IndicatorSolid, IsTheSameOnAnyNumberOfProcesses)
{
  const Points points = noisy(sphere(), 0.01);
  const IndicatorSolid expected = solidByWindingNumbers(TrainingSamples{ PointView(points) }, 0.05);
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      // The last one has no points.
      const Index middle = points.rows() / 3;
      const Points own = reduce.Rank == 0 ? Points(points.topRows(middle))
        : reduce.Rank == 1                ? Points(points.bottomRows(points.rows() - middle))
                                          : Points(0, 3);
      const TrainingSamples part{ PointView(own), {}, {}, reduce };
      const IndicatorSolid found = solidByWindingNumbers(part, 0.05);
      EXPECT_EQ(found.Inside, expected.Inside);
      EXPECT_EQ(found.Field.Values, expected.Field.Values);
    });
}
