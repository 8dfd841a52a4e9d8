#include "Cloud/SampleSpacing.h"

#include "Base/Random.h"
#include "Ranks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using conformal::Index;
using conformal::Points;
using conformal::SampleSpacing;

namespace
{
double meanSpacing(const Points& points, double margin)
{
  const SampleSpacing spacing(points);
  std::vector<conformal::Neighbor> around;
  double sum = 0.0;
  int count = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const auto inner = points.row(i).head<2>().array();
    if (inner.minCoeff() > margin && inner.maxCoeff() < 1.0 - margin)
    {
      sum += std::pow(spacing.at(i, around).spacing(), 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}
}

// The spacing is the side of the square that a point represents.
TEST(SampleSpacing, IsThatOfRandomPoints)
{
  conformal::Random random(3);
  Points points = Points::Zero(10000, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) << random.uniform(), random.uniform(), 0.0;
  }
  EXPECT_NEAR(meanSpacing(points, 0.1), 0.01, 0.0005);
}

TEST(SampleSpacing, LooksAcrossScanLines)
{
  const int lines = 20, perLine = 400;
  Points points = Points::Zero(lines * perLine, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) << (static_cast<double>(i % perLine) + 0.5) / perLine,
      (static_cast<double>(i / perLine) + 0.5) / lines, 0.0; // NOLINT(bugprone-integer-division)
  }
  const double spacing = meanSpacing(points, 0.2);
  EXPECT_GT(spacing, 0.005);
  EXPECT_LT(spacing, 0.025); // one point represents a square of 0.011
}

TEST(SampleSpacing, ASinglePointHasNone)
{
  const Points point = Points::Zero(1, 3);
  std::vector<conformal::Neighbor> around;
  EXPECT_EQ(SampleSpacing(point).at(0, around).spacing(), 0.0);
}
