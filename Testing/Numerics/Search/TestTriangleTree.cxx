#include "Search/TriangleTree.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using conformal::closestPointOfTriangle;
using conformal::FootPoint;
using conformal::Index;
using conformal::Points;
using conformal::TriangleTree;
using conformal::Vector3;

namespace
{
Vector3 randomPoint(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return Vector3(x, y, z);
}
}

// The foot is in the triangle, and no point of a fine grid on the triangle is closer.
TEST(TriangleTree, FootIsTheClosestPointOfATriangle)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Vector3 a = randomPoint(random, 1), b = randomPoint(random, 1),
                  c = trial % 3 == 0 ? Vector3(a + 1e-9 * randomPoint(random, 1))
                                     : randomPoint(random, 1);
    const Vector3 x = randomPoint(random, 2);
    const FootPoint foot = closestPointOfTriangle(x, a, b, c);
    EXPECT_GE(foot.Barycentric.minCoeff(), -1e-15);
    EXPECT_NEAR(foot.Barycentric.sum(), 1.0, 1e-14);
    EXPECT_NEAR((foot.Position - x).squaredNorm(), foot.SquareDistance, 1e-15);
    double least = 1e9;
    const int n = 60;
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        const Vector3 q = (i * a + j * b + (n - i - j) * c) / n;
        least = std::min(least, (q - x).squaredNorm());
      }
    }
    EXPECT_LE(foot.SquareDistance, least + 1e-14);
    EXPECT_GE(std::sqrt(foot.SquareDistance), std::sqrt(least) - 2.0 * std::sqrt(3.0) / n);
  }
}

TEST(TriangleTree, DegenerateTrianglesAreSegmentsAndPoints)
{
  const Vector3 a(0, 0, 0), b(1, 0, 0), m(0.25, 0, 0), x(0.5, 2, 0);
  EXPECT_NEAR(closestPointOfTriangle(x, a, b, m).SquareDistance, 4.0, 1e-15);
  EXPECT_NEAR(closestPointOfTriangle(x, m, a, b).SquareDistance, 4.0, 1e-15);
  EXPECT_NEAR(closestPointOfTriangle(x, b, m, a).SquareDistance, 4.0, 1e-15);
  EXPECT_EQ(closestPointOfTriangle(x, b, b, b).SquareDistance, 4.25);
}

TEST(TriangleTree, AgreesWithEveryTriangleInTurn)
{
  std::mt19937 random(2);
  const auto sphere = conformal::makeGeodesicSphere(6);
  Points positions = sphere.Positions;
  TriangleTree tree(positions, sphere.Triangles);
  for (int move = 0; move < 2; ++move)
  {
    if (move == 1)
    {
      for (Index i = 0; i < positions.rows(); ++i)
      {
        positions.row(i) += 0.5 * randomPoint(random, 1).transpose();
      }
      tree.refit(positions);
    }
    for (int trial = 0; trial < 500; ++trial)
    {
      const Vector3 x = randomPoint(random, 1.5);
      FootPoint best;
      for (int r = 0; r < sphere.Triangles.rows(); ++r)
      {
        FootPoint foot = closestPointOfTriangle(x, positions.row(sphere.Triangles(r, 0)),
          positions.row(sphere.Triangles(r, 1)), positions.row(sphere.Triangles(r, 2)));
        foot.Triangle = r;
        if (foot.SquareDistance < best.SquareDistance)
        {
          best = foot;
        }
      }
      for (int hint : { -1, trial % int(sphere.Triangles.rows()) })
      {
        const FootPoint foot = tree.closestPoint(x, hint);
        EXPECT_EQ(foot.Triangle, best.Triangle);
        EXPECT_EQ(foot.SquareDistance, best.SquareDistance);
        EXPECT_EQ(foot.Position, best.Position);
      }
    }
  }
}

// Bounds of boxes are rounded to floats in a frame of the mesh: neither the unit nor the origin of
// coordinates may change which triangle is found, nor may queries far outside of the mesh.
TEST(TriangleTree, FindsFeetInAnyUnitAndAtAnyDistance)
{
  std::mt19937 random(3);
  const auto sphere = conformal::makeGeodesicSphere(6);
  for (const double unit : { 1e-30, 1.0, 1e30 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      const Vector3 center = unit * offset * Vector3(1, -2, 3);
      Points positions = unit * sphere.Positions;
      positions.rowwise() += center.transpose();
      const TriangleTree tree(positions, sphere.Triangles);
      for (const double reach : { 0.5, 3.0, 1e8, 1e30 })
      {
        for (int trial = 0; trial < 50; ++trial)
        {
          const Vector3 x = center + unit * reach * randomPoint(random, 1);
          double best = std::numeric_limits<double>::infinity();
          for (int r = 0; r < sphere.Triangles.rows(); ++r)
          {
            best = std::min(best,
              closestPointOfTriangle(x, positions.row(sphere.Triangles(r, 0)),
                positions.row(sphere.Triangles(r, 1)), positions.row(sphere.Triangles(r, 2)))
                .SquareDistance);
          }
          EXPECT_EQ(tree.closestPoint(x).SquareDistance, best);
        }
      }
    }
  }
}

TEST(TriangleTree, AnEmptyMeshHasNoFoot)
{
  EXPECT_EQ(TriangleTree().closestPoint(Vector3::Zero()).Triangle, -1);
}
