#include "Harmonics/HarmonicGrid.h"

#include "Harmonics/SphericalHarmonics.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Columns;
using conformal::HarmonicGrid;
using conformal::Index;
using conformal::numberOfHarmonics;

namespace
{
Columns someCoefficients(int degree, Index columns)
{
  Columns coefficients(numberOfHarmonics(degree), columns);
  for (Index i = 0; i < coefficients.size(); ++i)
  {
    coefficients(i) = std::sin(1.0 + 2.3 * static_cast<double>(i));
  }
  return coefficients;
}
}

TEST(HarmonicGrid, HarmonicsAreOrthonormal)
{
  const Index count = numberOfHarmonics(16);
  const HarmonicGrid grid(32);
  const Columns identity = Columns::Identity(count, count);
  const Columns found = grid.analyze(grid.synthesize(identity), 16);
  EXPECT_LT((found - identity).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(HarmonicGrid, GridTooSmallIsNot)
{
  const Index count = numberOfHarmonics(16);
  const HarmonicGrid grid(24);
  const Columns identity = Columns::Identity(count, count);
  const Columns found = grid.analyze(grid.synthesize(identity), 16);
  EXPECT_GT((found - identity).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(HarmonicGrid, SynthesisIsEvaluation)
{
  const HarmonicGrid grid(30);
  const Columns coefficients = someCoefficients(14, 2);
  const Columns expected = conformal::evaluateHarmonics(coefficients, grid.directions());
  EXPECT_LT((grid.synthesize(coefficients) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(HarmonicGrid, CoefficientsOfHighDegreeComeBack)
{
  const HarmonicGrid grid(512);
  const Columns coefficients = someCoefficients(256, 1);
  const Columns found = grid.analyze(grid.synthesize(coefficients), 256);
  EXPECT_LT((found - coefficients).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(HarmonicGrid, DegreeZeroHasAGridToo)
{
  const HarmonicGrid grid(0);
  EXPECT_NEAR(
    grid.analyze(Columns::Ones(grid.size(), 1), 0)(0, 0), std::sqrt(4.0 * conformal::Pi), 1e-14);
}

TEST(HarmonicGrid, ThreadsChangeNoBit)
{
  const HarmonicGrid grid(100);
  const Columns values = grid.synthesize(someCoefficients(50, 2));
  EXPECT_EQ(values, grid.synthesize(someCoefficients(50, 2), runs::backwards()));
  EXPECT_EQ(grid.analyze(values, 50), grid.analyze(values, 50, runs::backwards()));
}
