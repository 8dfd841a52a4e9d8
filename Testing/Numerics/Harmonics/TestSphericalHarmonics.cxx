#include "Harmonics/SphericalHarmonics.h"

#include "Runs.h"
#include "Spheres.h"

#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

using conformal::Columns;
using conformal::harmonicIndex;
using conformal::Index;
using conformal::numberOfHarmonics;
using conformal::Points;
using conformal::Vector3;

namespace
{
/// All functions of a degree at some directions, one column each.
Columns all(int degree, const Points& directions)
{
  const Index count = numberOfHarmonics(degree);
  return conformal::evaluateHarmonics(Columns::Identity(count, count), directions);
}

double known(int degree, int order, const Vector3& p)
{
  const double theta = std::acos(p[2]), phi = std::atan2(p[1], p[0]);
  const int m = std::abs(order);
  const double sign = m % 2 == 0 ? 1.0 : -1.0; // of the Condon-Shortley phase
  return order == 0 ? boost::math::spherical_harmonic_r(degree, 0, theta, phi)
    : order > 0 ? sign * std::sqrt(2.0) * boost::math::spherical_harmonic_r(degree, m, theta, phi)
                : sign * std::sqrt(2.0) * boost::math::spherical_harmonic_i(degree, m, theta, phi);
}
}

TEST(SphericalHarmonics, ValuesAreThoseOfBoostWithoutItsPhase)
{
  const Points directions = spheres::random(100);
  const Columns values = all(10, directions);
  for (int l = 0; l <= 10; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      for (Index i = 0; i < directions.rows(); ++i)
      {
        EXPECT_NEAR(values(i, harmonicIndex(l, m)), known(l, m, directions.row(i)), 1e-13);
      }
    }
  }
}

TEST(SphericalHarmonics, FirstDegreesAreWhatTheHeaderSays)
{
  Points directions(3, 3);
  directions << 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.36, 0.48, 0.8;
  const Columns values = all(1, directions);
  for (Index i = 0; i < 3; ++i)
  {
    const double one = std::sqrt(3.0 / (4.0 * conformal::Pi));
    EXPECT_NEAR(values(i, 0), std::sqrt(1.0 / (4.0 * conformal::Pi)), 1e-15);
    EXPECT_NEAR(values(i, 1), one * directions(i, 1), 1e-15);
    EXPECT_NEAR(values(i, 2), one * directions(i, 2), 1e-15);
    EXPECT_NEAR(values(i, 3), one * directions(i, 0), 1e-15);
  }
}

// Sum over orders of Y_lm(p) Y_lm(q) is (2 l + 1) / (4 pi) P_l(p . q): for p = q also at degree
// 256.
TEST(SphericalHarmonics, AdditionTheoremHoldsToDegree256)
{
  const Points directions = spheres::random(3);
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const Columns values = conformal::harmonicMoments(directions.row(i), Columns::Ones(1, 1), 256);
    for (const int l : { 1, 50, 128, 256 })
    {
      const double sum = values.middleRows(harmonicIndex(l, -l), 2 * l + 1).squaredNorm();
      EXPECT_NEAR(sum, (2.0 * l + 1.0) / (4.0 * conformal::Pi), 1e-11);
    }
  }
}

TEST(SphericalHarmonics, MomentsAreTheTranspose)
{
  const Points directions = spheres::random(777);
  Columns values(777, 2);
  for (Index i = 0; i < values.size(); ++i)
  {
    values(i) = std::sin(1.7 * static_cast<double>(i));
  }
  const Columns expected = all(9, directions).transpose() * values;
  const Columns moments = conformal::harmonicMoments(directions, values, 9);
  EXPECT_LT((moments - expected).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(SphericalHarmonics, DegreesAreCountedAndOthersRefused)
{
  EXPECT_EQ(conformal::degreeOfHarmonics(1), 0);
  EXPECT_EQ(conformal::degreeOfHarmonics(169), 12);
  EXPECT_THROW(conformal::degreeOfHarmonics(0), std::invalid_argument);
  EXPECT_THROW(conformal::degreeOfHarmonics(168), std::invalid_argument);
  EXPECT_THROW(
    conformal::degreeOfHarmonics(numberOfHarmonics(conformal::MaximumHarmonicDegree + 1)),
    std::invalid_argument);
  Columns coefficients = Columns::Zero(9, 2);
  coefficients(0, 0) = 3.0;
  coefficients(1, 1) = 1.0;
  coefficients(3, 0) = 2.0;
  EXPECT_EQ(conformal::powerPerDegree(coefficients), Eigen::Vector3d(9.0, 5.0, 0.0));
}

TEST(SphericalHarmonics, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const Points directions = spheres::random(5000);
  const Columns one = conformal::harmonicMoments(directions, directions, 20);
  EXPECT_EQ(one, conformal::harmonicMoments(directions, directions, 20, runs::backwards()));
  EXPECT_EQ(conformal::evaluateHarmonics(one, directions),
    conformal::evaluateHarmonics(one, directions, runs::backwards()));
  EXPECT_THROW(conformal::harmonicMoments(directions, directions, 20, runs::stoppingAt(0.5)),
    conformal::Aborted);
  EXPECT_THROW(
    conformal::evaluateHarmonics(one, directions, runs::stoppingAt(0.5)), conformal::Aborted);
}
