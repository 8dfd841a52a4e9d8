#include "Texture/Lemniscate.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>

#include <cmath>

using conformal::lemniscateArcsine;
using conformal::lemniscateSine;
using Complex = std::complex<double>;

// On the real axis, the integral is an elliptic integral of the first kind.
TEST(Lemniscate, IsAnEllipticIntegral)
{
  for (double x = 0.05; x < 1.0; x += 0.05)
  {
    // The substitution t = cos(u) turns 1 / sqrt(1 - t^4) into that of the modulus sqrt(1 / 2).
    const double k = std::sqrt(0.5);
    const double expected = k * (boost::math::ellint_1(k) - boost::math::ellint_1(k, std::acos(x)));
    EXPECT_NEAR(lemniscateArcsine(x).real(), expected, 1e-14);
  }
  EXPECT_NEAR(lemniscateArcsine(1.0).real(), conformal::HalfLemniscate, 1e-14);
}

TEST(Lemniscate, MapsTheCircleToASquareAndBack)
{
  for (double angle = 0.01; angle < 6.28; angle += 0.1)
  {
    const Complex on = std::polar(1.0, angle), z = lemniscateArcsine(on);
    EXPECT_NEAR(std::abs(z.real()) + std::abs(z.imag()), conformal::HalfLemniscate, 1e-13);
    for (const double radius : { 0.1, 0.6, 0.99 })
    {
      const Complex inside = std::polar(radius, angle);
      EXPECT_LT(std::abs(lemniscateSine(lemniscateArcsine(inside)) - inside), 1e-13);
    }
  }
}
