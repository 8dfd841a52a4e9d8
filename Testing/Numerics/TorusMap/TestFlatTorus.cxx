#include "TorusMap/FlatTorus.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <random>
#include <stdexcept>

using conformal::FlatTorus;
using conformal::reduceBasis;
using conformal::ReducedBasis;

namespace
{
Eigen::Matrix2i randomUnimodular(std::mt19937& random)
{
  Eigen::Matrix2i result = Eigen::Matrix2i::Identity();
  std::uniform_int_distribution<int> multiple(-3, 3);
  for (int i = 0; i < 4; ++i)
  {
    Eigen::Matrix2i shear, turn;
    shear << 1, multiple(random), 0, 1;
    turn << 0, -1, 1, 0;
    result = (result * shear * turn).eval();
  }
  return result;
}
}

TEST(FlatTorus, HasAreaOneAndItsModulus)
{
  const FlatTorus torus{ { 0.3, 1.7 } };
  const Eigen::Matrix2d periods = torus.periods();
  EXPECT_NEAR(periods.determinant(), 1.0, 1e-15);
  EXPECT_EQ(periods(1, 0), 0.0);
  EXPECT_NEAR(periods(0, 1) / periods(0, 0), 0.3, 1e-15);
  EXPECT_NEAR(periods(1, 1) / periods(0, 0), 1.7, 1e-15);
}

// Bases of one lattice are reduced to one modulus, in the fundamental domain.
TEST(FlatTorus, ReducesAllBasesOfALatticeToOneModulus)
{
  std::mt19937 random(1);
  for (const std::complex<double> tau : { std::complex<double>(0.31, 1.28),
         std::complex<double>(-0.49, 0.9), std::complex<double>(0.0, 1.0),
         std::complex<double>(0.5, std::sqrt(0.75)), std::complex<double>(0.5, 4.0) })
  {
    const Eigen::Matrix2d periods = FlatTorus{ tau }.periods();
    for (int i = 0; i < 50; ++i)
    {
      const Eigen::Matrix2i change = randomUnimodular(random);
      ASSERT_EQ(change.determinant(), 1);
      const Eigen::Matrix2d given = 3.0 * periods * change.cast<double>();
      const ReducedBasis basis = reduceBasis(given.transpose() * given);
      EXPECT_NEAR(std::abs(basis.Torus.Modulus - tau), 0.0, 1e-8) << tau;
      EXPECT_EQ(basis.Change.determinant(), 1);
      // Fractions of the given periods and of the reduced periods describe one point of a plane
      // that is turned.
      const Eigen::Matrix2d reduced = 3.0 * basis.Torus.periods() * basis.Change.cast<double>();
      const Eigen::Matrix2d rotation = reduced * given.inverse();
      EXPECT_NEAR(
        (rotation.transpose() * rotation - Eigen::Matrix2d::Identity()).norm(), 0.0, 1e-9);
      EXPECT_NEAR(rotation.determinant(), 1.0, 1e-9);
    }
  }
}

TEST(FlatTorus, RejectsDependentPeriods)
{
  Eigen::Matrix2d gram;
  gram << 1.0, 2.0, 2.0, 4.0;
  EXPECT_THROW(reduceBasis(gram), std::invalid_argument);
  EXPECT_THROW(reduceBasis(-Eigen::Matrix2d::Identity()), std::invalid_argument);
  EXPECT_THROW(reduceBasis(Eigen::Matrix2d::Constant(std::nan(""))), std::invalid_argument);
}
