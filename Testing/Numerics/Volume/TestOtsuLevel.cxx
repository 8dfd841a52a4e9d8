#include "Volume/OtsuLevel.h"

#include "Base/Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::otsuLevel;

namespace
{
// Eq. 14 of the paper by its definition: the variance between the values below and above a level.
double betweenVariance(const std::vector<float>& values, double level)
{
  double sums[2] = { 0.0, 0.0 }, counts[2] = { 0.0, 0.0 };
  for (const float value : values)
  {
    const int side = value > level;
    sums[side] += value;
    counts[side] += 1.0;
  }
  const double apart = sums[1] / counts[1] - sums[0] / counts[0];
  return counts[0] * counts[1] * apart * apart;
}
}

TEST(OtsuLevel, NoOtherLevelSeparatesBetter)
{
  conformal::Random random(3);
  std::vector<float> values;
  for (int i = 0; i < 4000; ++i)
  {
    const double noise = random.uniform() + random.uniform() + random.uniform();
    values.push_back(static_cast<float>(i % 4 == 0 ? 300.0 + 40.0 * noise : 90.0 + 50.0 * noise));
  }
  const double level = otsuLevel(values), best = betweenVariance(values, level);
  for (double other = 95.0; other < 410.0; other += 0.5)
  {
    EXPECT_LE(betweenVariance(values, other), best * (1.0 + 1e-4)) << other;
  }
}

// Between two separate groups, all levels are equally good. The middle is the safest.
TEST(OtsuLevel, IsBetweenTwoGroups)
{
  std::vector<float> values(100, 10.0F);
  values.insert(values.end(), 20, 50.0F);
  EXPECT_NEAR(otsuLevel(values), 30.0, 0.1);
  EXPECT_EQ(otsuLevel(std::vector<float>(5, 3.0F)), 3.0);
  EXPECT_THROW(otsuLevel({}), std::invalid_argument);
  EXPECT_THROW(otsuLevel(values, runs::stoppingAt(0.5)), conformal::Aborted);
}
