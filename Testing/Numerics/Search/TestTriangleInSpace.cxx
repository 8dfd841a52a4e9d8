#include "Search/TriangleInSpace.h"

#include "Base/Random.h"

#include <gtest/gtest.h>

using conformal::Index;
using conformal::TriangleInSpace;

namespace
{
void expectEqualDistances(const Eigen::MatrixXd& points, double tolerance)
{
  const TriangleInSpace copy = conformal::toSpace(points.col(0).data(), points.col(1).data(),
    points.col(2).data(), points.col(3).data(), points.rows());
  const conformal::Vector3 places[] = { copy.X, copy.A, copy.B, copy.C };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      EXPECT_NEAR(
        (places[i] - places[j]).norm(), (points.col(i) - points.col(j)).norm(), tolerance);
    }
  }
}
}

TEST(TriangleInSpace, DistancesAreEqual)
{
  conformal::Random random(1);
  for (Index dimension = 1; dimension <= 8; ++dimension)
  {
    for (int trial = 0; trial < 50; ++trial)
    {
      expectEqualDistances(Eigen::MatrixXd::NullaryExpr(dimension, 4,
                             [&](Index, Index) { return 2.0 * random.uniform() - 1.0; }),
        1e-11);
    }
  }
}

// Squares are subtracted, so that half of the digits remain where distances are 0.
TEST(TriangleInSpace, TrianglesMayBeDegenerate)
{
  Eigen::MatrixXd points(5, 4);
  points.setZero();
  points.col(0) << 1, 2, 3, 4, 5;
  expectEqualDistances(points, 1e-7); // a point
  points.col(3) << 0, 1, 0, 1, 0;
  expectEqualDistances(points, 1e-7); // a segment
  points.col(2) = points.col(3);
  expectEqualDistances(points, 1e-7);
}
