#include "Mesh/PolygonTriangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
using conformal::Index;
using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;

Points star(Index corners, double depth)
{
  Points points(corners, 3);
  for (Index i = 0; i < corners; ++i)
  {
    const double a = 8.0 * std::atan(1.0) * static_cast<double>(i) / static_cast<double>(corners);
    const double r = i % 2 == 0 ? 1.0 : 1.0 - depth;
    points.row(i) << 3.0 + r * std::cos(a), r * std::sin(a), 0.0;
  }
  return points;
}

// Teeth upwards from a bar.
Points comb(Index teeth)
{
  Points points(4 * teeth, 3);
  for (Index i = 0; i < teeth; ++i)
  {
    const double x = static_cast<double>(2 * i);
    points.row(4 * i + 0) << x, 0.0, 0.0;
    points.row(4 * i + 1) << x + 0.1, 10.0, 0.0;
    points.row(4 * i + 2) << x + 0.9, 10.0, 0.0;
    points.row(4 * i + 3) << x + 1.0, 0.0, 0.0;
  }
  points.row(0) << 0.0, -1.0, 0.0;
  points.row(4 * teeth - 1) << static_cast<double>(2 * teeth), -1.0, 0.0;
  return points.colwise().reverse();
}

// A band wound around itself, there and back.
Points spiral(Index steps)
{
  Points points(2 * steps, 3);
  for (Index i = 0; i < steps; ++i)
  {
    const double a = 0.2 * static_cast<double>(i);
    const Vector3 direction(std::cos(a), std::sin(a), 0.0);
    points.row(i) = (1.0 + a) * direction.transpose();
    points.row(2 * steps - 1 - i) = (3.0 + a) * direction.transpose();
  }
  return points.colwise().reverse();
}

Vector3 areaOf(const Points& points)
{
  Vector3 sum = Vector3::Zero();
  const Vector3 first = points.row(0);
  for (Index i = 1; i + 1 < points.rows(); ++i)
  {
    const Vector3 a = points.row(i), b = points.row(i + 1);
    sum += 0.5 * (a - first).cross(b - first);
  }
  return sum;
}

// As many triangles as there must be, all turned as the polygon, together as large as it: none
// overlaps another or lies outside. Every side of the polygon is a side of one triangle.
void expectTriangulated(const Points& points)
{
  const Triangles triangles = conformal::triangulatePolygon(points);
  ASSERT_EQ(triangles.rows(), points.rows() - 2);
  const Vector3 whole = areaOf(points);
  const Vector3 normal = whole.normalized();
  double sum = 0.0;
  std::set<std::pair<int, int>> sides;
  for (Index i = 0; i < triangles.rows(); ++i)
  {
    const Vector3 a = points.row(triangles(i, 0)), b = points.row(triangles(i, 1)),
                  c = points.row(triangles(i, 2));
    const double area = 0.5 * normal.dot((b - a).cross(c - a));
    ASSERT_GE(area, -1e-12 * whole.norm()) << i;
    sum += area;
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_TRUE(sides.insert({ triangles(i, k), triangles(i, (k + 1) % 3) }).second);
    }
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-9 * whole.norm());
  const int count = static_cast<int>(points.rows());
  for (int i = 0; i < count; ++i)
  {
    EXPECT_EQ(sides.count({ i, (i + 1) % count }), 1u) << i;
  }
}

Points turned(const Points& points)
{
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.0, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  return points * rotation.transpose();
}
}

TEST(PolygonTriangulation, CoversThePolygonOnce)
{
  for (const Points& points : { star(3, 0.0), star(4, 0.0), star(5, 0.0), star(10, 0.6),
         star(1000, 0.3), comb(2), comb(300), spiral(300) })
  {
    expectTriangulated(points);
    expectTriangulated(turned(points));
    expectTriangulated(points.colwise().reverse());
  }
}

// With a look at all corners for each ear this would take hours.
TEST(PolygonTriangulation, TakesManyCorners)
{
  expectTriangulated(star(100000, 0.3));
  expectTriangulated(star(100000, 0.0));
}

TEST(PolygonTriangulation, TakesCornersOnSides)
{
  Points points(8, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 2, 2, 0, 1, 2, 0, 0, 2, 0, 0, 1, 0;
  expectTriangulated(points);
}

TEST(PolygonTriangulation, IsTheSameAtAnyScale)
{
  const Points points = star(40, 0.5);
  const Triangles triangles = conformal::triangulatePolygon(points);
  for (int exponent : { -1000, -100, 100, 1020 })
  {
    EXPECT_EQ(conformal::triangulatePolygon(points * std::ldexp(1.0, exponent)), triangles);
  }
}

TEST(PolygonTriangulation, SaysWhatItCannotCut)
{
  EXPECT_EQ(conformal::triangulatePolygon(Points(0, 3)).rows(), 0);
  EXPECT_EQ(conformal::triangulatePolygon(Points::Zero(5, 3)).rows(), 0);
  Points line = star(6, 0.5);
  line.col(1).setZero();
  EXPECT_EQ(conformal::triangulatePolygon(line).rows(), 0);
  Points broken = star(6, 0.5);
  broken(3, 1) = std::nan("");
  EXPECT_EQ(conformal::triangulatePolygon(broken).rows(), 0);
}
