#include "SphereMap/ProgressiveSphereMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"
#include "Measure/Distortion.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

using conformal::Index;
using conformal::mapToSphere;
using conformal::Points;
using conformal::ProgressiveSphereMapOptions;
using conformal::ProgressiveSphereMapResult;
using conformal::Vector3;
using spheres::shaped;

namespace
{
conformal::Mesh limb(double length)
{
  return shaped(12, [length](const Vector3& n) { return Vector3(n[0], n[1], length * n[2]); });
}

void expectOneToOne(const conformal::Mesh& mesh, const ProgressiveSphereMapResult& map)
{
  ASSERT_EQ(map.Positions.rows(), mesh.Positions.rows());
  EXPECT_EQ(map.NumberOfFlippedTriangles, 0);
  double solidAngle = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = map.Positions.row(mesh.Triangles(r, 0)),
                  b = map.Positions.row(mesh.Triangles(r, 1)),
                  c = map.Positions.row(mesh.Triangles(r, 2));
    const double volume = (b - a).cross(c - a).dot(a);
    EXPECT_GT(volume, 0.0);
    solidAngle += 2.0 * std::atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  EXPECT_NEAR(solidAngle, 4.0 * std::acos(-1.0), 1e-9);
  EXPECT_LT((map.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
}
}

TEST(ProgressiveSphereMap, CoversTheSphereOnceWithoutFolds)
{
  const auto spikes = shaped(10,
    [](const Vector3& n)
    { return Vector3(n * (1.0 + 2.0 * std::pow(std::abs(n[0] * n[1] * n[2]) * 5.19, 6.0))); });
  conformal::Random random(1);
  const auto rough =
    shaped(10, [&](const Vector3& n) { return Vector3(n * (1.0 + 0.3 * random.uniform())); });
  for (const auto& mesh : { limb(1.0), limb(0.05), limb(12.0), limb(60.0), spikes, rough,
         conformal::makeGeodesicSphere(1) })
  {
    expectOneToOne(mesh, mapToSphere(mesh));
  }
}

// Triangles of no height, and points in one place.
TEST(ProgressiveSphereMap, DegenerateTrianglesDoNotFold)
{
  auto mesh = limb(1.0);
  for (int k = 0; k < 3; ++k)
  {
    mesh.Positions.row(mesh.Triangles(7, k)) = mesh.Positions.row(mesh.Triangles(7, 0));
    mesh.Positions.row(mesh.Triangles(500, k))[2] = 0.3;
    mesh.Positions.row(mesh.Triangles(500, k))[1] = 0.2;
  }
  expectOneToOne(mesh, mapToSphere(mesh));
}

TEST(ProgressiveSphereMap, ASphereIsMappedNearlyWithoutDistortion)
{
  const auto sphere = limb(1.0);
  const auto map = mapToSphere(sphere);
  expectOneToOne(sphere, map);
  const auto distortion =
    conformal::measureDistortion(sphere.Positions, sphere.Triangles, map.Positions);
  EXPECT_LT(distortion.MeanQuasiConformalError, 1.1);
  EXPECT_LT(distortion.AreaDistortionDeviation, 0.2);
}

TEST(ProgressiveSphereMap, BalanceTradesAnglesForAreas)
{
  const auto mesh = limb(4.0);
  double lastArea = std::numeric_limits<double>::infinity(), lastAngle = 0.0;
  for (double balance : { 0.0, 0.3, 0.6, 1.0 })
  {
    ProgressiveSphereMapOptions options;
    options.AreaBalance = balance;
    const auto map = mapToSphere(mesh, options);
    expectOneToOne(mesh, map);
    const auto distortion =
      conformal::measureDistortion(mesh.Positions, mesh.Triangles, map.Positions);
    EXPECT_LT(distortion.AreaDistortionDeviation, lastArea);
    EXPECT_GT(distortion.MeanQuasiConformalError, lastAngle);
    lastArea = distortion.AreaDistortionDeviation;
    lastAngle = distortion.MeanQuasiConformalError;
  }
}

// Closed and of Euler number 2, but there is nothing inside.
TEST(ProgressiveSphereMap, TwoTrianglesBackToBackHaveNoMap)
{
  conformal::Mesh flat;
  flat.Positions.resize(3, 3);
  flat.Positions << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  flat.Triangles.resize(2, 3);
  flat.Triangles << 0, 1, 2, 0, 2, 1;
  EXPECT_THROW(mapToSphere(flat), conformal::NumericalFailure);
}

TEST(ProgressiveSphereMap, RefusesWhatItCannotMap)
{
  const auto mesh = limb(1.0);
  const conformal::Triangles open = mesh.Triangles.bottomRows(mesh.Triangles.rows() - 1);
  EXPECT_THROW(mapToSphere({ mesh.Positions, open }), std::invalid_argument);
  Points bad = mesh.Positions;
  bad(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mapToSphere({ bad, mesh.Triangles }), std::invalid_argument);
  for (double balance : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    ProgressiveSphereMapOptions options;
    options.AreaBalance = balance;
    EXPECT_THROW(mapToSphere(mesh, options), std::invalid_argument);
  }
}

TEST(ProgressiveSphereMap, ReportsProgressAndStops)
{
  const auto mesh = limb(2.0);
  runs::Watch watch;
  mapToSphere(mesh, {}, watch.run());
  EXPECT_GT(watch.calls(), 5);
  EXPECT_THROW(mapToSphere(mesh, {}, runs::stoppingAt(0.5)), conformal::Aborted);
}

// The sweeps after the descent need a large part of the time.
TEST(ProgressiveSphereMap, ReportsTheSweepsOfAMinimum)
{
  ProgressiveSphereMapOptions options;
  options.Finish = conformal::SphereMapFinish::Minimum;
  runs::Watch watch;
  mapToSphere(limb(2.0), options, watch.run());
  const auto& fractions = watch.fractions();
  const auto sweeps = std::count_if(
    fractions.begin(), fractions.end(), [](double done) { return done > 0.7 && done < 1.0; });
  EXPECT_GT(sweeps, 5);
  EXPECT_THROW(mapToSphere(limb(2.0), options, runs::stoppingAt(0.9)), conformal::Aborted);
}

namespace
{
// Two poles, and a triangle from each edge of the equator to each pole.
conformal::Mesh bipyramid(int corners)
{
  conformal::Mesh mesh;
  mesh.Positions.resize(corners + 2, 3);
  mesh.Triangles.resize(2 * corners, 3);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * conformal::Pi * i / corners;
    const int next = (i + 1) % corners;
    mesh.Positions.row(i) << std::cos(angle), std::sin(angle), 0.0;
    mesh.Triangles.row(i) << i, next, corners;
    mesh.Triangles.row(corners + i) << next, i, corners + 1;
  }
  mesh.Positions.row(corners) << 0.0, 0.0, 1.0;
  mesh.Positions.row(corners + 1) << 0.0, 0.0, -1.0;
  return mesh;
}

double secondsToMap(const conformal::Mesh& mesh)
{
  const std::clock_t start = std::clock();
  EXPECT_EQ(mapToSphere(mesh).NumberOfFlippedTriangles, 0);
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}
}

// The time would grow with the square if each insertion moved the poles.
TEST(ProgressiveSphereMap, HubsAreMappedInLinearTime)
{
  EXPECT_LT(secondsToMap(bipyramid(6000)), 8.0 * secondsToMap(bipyramid(1500)) + 0.1);
}
