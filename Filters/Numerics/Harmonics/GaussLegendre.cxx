#include "Harmonics/GaussLegendre.h"

#include "Base/Types.h"

#include <cmath>

namespace conformal
{
namespace
{
struct LegendreValue
{
  double Value = 1.0;
  double Slope = 0.0;
};

// Evaluate the Legendre polynomial of a degree at x in (-1, 1), and its derivative.
LegendreValue legendrePolynomial(int degree, double x)
{
  double before = 0.0, value = 1.0;
  for (int l = 1; l <= degree; ++l)
  {
    const double next = ((2.0 * l - 1.0) * x * value - (l - 1.0) * before) / l;
    before = value;
    value = next;
  }
  return { value, degree * (before - x * value) / ((1.0 - x) * (1.0 + x)) };
}
}

//------------------------------------------------------------------------------
GaussLegendre makeGaussLegendre(int count)
{
  GaussLegendre rule;
  rule.Nodes.assign(count, 0.0);
  rule.Weights.assign(count, 0.0);
  for (int i = 0; 2 * i < count; ++i)
  {
    // Newton's iteration starts at Tricomi's estimate, and converges to the last digit in three
    // steps.
    const bool isMiddle = 2 * i + 1 == count;
    const double n = count, angle = Pi * (i + 0.75) / (n + 0.5);
    double x = isMiddle ? 0.0 : (1.0 - (n - 1.0) / (8.0 * n * n * n)) * std::cos(angle);
    constexpr int numberOfSteps = 4;
    for (int step = 0; step < numberOfSteps && !isMiddle; ++step)
    {
      const LegendreValue at = legendrePolynomial(count, x);
      x -= at.Value / at.Slope;
    }
    const double slope = legendrePolynomial(count, x).Slope;
    const double weight = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
    rule.Nodes[i] = x;
    rule.Nodes[count - 1 - i] = -x;
    rule.Weights[i] = rule.Weights[count - 1 - i] = weight;
  }
  return rule;
}
}
