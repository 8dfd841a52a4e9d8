#include "Harmonics/GaussLegendre.h"

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using conformal::GaussLegendre;
using conformal::makeGaussLegendre;

TEST(GaussLegendre, NodesAndWeightsAreThoseOfBoost)
{
  using Known = boost::math::quadrature::gauss<double, 30>;
  const GaussLegendre rule = makeGaussLegendre(30);
  for (std::size_t i = 0; i < Known::abscissa().size(); ++i)
  {
    EXPECT_NEAR(rule.Nodes[14 - i], Known::abscissa()[i], 2e-16);
    EXPECT_NEAR(rule.Weights[14 - i], Known::weights()[i], 5e-16);
    EXPECT_EQ(rule.Nodes[15 + i], -rule.Nodes[14 - i]);
  }
}

TEST(GaussLegendre, PolynomialsAreIntegratedExactlyUpToTheirDegree)
{
  for (const int count : { 1, 2, 3, 10, 17 })
  {
    const GaussLegendre rule = makeGaussLegendre(count);
    for (int power = 0; power <= 2 * count; ++power)
    {
      double sum = 0.0;
      for (int i = 0; i < count; ++i)
      {
        sum += rule.Weights[i] * std::pow(rule.Nodes[i], power);
      }
      const double exact = power % 2 == 0 ? 2.0 / (power + 1.0) : 0.0;
      if (power < 2 * count)
      {
        EXPECT_NEAR(sum, exact, 1e-14) << count << " nodes, power " << power;
      }
      else
      {
        EXPECT_GT(std::abs(sum - exact), 1e-12) << count;
      }
    }
  }
}

TEST(GaussLegendre, ManyNodesAreDifferentAndTheirWeightsAddUp)
{
  const GaussLegendre rule = makeGaussLegendre(2049);
  for (std::size_t i = 1; i < rule.Nodes.size(); ++i)
  {
    EXPECT_LT(rule.Nodes[i], rule.Nodes[i - 1]);
  }
  EXPECT_NEAR(std::accumulate(rule.Weights.begin(), rule.Weights.end(), 0.0), 2.0, 1e-12);
}
