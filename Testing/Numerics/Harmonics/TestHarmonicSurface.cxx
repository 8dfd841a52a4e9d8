#include "Harmonics/HarmonicSurface.h"

#include "Harmonics/SphericalHarmonics.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Columns;
using conformal::HarmonicSurface;
using conformal::Index;
using conformal::Points;

namespace
{
/// A sphere of radius 2 around (5, 0, 0), perhaps mirrored, with a value that is the height.
Columns ball(double sign)
{
  const double zero = std::sqrt(4.0 * conformal::Pi), one = std::sqrt(4.0 * conformal::Pi / 3.0);
  Columns coefficients = Columns::Zero(4, 4);
  coefficients(0, 0) = 5.0 * zero;
  coefficients(3, 0) = 2.0 * one * sign;
  coefficients(1, 1) = 2.0 * one;
  coefficients(2, 2) = 2.0 * one;
  coefficients(2, 3) = one;
  return coefficients;
}
}

TEST(HarmonicSurface, SphereIsOneSeenFromOutside)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const HarmonicSurface made = conformal::makeHarmonicSurface(ball(sign), 5);
    ASSERT_EQ(made.Positions.rows(), 252);
    const Points centered = made.Positions.rowwise() - Eigen::RowVector3d(5.0, 0.0, 0.0);
    EXPECT_LT((centered.rowwise().norm().array() - 2.0).abs().maxCoeff(), 1e-14);
    EXPECT_LT((made.Values.col(0) - made.SpherePositions.col(2)).cwiseAbs().maxCoeff(), 1e-15);
    for (Index t = 0; t < made.Triangles.rows(); ++t)
    {
      const conformal::Vector3 corner = centered.row(made.Triangles(t, 0));
      EXPECT_GT(corner.dot(conformal::areaVector(centered, made.Triangles, t)), 0.0);
    }
  }
}

TEST(HarmonicSurface, DegreesAreCutOff)
{
  EXPECT_EQ(conformal::upToDegree(Columns::Ones(16, 3), 1), Columns::Ones(4, 3));
  EXPECT_EQ(conformal::upToDegree(Columns::Ones(16, 3), 7), Columns::Ones(16, 3));
}

TEST(HarmonicSurface, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const HarmonicSurface one = conformal::makeHarmonicSurface(ball(1.0), 30),
                        two = conformal::makeHarmonicSurface(ball(1.0), 30, runs::backwards());
  EXPECT_EQ(one.Positions, two.Positions);
  EXPECT_EQ(one.Values, two.Values);
  EXPECT_THROW(
    conformal::makeHarmonicSurface(ball(1.0), 30, runs::stoppingAt(0.5)), conformal::Aborted);
}
