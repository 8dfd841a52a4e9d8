#include "Sphere/SphereLocator.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <ctime>
#include <random>

using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::SphereLocation;
using conformal::SphereLocator;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
class Directions
{
public:
  Vector3 next()
  {
    return Vector3(
      this->Normal(this->Engine), this->Normal(this->Engine), this->Normal(this->Engine))
      .normalized();
  }

private:
  std::mt19937_64 Engine{ 1 };
  std::normal_distribution<double> Normal;
};

Vector3 pointAt(const Points& positions, const Triangles& triangles, const SphereLocation& location)
{
  Vector3 point = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    point += location.Barycentric[k] * Vector3(positions.row(triangles(location.Triangle, k)));
  }
  return point;
}

/// p' is on the line through p, by default to the rounding of the coordinates.
void expectFound(const Points& positions, const Triangles& triangles, const SphereLocator& locator,
  const Vector3& direction, double tolerance = 5e-16)
{
  const SphereLocation location = locator.locate(direction);
  ASSERT_GE(location.Triangle, 0);
  ASSERT_GE(location.Barycentric.minCoeff(), 0.0);
  ASSERT_NEAR(location.Barycentric.sum(), 1.0, 1e-15);
  const Vector3 point = pointAt(positions, triangles, location);
  ASSERT_LT(point.cross(direction).norm(), tolerance);
  ASSERT_GT(point.dot(direction), 0.0);
}

/// A loxodromic Moebius map along z: everything runs towards the north pole.
Points squeezed(const Points& positions, double factor)
{
  Points result(positions.rows(), 3);
  for (Index i = 0; i < positions.rows(); ++i)
  {
    // Stereographic from the south pole, scaled; written without the pole's division.
    const Vector3 n = positions.row(i);
    const double up = 1.0 + n[2], down = 1.0 - n[2];
    const double sum = up + factor * factor * down;
    if (n[2] == -1.0)
    {
      result.row(i) = n.transpose();
      continue;
    }
    result.row(i) << 2.0 * factor * n[0] / sum, 2.0 * factor * n[1] / sum,
      (up - factor * factor * down) / sum;
    result.row(i).normalize();
  }
  return result;
}
}

TEST(SphereLocator, HintsChangeNothing)
{
  const Mesh sphere = makeGeodesicSphere(11);
  const SphereLocator locator(sphere.Positions, sphere.Triangles);
  Directions directions;
  for (int i = 0; i < 20000; ++i)
  {
    Vector3 direction = directions.next();
    if (i % 3 == 0) // on edges and vertices it is a matter of order
    {
      const auto ids = sphere.Triangles.row(i % sphere.Triangles.rows());
      direction = Vector3(sphere.Positions.row(ids[0]));
      direction = i % 2
        ? direction
        : Vector3((direction + sphere.Positions.row(ids[1]).transpose()).normalized());
    }
    const SphereLocation expected = locator.locate(direction);
    const int near = i % 2 ? expected.Triangle : i % static_cast<int>(sphere.Triangles.rows());
    const SphereLocation hinted = locator.locate(direction, near);
    ASSERT_EQ(hinted.Triangle, expected.Triangle);
    ASSERT_EQ(hinted.Barycentric, expected.Barycentric);
  }
}

TEST(SphereLocator, FindsEveryDirectionOnEveryLattice)
{
  Directions directions;
  for (int f = 1; f <= 36; ++f)
  {
    const Mesh sphere = makeGeodesicSphere(f);
    const SphereLocator locator(sphere.Positions, sphere.Triangles);
    for (int i = 0; i < 2000; ++i)
    {
      expectFound(sphere.Positions, sphere.Triangles, locator, directions.next());
    }
  }
}

TEST(SphereLocator, AgreesWithBruteForce)
{
  Directions directions;
  const Mesh sphere = makeGeodesicSphere(7);
  const SphereLocator locator(sphere.Positions, sphere.Triangles);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 direction = directions.next();
    int expected = -1;
    for (Index r = 0; r < sphere.Triangles.rows() && expected < 0; ++r)
    {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k)
      {
        corners.col(k) = sphere.Positions.row(sphere.Triangles(r, k)).transpose();
      }
      const Vector3 weights = corners.inverse() * direction;
      if (weights.minCoeff() >= 0.0)
      {
        expected = static_cast<int>(r);
        const SphereLocation location = locator.locate(direction);
        EXPECT_EQ(location.Triangle, expected);
        EXPECT_LT((location.Barycentric - weights / weights.sum()).cwiseAbs().maxCoeff(), 1e-12);
      }
    }
    EXPECT_GE(expected, 0);
  }
}

TEST(SphereLocator, VerticesAreFoundExactlyInTheirLowestTriangle)
{
  const Mesh sphere = makeGeodesicSphere(9);
  const SphereLocator locator(sphere.Positions, sphere.Triangles);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    const SphereLocation location = locator.locate(sphere.Positions.row(i));
    int lowest = 0;
    while ((sphere.Triangles.row(lowest).array() != static_cast<int>(i)).all())
    {
      ++lowest;
    }
    ASSERT_EQ(location.Triangle, lowest);
    EXPECT_EQ(Vector3(pointAt(sphere.Positions, sphere.Triangles, location)),
      Vector3(sphere.Positions.row(i)));
    EXPECT_EQ(location.Barycentric.maxCoeff(), 1.0);
  }
}

TEST(SphereLocator, EdgeMidpointsAreFoundInOneOfTheTwoTriangles)
{
  const Mesh sphere = makeGeodesicSphere(9);
  const SphereLocator locator(sphere.Positions, sphere.Triangles);
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = sphere.Triangles(r, k), to = sphere.Triangles(r, (k + 1) % 3);
      const Vector3 middle =
        Vector3(sphere.Positions.row(from) + sphere.Positions.row(to)).normalized();
      const SphereLocation location = locator.locate(middle);
      const auto ids = sphere.Triangles.row(location.Triangle).array();
      EXPECT_TRUE((ids == from).any() && (ids == to).any());
      EXPECT_LT(location.Barycentric.minCoeff(), 1e-14);
      EXPECT_NEAR(location.Barycentric.maxCoeff(), 0.5, 1e-13);
    }
  }
}

// exp(-30) of the fair area: triangles of 1e-8, found to the last digit of their coordinates.
TEST(SphereLocator, IsExactWhereTrianglesShrink)
{
  const Mesh sphere = makeGeodesicSphere(18);
  const Points positions = squeezed(sphere.Positions, std::exp(-15.0));
  const SphereLocator locator(positions, sphere.Triangles);
  Directions directions;
  for (int i = 0; i < 20000; ++i)
  {
    // The few triangles left for most of the sphere are long and pass close by its center.
    expectFound(positions, sphere.Triangles, locator, directions.next(), 1e-10);
  }
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0.05, 1.0);
  double smallest = 1.0;
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(sphere.Triangles(r, 0)),
                  b = positions.row(sphere.Triangles(r, 1)),
                  c = positions.row(sphere.Triangles(r, 2));
    smallest = std::min(smallest, (b - a).norm());
    const Vector3 weights = Vector3(uniform(engine), uniform(engine), uniform(engine));
    const Vector3 direction = (weights[0] * a + weights[1] * b + weights[2] * c).normalized();
    expectFound(positions, sphere.Triangles, locator, direction);
    const double inside = 1e-16 / (b - a).norm();
    if (inside < 0.01) // else the direction's own rounding may carry it across an edge
    {
      EXPECT_EQ(locator.locate(direction).Triangle, r);
    }
  }
  EXPECT_LT(smallest, 1e-7);
}

TEST(SphereLocator, TrianglesWithoutAreaDoNoHarm)
{
  // A tetrahedron with one face split at a point of its edge.
  Points positions(5, 3);
  const double s = 1.0 / std::sqrt(3.0);
  positions << s, s, s, -s, -s, s, -s, s, -s, s, -s, -s, 0.0, 0.0, 1.0;
  Triangles triangles(6, 3);
  triangles << 0, 4, 1, 0, 2, 4, 4, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  const SphereLocator locator(positions, triangles);
  Directions directions;
  for (int i = 0; i < 1000; ++i)
  {
    expectFound(positions, triangles, locator, directions.next());
  }
  expectFound(positions, triangles, locator, Vector3(0, 0, 1));
}

// All corners of an ear are on the border of a sheet, and thus on the equator. Its plane contains
// all directions of the equator.
TEST(SphereLocator, EarsOfASheetContainNoOtherPartOfTheBorder)
{
  Points positions(7, 3);
  for (int i = 0; i < 6; ++i)
  {
    const double angle = conformal::Pi * i / 3.0;
    positions.row(i) << std::cos(angle), std::sin(angle), 0.0;
  }
  positions.row(6) << 0.0, 0.0, 1.0;
  Triangles triangles(6, 3);
  triangles << 0, 1, 2, 6, 0, 2, 6, 2, 3, 6, 3, 4, 6, 4, 5, 6, 5, 0;
  const SphereLocator locator(positions, triangles);
  for (const int v : { 0, 2, 3, 4, 5 })
  {
    const auto location = locator.locate(positions.row(v));
    ASSERT_GT(location.Triangle, 0) << v;
    Vector3 found = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      found += location.Barycentric[k] * positions.row(triangles(location.Triangle, k)).transpose();
    }
    EXPECT_LT((found.transpose() - positions.row(v)).norm(), 1e-15) << v;
  }
}

namespace
{
// Two poles, tilted, and a zigzag around the equator. Each pole has a triangle for each corner.
Mesh fans(int corners)
{
  Mesh mesh;
  mesh.Positions.resize(corners + 2, 3);
  const Eigen::Matrix3d tilt =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (int i = 0; i < corners; ++i)
  {
    const double a = 2.0 * conformal::Pi * i / corners, z = i % 2 ? 0.1 : -0.1;
    mesh.Positions.row(i) = tilt * Vector3(std::cos(a), std::sin(a), z).normalized();
  }
  mesh.Positions.row(corners) = tilt * Vector3(0, 0, 1);
  mesh.Positions.row(corners + 1) = tilt * Vector3(0, 0, -1);
  mesh.Triangles.resize(2 * corners, 3);
  for (int i = 0; i < corners; ++i)
  {
    const int next = (i + 1) % corners;
    mesh.Triangles.row(i) << i, next, corners;
    mesh.Triangles.row(corners + i) << next, i, corners + 1;
  }
  return mesh;
}

double secondsToLocate(const Mesh& mesh, int count)
{
  const SphereLocator locator(mesh.Positions, mesh.Triangles);
  Directions directions;
  const std::clock_t start = std::clock();
  for (int i = 0; i < count; ++i)
  {
    EXPECT_GE(locator.locate(directions.next()).Triangle, 0);
  }
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}
}

TEST(SphereLocator, FansAgreeWithTheTriangleThatContainsADirection)
{
  const Mesh mesh = fans(1000);
  const SphereLocator locator(mesh.Positions, mesh.Triangles);
  Directions directions;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 direction = directions.next();
    expectFound(mesh.Positions, mesh.Triangles, locator, direction, 1e-13); // long triangles
    int expected = -1;
    for (Index r = 0; r < mesh.Triangles.rows() && expected < 0; ++r)
    {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k)
      {
        corners.col(k) = mesh.Positions.row(mesh.Triangles(r, k)).transpose();
      }
      const Vector3 weights = corners.inverse() * direction;
      expected = weights.minCoeff() >= 0.0 ? static_cast<int>(r) : -1;
    }
    ASSERT_EQ(locator.locate(direction).Triangle, expected);
  }
}

// Boxes of the triangles around a pole overlap: without slabs, a search among 200,000 of them takes
// a thousand times as long as one among 200,000 even triangles.
TEST(SphereLocator, ManyTrianglesAtAVertexAreFoundAsFast)
{
  constexpr int count = 3000;
  const double even = secondsToLocate(makeGeodesicSphere(100), 10 * count) / 10.0;
  const double narrow = secondsToLocate(fans(100000), count);
  EXPECT_LT(narrow, 40.0 * even) << "even triangles take " << even << " s";
}

TEST(SphereLocator, NoTrianglesMeansNotFound)
{
  EXPECT_EQ(SphereLocator().locate(Vector3(0, 0, 1)).Triangle, -1);
}
