#include "Volume/LayerSampler.h"

#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::layerDepths;
using conformal::LayerSampler;
using conformal::LayerSummary;
using conformal::Vector3;
using conformal::VolumeImage;

namespace
{
// A plane sheet at z = 0.7, 2 thick.
VolumeImage sheet()
{
  return volumes::of({ 21, 21, 41 }, { 0.5, 0.5, 0.5 },
    [](const Vector3& x) { return std::exp(-0.5 * std::pow(x[2] - 0.7, 2)); });
}
}

TEST(LayerSampler, FindsTheDepthOfASheet)
{
  const VolumeImage volume = sheet();
  const LayerSampler sampler(volume, layerDepths(-3.0, 3.0, 13), -3.0, 3.0);
  for (const double z : { -1.0, 0.0, 0.33, 1.9 })
  {
    std::vector<float> values(13);
    sampler.sample({ 0.2, -0.4, z }, { 0, 0, 1 }, 9.0, 9.0, values.data());
    const LayerSummary summary = sampler.summarize(values.data(), 9.0, 9.0);
    EXPECT_NEAR(summary.DepthOfMaximum, 0.7 - z, 0.05) << z;
    EXPECT_NEAR(summary.Maximum, 1.0, 0.06);
    double sum = 0.0;
    for (const float value : values)
    {
      sum += value / 13.0;
    }
    EXPECT_NEAR(summary.Mean, sum, 1e-6);
  }
}

// Behind a limit, the value at the limit is repeated, and is not part of the summary.
TEST(LayerSampler, EndsAtTheLimits)
{
  const VolumeImage volume = sheet();
  const LayerSampler sampler(volume, layerDepths(-3.0, 3.0, 13), -3.0, 3.0);
  std::vector<float> values(13), limited(13);
  const Vector3 x(0.0, 0.0, -1.0), n(0, 0, 1);
  sampler.sample(x, n, 9.0, 9.0, values.data());
  sampler.sample(x, n, 1.0, 0.5, limited.data());
  for (int i = 0; i < 13; ++i)
  {
    EXPECT_EQ(limited[i], values[std::clamp(i, 4, 7)]);
  }
  const LayerSummary summary = sampler.summarize(limited.data(), 1.0, 0.5);
  EXPECT_EQ(summary.DepthOfMaximum, 0.5);
  EXPECT_NEAR(summary.Mean, (values[4] + values[5] + values[6] + values[7]) / 4.0, 1e-6);
  const LayerSummary far =
    LayerSampler(volume, layerDepths(-3.0, 3.0, 13), 2.0, 3.0).summarize(limited.data(), 1.0, 0.5);
  EXPECT_EQ(far.Maximum, limited[10]);
  EXPECT_EQ(far.DepthOfMaximum, 0.5);
}

// The depths of these layers are rounded, and some of them are beyond the ends of the range.
TEST(LayerSampler, LayersAtTheEndsOfTheRangeAreUsed)
{
  const VolumeImage volume = sheet();
  const auto meanOf = [&](const std::vector<double>& depths, double first, double last)
  {
    std::vector<float> values;
    for (const double depth : depths)
    {
      const bool isAtEnd = std::min(std::abs(depth - first), std::abs(depth - last)) < 1e-6;
      values.push_back(isAtEnd ? 1.0F : 0.0F);
    }
    return LayerSampler(volume, depths, first, last).summarize(values.data(), 9.0, 9.0).Mean;
  };
  EXPECT_NEAR(meanOf(layerDepths(-1.0, 1.0, 21), -0.3, 0.3), 2.0 / 7.0, 1e-12);
  EXPECT_NEAR(meanOf(layerDepths(-2.0, 2.0, 21), -0.6, 0.6), 2.0 / 7.0, 1e-12);
  EXPECT_NEAR(meanOf(layerDepths(-3.0, 3.0, 31), -1.4, 1.4), 2.0 / 15.0, 1e-12);
  EXPECT_NEAR(meanOf(layerDepths(-3.0, 3.0, 31), 1.2, 1.2), 1.0, 1e-12);
}

TEST(LayerSampler, IsZeroOutsideOfTheImage)
{
  const VolumeImage volume =
    volumes::of({ 3, 3, 3 }, { 1, 1, 1 }, [](const Vector3&) { return 5; });
  const LayerSampler sampler(volume, layerDepths(-4.0, 4.0, 9), -4.0, 4.0);
  std::vector<float> values(9);
  sampler.sample({ 0, 0, 0 }, { 1, 0, 0 }, 9.0, 9.0, values.data());
  EXPECT_EQ(values, std::vector<float>({ 0, 0, 0, 5, 5, 5, 0, 0, 0 }));
}

TEST(LayerSampler, UnsuitableArgumentsAreRefused)
{
  EXPECT_EQ(layerDepths(-1.0, 2.0, 1), std::vector<double>({ 0.5 }));
  const VolumeImage volume = sheet();
  EXPECT_THROW(LayerSampler(volume, layerDepths(0.0, 1.0, 2), 2.0, 3.0), std::invalid_argument);
  EXPECT_THROW(LayerSampler({}, layerDepths(0.0, 1.0, 2), 0.0, 1.0), std::invalid_argument);
}
