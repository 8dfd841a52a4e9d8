#include "Sphere/AdaptiveSphere.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using conformal::AdaptiveSphereOptions;
using conformal::Index;
using conformal::makeAdaptiveSphere;
using conformal::Mesh;
using conformal::SphereDensity;
using conformal::Vector3;

namespace
{
SphereDensity densityOf(const std::function<double(const Vector3&)>& function, int frequency = 60)
{
  SphereDensity density;
  density.At = function;
  density.Directions = conformal::makeGeodesicSphere(frequency).Positions;
  density.Areas.assign(density.Directions.rows(), 1.0);
  return density;
}

double even(const Vector3&)
{
  return 1.0;
}

/// Hard ones: jumps by 1000 along a circle, along curves that cross, around a small spot, and to 0.
std::vector<SphereDensity> jumps()
{
  const Vector3 spot = Vector3(1.0, 2.0, 3.0).normalized();
  return { densityOf([](const Vector3& p) { return p[2] > 0.3 ? 1000.0 : 1.0; }),
    densityOf([](const Vector3& p)
      { return std::sin(9.0 * p[0]) * std::sin(9.0 * p[1]) > 0.0 ? 1e3 : 1.0; }),
    densityOf([=](const Vector3& p) { return (p - spot).norm() < 0.03 ? 1000.0 : 1.0; }),
    densityOf([=](const Vector3& p) { return (p - spot).norm() < 0.03 ? 1.0 : 0.0; }) };
}

/// Of all corners, in degrees.
double minimumAngle(const Mesh& mesh)
{
  double smallest = 180.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 o = mesh.Positions.row(mesh.Triangles(r, k));
      const Vector3 u = mesh.Positions.row(mesh.Triangles(r, (k + 1) % 3)).transpose() - o;
      const Vector3 v = mesh.Positions.row(mesh.Triangles(r, (k + 2) % 3)).transpose() - o;
      smallest =
        std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::acos(-1.0));
    }
  }
  return smallest;
}

void expectSphere(const Mesh& mesh, Index wanted)
{
  EXPECT_NEAR(static_cast<double>(mesh.Positions.rows()), wanted, 0.02 * wanted);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    ASSERT_NEAR(mesh.Positions.row(i).norm(), 1.0, 1e-15);
  }
  std::set<std::pair<int, int>> directed;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_TRUE(directed.emplace(mesh.Triangles(r, k), mesh.Triangles(r, (k + 1) % 3)).second);
    }
  }
  for (const auto& [from, to] : directed)
  {
    ASSERT_TRUE(directed.count({ to, from }));
  }
  EXPECT_EQ(
    mesh.Positions.rows() - static_cast<Index>(directed.size()) / 2 + mesh.Triangles.rows(), 2);
  EXPECT_EQ(conformal::countFlippedTriangles(mesh.Positions, mesh.Triangles), 0);
  double solidAngle = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0)),
                  b = mesh.Positions.row(mesh.Triangles(r, 1)),
                  c = mesh.Positions.row(mesh.Triangles(r, 2));
    solidAngle += 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  EXPECT_NEAR(solidAngle, 4.0 * std::acos(-1.0), 1e-9);
  EXPECT_GE(minimumAngle(mesh), conformal::AdaptiveSphereLimits::MinimumAngle - 1e-6);
}

/// Share of the points where a test is true.
double share(const Mesh& mesh, const std::function<bool(const Vector3&)>& test)
{
  Index count = 0;
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    count += test(mesh.Positions.row(i));
  }
  return static_cast<double>(count) / static_cast<double>(mesh.Positions.rows());
}

Mesh made(const SphereDensity& density, Index size, const conformal::Run& run = {})
{
  AdaptiveSphereOptions options;
  options.NumberOfPoints = size;
  return makeAdaptiveSphere(density, options, run);
}
}

TEST(AdaptiveSphere, OfEvenDensityHasEdgesOfOneLength)
{
  const Mesh mesh = made(densityOf(even), 10000);
  expectSphere(mesh, 10000);
  // Of equilateral triangles of the same area.
  const double length = std::sqrt(
    4.0 * 4.0 * std::acos(-1.0) / static_cast<double>(mesh.Triangles.rows()) / std::sqrt(3.0));
  double squares = 0.0, longest = 0.0, shortest = 2.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const double ratio =
      (mesh.Positions.row(mesh.Triangles(r, 0)) - mesh.Positions.row(mesh.Triangles(r, 1))).norm() /
      length;
    squares += (ratio - 1.0) * (ratio - 1.0);
    longest = std::max(longest, ratio);
    shortest = std::min(shortest, ratio);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(mesh.Triangles.rows())), 0.2);
  EXPECT_LT(longest, 2.0);
  EXPECT_GT(shortest, 0.5);
  // No part of the sphere has more than its share: in the halves of each axis.
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(share(mesh, [=](const Vector3& p) { return p[axis] > 0.0; }), 0.5, 0.01);
  }
}

TEST(AdaptiveSphere, PointsAreInProportionToTheDensity)
{
  // From 1 to 100, with a known integral: exp(c z) over z in [-1, 1].
  const double c = 0.5 * std::log(100.0);
  const Mesh mesh = made(densityOf([=](const Vector3& p) { return std::exp(c * p[2]); }), 20000);
  expectSphere(mesh, 20000);
  for (const double z : { -0.5, 0.0, 0.5, 0.8 })
  {
    const double expected = (std::exp(c) - std::exp(c * z)) / (std::exp(c) - std::exp(-c));
    EXPECT_NEAR(share(mesh, [=](const Vector3& p) { return p[2] > z; }), expected, 0.02) << z;
  }
}

// Neither a jump nor a crossing of jumps gives a needle.
TEST(AdaptiveSphere, AnglesKeepTheirBoundWhateverTheDensity)
{
  for (const SphereDensity& density : jumps())
  {
    for (const Index size : { Index(500), Index(777), Index(1234), Index(20000) })
    {
      expectSphere(made(density, size), size);
    }
  }
  AdaptiveSphereOptions rough;
  rough.NumberOfPoints = 3000;
  rough.SmoothingRounds = 0;
  expectSphere(makeAdaptiveSphere(jumps()[1], rough), 3000);
}

// Between the points of a coarse mesh, where only its own points were asked.
TEST(AdaptiveSphere, NoSmallSpotIsMissed)
{
  const Vector3 spot = Vector3(-3.0, 1.0, 2.0).normalized();
  const auto isInside = [=](const Vector3& p) { return (p - spot).norm() < 0.004; };
  // Of 4 millionths of the sphere, but half of the points.
  const SphereDensity density =
    densityOf([=](const Vector3& p) { return isInside(p) ? 250000.0 : 1.0; }, 300);
  const Mesh mesh = made(density, 10000);
  expectSphere(mesh, 10000);
  EXPECT_GT(share(mesh, isInside), 0.3);
}

TEST(AdaptiveSphere, EndsWhereTrianglesAreTooSmallToBeDivided)
{
  const Vector3 pole = Vector3(1.0, 1.0, 1.0).normalized();
  const Mesh mesh = made(
    densityOf([=](const Vector3& p) { return 1.0 / ((p - pole).squaredNorm() + 1e-30); }), 3000);
  expectSphere(mesh, 3000);
}

TEST(AdaptiveSphere, UnitsOfTheDensityDoNotCount)
{
  const auto density = [](double unit)
  { return densityOf([=](const Vector3& p) { return unit * (1.1 + p[1]); }); };
  const Mesh mesh = made(density(1.0), 2000);
  EXPECT_EQ(made(density(0x1p-300), 2000).Positions, mesh.Positions);
  EXPECT_EQ(made(density(0x1p300), 2000).Positions, mesh.Positions);
}

TEST(AdaptiveSphere, ThreadsChangeNoBit)
{
  const Mesh alone = made(jumps()[0], 5000), both = made(jumps()[0], 5000, runs::backwards());
  EXPECT_EQ(alone.Positions, both.Positions);
  EXPECT_EQ(alone.Triangles, both.Triangles);
}

TEST(AdaptiveSphere, ReportsAndStops)
{
  runs::Watch watch;
  makeAdaptiveSphere(densityOf(even), {}, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GT(watch.calls(), 50);
  for (const double last : { 0.0, 0.3, 0.9 })
  {
    EXPECT_THROW(
      makeAdaptiveSphere(densityOf(even), {}, runs::stoppingAt(last)), conformal::Aborted);
  }
}

TEST(AdaptiveSphere, SaysWhatItCannotDo)
{
  AdaptiveSphereOptions options;
  options.NumberOfPoints = 499;
  EXPECT_THROW(makeAdaptiveSphere(densityOf(even), options), std::invalid_argument);
  options.NumberOfPoints = conformal::AdaptiveSphereLimits::MaximumPoints + 1;
  EXPECT_THROW(makeAdaptiveSphere(densityOf(even), options), std::invalid_argument);
  options.NumberOfPoints = 500;
  options.SmoothingRounds = -1;
  EXPECT_THROW(makeAdaptiveSphere(densityOf(even), options), std::invalid_argument);
  EXPECT_THROW(
    makeAdaptiveSphere(densityOf([](const Vector3&) { return 0.0; })), std::invalid_argument);
  EXPECT_THROW(
    makeAdaptiveSphere(densityOf([](const Vector3& p) { return p[0]; })), std::invalid_argument);
  EXPECT_THROW(makeAdaptiveSphere(densityOf([](const Vector3& p) { return 1.0 / (p[2] - p[2]); })),
    std::invalid_argument);
  EXPECT_THROW(makeAdaptiveSphere({}), std::invalid_argument);
}
