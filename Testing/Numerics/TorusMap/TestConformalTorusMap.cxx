#include "TorusMap/ConformalTorusMap.h"

#include "HandleMeshes.h"
#include "Runs.h"
#include "Tori.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

using conformal::ConformalTorusMapResult;
using conformal::Index;
using conformal::mapToTorus;
using conformal::Mesh;
using conformal::Vector3;

namespace
{
Mesh revolution(double radius, int along, int around)
{
  return tori::gridTorus(
    along, around, [=](double s, double t) { return tori::onRevolution(radius, s, t); });
}

// Difference of two fractions of a period, in [-1/2, 1/2].
double periodic(double difference)
{
  return difference - std::round(difference);
}

void expectValid(const ConformalTorusMapResult& map)
{
  EXPECT_EQ(map.NumberOfFlippedTriangles, 0);
  EXPECT_GE(map.Positions.minCoeff(), 0.0);
  EXPECT_LT(map.Positions.maxCoeff(), 1.0);
  EXPECT_TRUE(map.Positions.row(0).isZero());
  EXPECT_GE(map.Energy, 1.0 - 1e-12);
}

// Area of the triangles on the torus, by positions alone.
double degreeOf(const Mesh& mesh, const ConformalTorusMapResult& map)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const auto at = [&](int k, int i)
    {
      return periodic(
        map.Positions(mesh.Triangles(t, k), i) - map.Positions(mesh.Triangles(t, 0), i));
    };
    area += 0.5 * (at(1, 0) * at(2, 1) - at(2, 0) * at(1, 1));
  }
  return area;
}
}

// The moduli of tori of revolution are known, and errors decrease with the square of the edges.
TEST(ConformalTorusMap, OfTheTorusOfRevolutionHasItsModulus)
{
  for (const double radius : { 0.2, 0.5, 0.7, 0.9 })
  {
    double errors[2] = {};
    for (int level = 0; level < 2; ++level)
    {
      // Angles of about 45 degrees in the map.
      const double ratio = std::sqrt(1.0 - radius * radius) / radius;
      const int around = static_cast<int>((level == 0 ? 40 : 80) / std::sqrt(ratio)),
                along = static_cast<int>(around * ratio);
      const Mesh mesh = revolution(radius, along, around);
      const ConformalTorusMapResult map = mapToTorus(mesh);
      expectValid(map);
      EXPECT_NEAR(degreeOf(mesh, map), 1.0, 1e-9);
      errors[level] = std::abs(map.Torus.Modulus - tori::modulusOfRevolution(radius)) /
        std::abs(map.Torus.Modulus);
      EXPECT_LT(map.MeanQuasiConformalError, level == 0 ? 1.12 : 1.05);
      EXPECT_LT(map.QuasiConformalError95, level == 0 ? 1.25 : 1.12);
      EXPECT_EQ(map.NumberOfSolves, 1);
    }
    EXPECT_LT(errors[1], 3e-3) << radius;
    EXPECT_LT(errors[1], errors[0] / 3.0) << radius;
  }
}

// By symmetry, the longitude is a coordinate of the map, exactly. The other coordinate is known: it
// is the integral of 1 / (1 + r cos t) over the angle of the tube.
TEST(ConformalTorusMap, OfTheTorusOfRevolutionIsKnownAtEveryPoint)
{
  const double radius = 0.5;
  const int along = 80, around = 60;
  const Mesh mesh = revolution(radius, along, around);
  const ConformalTorusMapResult map = mapToTorus(mesh);
  // The circle around the tube is the shorter period.
  const double longitude = map.Positions(around, 1) < 0.5 ? 1.0 : -1.0;
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const Index v = static_cast<Index>(i) * around + j;
      EXPECT_NEAR(
        periodic(map.Positions(v, 1) - longitude * i / static_cast<double>(along)), 0.0, 1e-12);
      const double t = 2.0 * conformal::Pi * j / around;
      const double isothermal = std::atan2(std::sqrt(1.0 - radius) * std::sin(0.5 * t),
                                  std::sqrt(1.0 + radius) * std::cos(0.5 * t)) /
        conformal::Pi;
      // The orientation is that of the surface, which determines the sign.
      EXPECT_NEAR(periodic(map.Positions(v, 0) + longitude * isothermal), 0.0, 1e-3);
    }
  }
}

// Inversions in spheres preserve angles, and thus the modulus.
TEST(ConformalTorusMap, HasTheModulusOfAnInvertedTorus)
{
  const Mesh mesh = tori::gridTorus(150, 80,
    [](double s, double t)
    {
      const Vector3 p = tori::onRevolution(0.5, s, t) - Vector3(0.3, 0.2, 0.9);
      return Vector3(p / p.squaredNorm());
    });
  const ConformalTorusMapResult map = mapToTorus(mesh);
  expectValid(map);
  EXPECT_NEAR(std::abs(map.Torus.Modulus - tori::modulusOfRevolution(0.5)), 0.0, 1e-3);
  EXPECT_LT(map.MeanQuasiConformalError, 1.03);
}

// A Hopf torus has a modulus that is not imaginary.
TEST(ConformalTorusMap, HasTheModulusOfAHopfTorus)
{
  const std::complex<double> known = tori::modulusOfHopfTorus();
  EXPECT_GT(std::abs(known.real()), 0.2);
  const Mesh mesh = tori::gridTorus(200, 100, tori::onHopfTorus);
  const ConformalTorusMapResult map = mapToTorus(mesh);
  expectValid(map);
  EXPECT_NEAR(std::abs(std::abs(map.Torus.Modulus.real()) - std::abs(known.real())), 0.0, 1e-3);
  EXPECT_NEAR(map.Torus.Modulus.imag(), known.imag(), 1e-3);
  // A mirror image has the opposite real part.
  Mesh mirrored = mesh;
  mirrored.Positions.col(2) *= -1.0;
  mirrored.Triangles.col(1).swap(mirrored.Triangles.col(2));
  EXPECT_NEAR(mapToTorus(mirrored).Torus.Modulus.real(), -map.Torus.Modulus.real(), 1e-9);
}

// The map does not depend on the numbering of vertices and triangles, up to a shift.
TEST(ConformalTorusMap, DoesNotDependOnTheNumbering)
{
  const Mesh mesh = tori::gridTorus(60, 40,
    [](double s, double t)
    { return Vector3(tori::onRevolution(0.4 + 0.1 * std::sin(2.0 * conformal::Pi * s), s, t)); });
  const ConformalTorusMapResult map = mapToTorus(mesh);
  std::vector<int> order(mesh.Positions.rows());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Mesh shuffled = mesh;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    shuffled.Positions.row(order[v]) = mesh.Positions.row(v);
  }
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      shuffled.Triangles(mesh.Triangles.rows() - 1 - t, k) = order[mesh.Triangles(t, (k + 1) % 3)];
    }
  }
  const ConformalTorusMapResult other = mapToTorus(shuffled);
  EXPECT_NEAR(std::abs(other.Torus.Modulus - map.Torus.Modulus), 0.0, 1e-11);
  const Eigen::RowVector2d shift = other.Positions.row(order[0]);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    for (int i = 0; i < 2; ++i)
    {
      EXPECT_NEAR(
        periodic(other.Positions(order[v], i) - shift[i] - map.Positions(v, i)), 0.0, 1e-10);
    }
  }
}

// Obtuse and random triangles with negative weights flip triangles in the first solution, and none
// in the last one.
TEST(ConformalTorusMap, HasNoFlipsForBadTriangles)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> moved(-0.4, 0.4);
  Mesh mesh = tori::gridTorus(40, 160,
    [&](double s, double t)
    { return tori::onRevolution(0.5, s + moved(random) / 40.0, t + moved(random) / 160.0); });
  const ConformalTorusMapResult map = mapToTorus(mesh);
  EXPECT_GT(map.NumberOfNegativeStringConstants, 1000);
  EXPECT_GT(map.NumberOfSolves, 1);
  expectValid(map);
  // Vertices at one position make triangles without area.
  mesh = revolution(0.5, 40, 30);
  mesh.Positions.row(77) = mesh.Positions.row(78);
  mesh.Positions.row(400) = 0.5 * (mesh.Positions.row(399) + mesh.Positions.row(401));
  const ConformalTorusMapResult degenerate = mapToTorus(mesh);
  EXPECT_GT(degenerate.NumberOfInfiniteStringConstants, 0);
  expectValid(degenerate);
}

// The torus of seven vertices and fourteen triangles is the smallest triangulation.
TEST(ConformalTorusMap, MapsTheSmallestTorus)
{
  Mesh mesh;
  mesh.Positions.resize(7, 3);
  mesh.Positions << 3.0, -3.0, 0.0, -3.0, 3.0, 0.0, -3.0, -3.0, 1.0, 3.0, 3.0, 1.0, -1.0, -2.0, 3.0,
    1.0, 2.0, 3.0, 0.0, 0.0, 15.0;
  mesh.Triangles.resize(14, 3);
  for (int i = 0; i < 7; ++i)
  {
    mesh.Triangles.row(2 * i) << i, (i + 1) % 7, (i + 3) % 7;
    mesh.Triangles.row(2 * i + 1) << i, (i + 3) % 7, (i + 2) % 7;
  }
  const ConformalTorusMapResult map = mapToTorus(mesh);
  expectValid(map);
}

TEST(ConformalTorusMap, IsIndependentOfScaleAndThreads)
{
  const Mesh mesh = revolution(0.5, 200, 110); // large enough for the multifrontal factorization
  const ConformalTorusMapResult map = mapToTorus(mesh),
                                threaded = mapToTorus(mesh, runs::backwards());
  EXPECT_EQ(map.Positions, threaded.Positions);
  EXPECT_EQ(map.Torus.Modulus, threaded.Torus.Modulus);
  Mesh large = mesh;
  large.Positions *= 0x1p200;
  EXPECT_EQ(map.Positions, mapToTorus(large).Positions);
}

TEST(ConformalTorusMap, ReportsProgressAndAborts)
{
  const Mesh mesh = revolution(0.5, 200, 110);
  runs::Watch watch;
  mapToTorus(mesh, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GT(watch.calls(), 10);
  for (const double fraction : { 0.0, 0.3, 0.7 })
  {
    EXPECT_THROW(mapToTorus(mesh, runs::stoppingAt(fraction)), conformal::Aborted);
  }
}

TEST(ConformalTorusMap, RejectsOtherSurfaces)
{
  EXPECT_THROW(mapToTorus(conformal::makeGeodesicSphere(4)), std::invalid_argument);
  EXPECT_THROW(mapToTorus(handles::sphereWithHandles(2, 20)), std::invalid_argument);
  EXPECT_THROW(mapToTorus({}), std::invalid_argument);
  Mesh open = revolution(0.5, 20, 10);
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_THROW(mapToTorus(open), std::invalid_argument);
  Mesh reversed = revolution(0.5, 20, 10);
  std::swap(reversed.Triangles(3, 0), reversed.Triangles(3, 1));
  EXPECT_THROW(mapToTorus(reversed), std::invalid_argument);
  Mesh notFinite = revolution(0.5, 20, 10);
  notFinite.Positions(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mapToTorus(notFinite), std::invalid_argument);
}
