#include "Cloud/Orientation.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using conformal::Aborted;
using conformal::areaVectors;
using conformal::Index;
using conformal::orient;
using conformal::OrientationOptions;
using conformal::Pi;
using conformal::Points;
using conformal::turnOutward;
using conformal::typicalSpacing;
using conformal::Vector3;
using conformal::WindingNumbers;

namespace
{
// Points of a unit sphere for which the test holds.
Points sphereWhere(const std::function<bool(const Vector3&)>& test)
{
  return spheres::geodesicWhere(20, test);
}

Points sphere()
{
  return sphereWhere([](const Vector3&) { return true; });
}

OrientationOptions widths(double first, double last)
{
  OrientationOptions options;
  options.FirstWidth = first;
  options.LastWidth = last;
  return options;
}
}

TEST(Orientation, OfASphereIsOutwardEverywhere)
{
  const Points points = sphere();
  const Points areas = orient(WindingNumbers(points), widths(0.15, 0.04));
  double sum = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 n = areas.row(i);
    EXPECT_GT(n.normalized().dot(points.row(i)), std::cos(0.2));
    sum += n.norm();
  }
  EXPECT_NEAR(sum, 4.0 * Pi, 1.0);
}

// A hole as wide as the sphere's radius: the rest says what is inside.
TEST(Orientation, IsOutwardAroundAHole)
{
  const Points points = sphereWhere([](const Vector3& x) { return x[2] < 0.8; });
  const Points areas = orient(WindingNumbers(points), widths(0.15, 0.04));
  for (Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_GT(Vector3(areas.row(i)).normalized().dot(points.row(i)), 0.5) << points.row(i);
  }
}

// The walls of a cup face away from each other.
TEST(Orientation, TellsTheSidesOfAThinWall)
{
  const Points outer = sphereWhere([](const Vector3& x) { return x[2] < 0.0; });
  Points points(2 * outer.rows(), 3);
  points << outer, 0.85 * outer;
  const Points areas = orient(WindingNumbers(points), widths(0.12, 0.03));
  Index right = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    right += (areas.row(i).dot(points.row(i)) > 0.0) == (i < outer.rows());
  }
  EXPECT_GT(right, 0.97 * static_cast<double>(points.rows()));
}

TEST(Orientation, ReportsAndStops)
{
  const WindingNumbers cloud(sphere());
  runs::Watch watch;
  orient(cloud, {}, watch.run());
  EXPECT_EQ(watch.calls(), 20);
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_THROW(orient(cloud, {}, runs::stoppingAt(0.0)), Aborted);
}

TEST(Orientation, AreasAddUpToThatOfTheSurface)
{
  const Points points = sphere();
  const Points areas = areaVectors(points, points);
  // Circles around the nodes of a hexagonal grid, through the neighbors' neighbors, are 1.36 of it.
  EXPECT_NEAR(areas.rowwise().norm().sum(), 1.36 * 4.0 * Pi, 0.1 * 4.0 * Pi);
  EXPECT_TRUE(areaVectors(points, Points::Zero(points.rows(), 3)).isZero());
}

TEST(Orientation, TurnsNormalsThatAgree)
{
  const Points points = sphere(), right = areaVectors(points, points);
  const WindingNumbers cloud(points);
  Points areas = right;
  EXPECT_TRUE(turnOutward(cloud, areas, 0.05));
  EXPECT_EQ(areas, right);
  areas = -right;
  EXPECT_TRUE(turnOutward(cloud, areas, 0.05));
  EXPECT_EQ(areas, right);
}

// As normals of planes fitted to neighbors are.
TEST(Orientation, RefusesNormalsOfRandomSigns)
{
  const Points points = sphere();
  const WindingNumbers cloud(points);
  Points areas = areaVectors(points, points);
  conformal::Random random(1);
  for (Index i = 0; i < areas.rows(); ++i)
  {
    areas.row(i) *= random.uniform() < 0.5 ? -1.0 : 1.0;
  }
  EXPECT_FALSE(turnOutward(cloud, areas, 0.05));
  Points none = Points::Zero(points.rows(), 3);
  EXPECT_FALSE(turnOutward(cloud, none, 0.05));
  Points empty(0, 3);
  EXPECT_FALSE(turnOutward(WindingNumbers(empty), empty, 0.05));
}

// As those of one of several scans can be.
TEST(Orientation, RefusesNormalsOfWhichAPartIsInward)
{
  Points points = sphere(), normals = points;
  Index reversed = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const bool isReversed = points(i, 0) > 0.68;
    reversed += isReversed;
    normals.row(i) *= isReversed ? -1.0 : 1.0;
    normals(i, 0) /= 6.0;
    normals.row(i).normalize();
  }
  points.col(0) *= 6.0;
  ASSERT_NEAR(static_cast<double>(reversed) / static_cast<double>(points.rows()), 0.16, 0.02);
  Points areas = areaVectors(points, normals);
  EXPECT_FALSE(turnOutward(WindingNumbers(points), areas, 0.05));
}

TEST(Orientation, KnowsTheSpacing)
{
  Points square(400, 3);
  for (Index i = 0; i < square.rows(); ++i)
  {
    square.row(i) << 0.1 * static_cast<double>(i % 20), 0.1 * static_cast<double>(i / 20), 0.0;
  }
  EXPECT_NEAR(typicalSpacing(square), 0.1, 0.015);
  EXPECT_EQ(typicalSpacing(square.topRows(1)), 0.0);
  EXPECT_EQ(typicalSpacing(Points(0, 3)), 0.0);
}

TEST(Orientation, KnowsTheNoise)
{
  const Points clean = conformal::makeGeodesicSphere(30).Positions;
  EXPECT_LT(conformal::noiseOf(clean, clean).Deviation, 0.001);
  for (const double deviation : { 0.005, 0.01, 0.02 })
  {
    Points points = clean;
    conformal::Random random(1);
    for (Index i = 0; i < points.rows(); ++i)
    {
      double sum = -6.0; // of twelve: about Gaussian
      for (int k = 0; k < 12; ++k)
      {
        sum += random.uniform();
      }
      points.row(i) *= 1.0 + deviation * sum;
    }
    const conformal::PointNoise noise = conformal::noiseOf(points, clean);
    EXPECT_NEAR(noise.Deviation, deviation, 0.2 * deviation);
    // Outliers stand out.
    points.row(100) *= 1.2;
    EXPECT_NEAR(conformal::noiseOf(points, clean).Offsets[100], -0.2, 0.06);
  }
  const Points few = clean.topRows(10);
  EXPECT_EQ(conformal::noiseOf(few, few).Deviation, 0.0);
  EXPECT_TRUE(conformal::noiseOf(few, few).Offsets.isZero());
}

// A thin wall's other side is no noise.
TEST(Orientation, KnowsAThinWallFromNoise)
{
  const Points outer = conformal::makeGeodesicSphere(30).Positions;
  Points points(2 * outer.rows(), 3), areas(2 * outer.rows(), 3);
  points << outer, 0.99 * outer;
  areas << outer, -outer;
  EXPECT_LT(conformal::noiseOf(points, areas).Deviation, 0.001);
}

// Half of the sphere has a hundredth of the points of the other, each of which stands for a hundred
// times the area: the winding number is as near to 1 behind it.
TEST(Orientation, WeighsPointsOfSparseParts)
{
  const Points points = spheres::random(20000, true);
  const WindingNumbers numbers(points);
  const Points areas = orient(numbers, widths(0.08, 0.02));
  const Points within = 0.75 * sphere();
  const Eigen::VectorXd found = numbers.at(within, numbers.sources(areas), 0.02);
  double sum[2] = { 0.0, 0.0 };
  int count[2] = { 0, 0 };
  for (Index i = 0; i < within.rows(); ++i)
  {
    const bool sparse = within(i, 0) < -0.25;
    if (sparse || within(i, 0) > 0.25)
    {
      sum[sparse] += found[i];
      ++count[sparse];
    }
  }
  EXPECT_NEAR(sum[0] / count[0], 1.0, 0.2);
  EXPECT_NEAR(sum[1] / count[1], 1.0, 0.2); // 0.4 where all count alike
}
