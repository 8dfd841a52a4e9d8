#include "Register/SphereSamples.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Points;
using conformal::Rows;
using conformal::SphereGrid;
using conformal::Vector3;

// Weights put the line of the direction back together, and their slopes are those of differences.
TEST(SphereSamples, WeightsAndSlopesAreThoseOfTheTriangle)
{
  const SphereGrid grid(makeGeodesicSphere(4));
  const Points directions = makeGeodesicSphere(7).Positions;
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const Vector3 direction = directions.row(i);
    const auto at = grid.weightsAt(direction);
    EXPECT_NEAR(at.Weights.sum(), 1.0, 1e-14);
    Vector3 place = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      place += at.Weights[k] * grid.mesh().Positions.row(at.Ids[k]).transpose();
    }
    EXPECT_LT((place.normalized() - direction).norm(), 1e-13);
    // Along the sphere, by a step that stays in the triangle or leaves it by little.
    if (at.Weights.minCoeff() > 1e-3)
    {
      const Vector3 along = direction.unitOrthogonal();
      const double step = 1e-6;
      const auto ahead = grid.weightsAt((direction + step * along).normalized(), at.Triangle);
      EXPECT_LT(((ahead.Weights - at.Weights) / step - at.Slopes * along).norm(), 1e-4);
    }
  }
}

// What is linear in space stays so between the vertices of a triangle.
TEST(SphereSamples, ValuesAtVerticesAreKept)
{
  const SphereGrid grid(makeGeodesicSphere(5));
  Rows values(grid.size(), 2);
  values << grid.mesh().Positions.col(0), grid.mesh().Positions.col(2);
  EXPECT_LT((sampleAt(grid, values, grid.mesh().Positions) - values).cwiseAbs().maxCoeff(), 1e-13);
}
