#include "Sphere/Resampling.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <stdexcept>

using conformal::Index;
using conformal::Points;
using conformal::resample;

TEST(Resampling, GivesBackTheVerticesValues)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const Points values = sphere.Positions.array().square();
  const Points same = resample(sphere.Positions, values, sphere.Triangles, sphere.Positions);
  EXPECT_LT((same - values).cwiseAbs().maxCoeff(), 1e-14);
}

// p' of Eq. 9 lies on the direction's own ray, in the flat triangle.
TEST(Resampling, InterpolatesAlongTheRay)
{
  const auto coarse = conformal::makeGeodesicSphere(3), fine = conformal::makeGeodesicSphere(11);
  const Points flat =
    resample(coarse.Positions, coarse.Positions, coarse.Triangles, fine.Positions);
  for (Index i = 0; i < flat.rows(); ++i)
  {
    EXPECT_LT((flat.row(i).normalized() - fine.Positions.row(i)).norm(), 1e-13);
    EXPECT_LE(flat.row(i).norm(), 1.0 + 1e-14);
    EXPECT_GT(flat.row(i).norm(), 0.9);
  }
}

TEST(Resampling, TurnsAMirroredMapRound)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  Points mirrored = sphere.Positions;
  mirrored.col(0) *= -1.0;
  const Points same = resample(mirrored, sphere.Positions, sphere.Triangles, sphere.Positions);
  EXPECT_LT((same - sphere.Positions).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Resampling, RefusesMapsThatFoldOrMiss)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  Points folded = sphere.Positions;
  folded.row(40) = -folded.row(40);
  EXPECT_THROW(
    resample(folded, sphere.Positions, sphere.Triangles, sphere.Positions), std::invalid_argument);
  const conformal::Triangles part = sphere.Triangles.topRows(20);
  EXPECT_THROW(
    resample(sphere.Positions, sphere.Positions, part, sphere.Positions), std::invalid_argument);
}
