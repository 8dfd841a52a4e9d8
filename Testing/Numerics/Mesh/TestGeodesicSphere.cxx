#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Vector3;

namespace
{
const std::array<int, 7> Frequencies = { 1, 2, 3, 4, 9, 18, 36 };
}

// Eqs. 1 and 2 of the paper.
TEST(GeodesicSphere, CountsAreThePapers)
{
  for (int f : Frequencies)
  {
    const Mesh sphere = makeGeodesicSphere(f);
    EXPECT_EQ(sphere.Triangles.rows(), 20 * f * f);
    EXPECT_EQ(sphere.Positions.rows(), sphere.Triangles.rows() / 2 + 2);
  }
}

// Neither other numbers of vertices nor other valences.
TEST(GeodesicSphere, IsKnownByItsConnectivity)
{
  for (int f : Frequencies)
  {
    conformal::Mesh sphere = makeGeodesicSphere(f);
    const Index size = sphere.Positions.rows();
    EXPECT_TRUE(conformal::hasGeodesicConnectivity(sphere.Triangles, size));
    EXPECT_FALSE(conformal::hasGeodesicConnectivity(sphere.Triangles, size + 1));
    EXPECT_FALSE(conformal::hasGeodesicConnectivity(sphere.Triangles.topRows(size), size));
    sphere.Triangles(0, 0) = sphere.Triangles(sphere.Triangles.rows() - 1, 0);
    EXPECT_FALSE(conformal::hasGeodesicConnectivity(sphere.Triangles, size));
  }
}

// Turned it is still one, with one end blown up it is not.
TEST(GeodesicSphere, IsKnownByItsConnectivityAndAreas)
{
  for (int f : Frequencies)
  {
    conformal::Mesh sphere = makeGeodesicSphere(f);
    EXPECT_TRUE(conformal::isGeodesicSphere(sphere.Positions, sphere.Triangles));
    const Eigen::AngleAxisd turn(1.0, Vector3(1.0, 2.0, 3.0).normalized());
    sphere.Positions = sphere.Positions * turn.toRotationMatrix();
    EXPECT_TRUE(conformal::isGeodesicSphere(sphere.Positions, sphere.Triangles));
    sphere.Positions.col(2).array() += 0.7;
    sphere.Positions.rowwise().normalize();
    EXPECT_FALSE(conformal::isGeodesicSphere(sphere.Positions, sphere.Triangles));
    sphere = makeGeodesicSphere(f);
    sphere.Triangles(0, 0) = sphere.Triangles(sphere.Triangles.rows() - 1, 0);
    EXPECT_FALSE(conformal::isGeodesicSphere(sphere.Positions, sphere.Triangles));
  }
}

TEST(GeodesicSphere, IsClosedAndOfEulerNumberTwo)
{
  for (int f : Frequencies)
  {
    const Mesh sphere = makeGeodesicSphere(f);
    std::set<std::pair<int, int>> directed;
    for (Index r = 0; r < sphere.Triangles.rows(); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_TRUE(
          directed.emplace(sphere.Triangles(r, k), sphere.Triangles(r, (k + 1) % 3)).second);
      }
    }
    for (const auto& [from, to] : directed)
    {
      EXPECT_TRUE(directed.count({ to, from }));
    }
    const Index edges = static_cast<Index>(directed.size()) / 2;
    EXPECT_EQ(sphere.Positions.rows() - edges + sphere.Triangles.rows(), 2);
  }
}

TEST(GeodesicSphere, PositionsAreDistinctUnitVectors)
{
  for (int f : Frequencies)
  {
    const Mesh sphere = makeGeodesicSphere(f);
    std::set<std::array<double, 3>> seen;
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      const Vector3 n = sphere.Positions.row(i);
      EXPECT_NEAR(n.norm(), 1.0, 1e-15);
      EXPECT_TRUE(seen.insert({ n[0], n[1], n[2] }).second);
    }
    EXPECT_EQ(Vector3(sphere.Positions.row(0)), Vector3(0, 0, 1));
  }
}

TEST(GeodesicSphere, FacesCoverTheSphereOnceFacingOutwards)
{
  for (int f : Frequencies)
  {
    const Mesh sphere = makeGeodesicSphere(f);
    double solidAngle = 0.0;
    for (Index r = 0; r < sphere.Triangles.rows(); ++r)
    {
      const Vector3 a = sphere.Positions.row(sphere.Triangles(r, 0)),
                    b = sphere.Positions.row(sphere.Triangles(r, 1)),
                    c = sphere.Positions.row(sphere.Triangles(r, 2));
      const double determinant = a.dot(b.cross(c));
      EXPECT_GT(determinant, 0.0);
      solidAngle += 2.0 * std::atan2(determinant, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    EXPECT_NEAR(solidAngle, 4.0 * std::acos(-1.0), 1e-9);
  }
}

// "Equilateral" holds for f = 1; further subdivision keeps planar angles within 54 and 72 degrees.
TEST(GeodesicSphere, TrianglesStayNearlyEquilateral)
{
  const Mesh sphere = makeGeodesicSphere(36);
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 o = sphere.Positions.row(sphere.Triangles(r, k));
      const Vector3 u = Vector3(sphere.Positions.row(sphere.Triangles(r, (k + 1) % 3))) - o;
      const Vector3 v = Vector3(sphere.Positions.row(sphere.Triangles(r, (k + 2) % 3))) - o;
      const double degrees = std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / std::acos(-1.0);
      EXPECT_GT(degrees, 53.9);
      EXPECT_LT(degrees, 72.1);
    }
  }
}

TEST(GeodesicSphere, RefusesFrequenciesOutOfRange)
{
  EXPECT_THROW(makeGeodesicSphere(0), std::invalid_argument);
  EXPECT_THROW(makeGeodesicSphere(-3), std::invalid_argument);
  EXPECT_THROW(makeGeodesicSphere(conformal::MaximumFrequency + 1), std::invalid_argument);
}
