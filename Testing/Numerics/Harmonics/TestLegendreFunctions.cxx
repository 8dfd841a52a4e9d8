#include "Harmonics/LegendreFunctions.h"

#include "Harmonics/GaussLegendre.h"

#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using conformal::GaussLegendre;
using conformal::Index;
using conformal::LegendreBlock;
using conformal::LegendreFunctions;
using conformal::LegendreLane;
using conformal::LegendreLanes;
using conformal::Pi;

namespace
{
/// Of one order at 64 angles from the north pole.
LegendreBlock functionsOf(int degree, int order, const LegendreLane& angles)
{
  LegendreLane heights, logRadii;
  for (Index i = 0; i < LegendreLanes; ++i)
  {
    heights[i] = std::cos(angles[i]); // as Boost does: near a pole its last bit tells
    logRadii[i] = std::log2(std::sin(angles[i]));
  }
  LegendreBlock values(LegendreLanes, degree - order + 1);
  LegendreFunctions(degree).evaluate(order, heights, logRadii, values);
  return values;
}

double known(int degree, int order, double angle)
{
  const double norm = order == 0 ? 1.0 : std::sqrt(2.0) * (order % 2 == 0 ? 1.0 : -1.0);
  return norm * boost::math::spherical_harmonic_r(degree, order, angle, 0.0);
}
}

TEST(LegendreFunctions, ValuesAreThoseOfBoost)
{
  const LegendreLane angles = LegendreLane::LinSpaced(0.01, 3.1);
  for (int order = 0; order <= 12; ++order)
  {
    const LegendreBlock values = functionsOf(24, order, angles);
    for (int degree = order; degree <= 24; ++degree)
    {
      for (Index i = 0; i < LegendreLanes; ++i)
      {
        const double expected = known(degree, order, angles[i]);
        EXPECT_NEAR(values(i, degree - order), expected, 5e-14) << degree << " " << order;
      }
    }
  }
}

// P_mm of order 512 is 1e-500 where that of degree 1024 is near 1.
TEST(LegendreFunctions, HighOrdersNearThePoleAreNotLost)
{
  constexpr int degree = 1024, nodes = 1088;
  const GaussLegendre rule = conformal::makeGaussLegendre(nodes);
  const LegendreFunctions functions(degree);
  for (const int order : { 1, 100, 300, 512, 800 })
  {
    LegendreBlock values(LegendreLanes, degree - order + 1);
    double norm = 0.0, product = 0.0;
    for (int begin = 0; begin < nodes; begin += LegendreLanes)
    {
      LegendreLane heights, logRadii;
      for (int i = 0; i < LegendreLanes; ++i)
      {
        heights[i] = rule.Nodes[begin + i];
        logRadii[i] = 0.5 * std::log2((1.0 - heights[i]) * (1.0 + heights[i]));
      }
      functions.evaluate(order, heights, logRadii, values);
      ASSERT_TRUE(values.allFinite()) << order;
      for (int i = 0; i < LegendreLanes; ++i)
      {
        const double last = values(i, degree - order), other = values(i, degree - order - 2);
        norm += Pi * rule.Weights[begin + i] * last * last;
        product += Pi * rule.Weights[begin + i] * last * other;
      }
    }
    EXPECT_NEAR(norm, 1.0, 1e-12) << order;
    EXPECT_NEAR(product, 0.0, 1e-12) << order;
  }
}

TEST(LegendreFunctions, AtThePolesOnlyOrderZeroIsLeft)
{
  const LegendreLane north = LegendreLane::Ones(),
                     none = LegendreLane::Constant(-std::numeric_limits<double>::infinity());
  const LegendreFunctions functions(20);
  LegendreBlock values(LegendreLanes, 21);
  functions.evaluate(0, north, none, values);
  for (int degree = 0; degree <= 20; ++degree)
  {
    EXPECT_NEAR(values(0, degree), std::sqrt((2.0 * degree + 1.0) / (4.0 * Pi)), 1e-14);
  }
  functions.evaluate(3, north, none, values);
  EXPECT_EQ(values.leftCols(18).cwiseAbs().maxCoeff(), 0.0);
}
