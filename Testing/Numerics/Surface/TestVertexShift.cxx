#include "Surface/VertexShift.h"

#include "Base/Random.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Random;
using conformal::TrainingSamples;
using conformal::Vector3;
using conformal::vertexShift;

namespace
{
Vector3 direction(Random& random)
{
  const double z = 2.0 * random.uniform() - 1.0, phi = 2.0 * std::acos(-1.0) * random.uniform();
  const double rho = std::sqrt(1.0 - z * z);
  return { rho * std::cos(phi), rho * std::sin(phi), z };
}

/// A rounded box: flat sides, and edges where it bends.
Vector3 onBox(const Vector3& direction)
{
  const Eigen::Array3d p = direction.array();
  return direction / std::pow((p * p * p * p * p * p).sum(), 1.0 / 6.0);
}

/// Points on it, even over its area where kept everywhere.
Points scatter(Index count, const std::function<double(const Vector3&)>& kept)
{
  Random random(3);
  std::vector<Vector3> found;
  while (static_cast<Index>(found.size()) < count)
  {
    const Vector3 n = direction(random), x = onBox(n);
    const double h = 1e-4;
    const Vector3 u = n.unitOrthogonal(), v = n.cross(u);
    const double area =
      (onBox((n + h * u).normalized()) - x).cross(onBox((n + h * v).normalized()) - x).norm() /
      (h * h);
    constexpr double largest = 12.0;
    if (random.uniform() * largest < area * kept(x))
    {
      found.push_back(x);
    }
  }
  Points points(count, 3);
  for (Index i = 0; i < count; ++i)
  {
    points.row(i) = found[i];
  }
  return points;
}

/// How far from the middle of a flat side, where the edges are at 1.
double towardsEdge(const Vector3& x)
{
  Eigen::Array3d a = x.cwiseAbs().array();
  std::sort(a.data(), a.data() + 3);
  return a[1] / a[2];
}

/// A mesh of it.
Mesh box(int frequency)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    mesh.Positions.row(i) = onBox(mesh.Positions.row(i));
  }
  return mesh;
}
}

// A polyhedron whose triangles have a ball's points in their middle keeps the ball's volume.
TEST(VertexShift, KeepsTheVolumeOfABall)
{
  Mesh mesh = conformal::makeGeodesicSphere(8);
  const double ball = 4.0 / 3.0 * std::acos(-1.0);
  mesh.Positions *= std::cbrt(ball / conformal::signedVolume(mesh.Positions, mesh.Triangles));
  Random random(1);
  Points points(20000, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = direction(random);
  }
  EXPECT_NEAR(vertexShift(mesh, TrainingSamples(points)), 1.0, 0.03);
}

// Samples that are the vertices: the surface goes through them.
TEST(VertexShift, IsNoneForVerticesOnThePoints)
{
  const Mesh mesh = conformal::makeGeodesicSphere(8);
  EXPECT_NEAR(vertexShift(mesh, TrainingSamples(mesh.Positions)), 0.0, 1e-6);
}

// Points that crowd along edges are taken for those that a decimation has left; not those that
// crowd on a side, or are missing from one.
TEST(VertexShift, GrowsWhereSamplesCrowdOnRidges)
{
  const Mesh mesh = box(12);
  const Index count = 6000;
  const auto shiftOf = [&](const std::function<double(const Vector3&)>& kept)
  { return vertexShift(mesh, TrainingSamples(scatter(count, kept))); };
  const double even = shiftOf([](const Vector3&) { return 1.0; });
  EXPECT_GT(shiftOf([](const Vector3& x) { return std::pow(towardsEdge(x), 2.0); }), even + 0.3);
  EXPECT_NEAR(shiftOf([](const Vector3& x) { return x[2] > 0.0 ? 1.0 : 0.3; }), even, 0.15);
  EXPECT_NEAR(shiftOf([](const Vector3& x) { return x[2] < 0.9; }), even, 0.15);
}

TEST(VertexShift, IsTheUsualOneWhereNothingBends)
{
  Mesh flat = conformal::makeGeodesicSphere(3);
  flat.Positions.col(2).setZero();
  EXPECT_EQ(vertexShift(flat, TrainingSamples(flat.Positions)), conformal::UsualVertexShift);
}

TEST(VertexShift, IsTheSameInAnyUnit)
{
  Mesh mesh = box(8);
  Points points = scatter(3000, [](const Vector3& x) { return towardsEdge(x); });
  const double shift = vertexShift(mesh, TrainingSamples(points));
  EXPECT_GT(shift, 0.1);
  mesh.Positions *= 1024.0;
  points *= 1024.0;
  EXPECT_EQ(vertexShift(mesh, TrainingSamples(points)), shift);
}
