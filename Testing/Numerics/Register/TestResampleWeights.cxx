#include "Register/ResampleWeights.h"

#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using conformal::blended;
using conformal::heaviestLabels;
using conformal::Index;
using conformal::resampleNumbers;
using conformal::ResampleWeights;
using conformal::restrictedTo;

namespace
{
/// A third of each of three points; all of one; a quarter and three quarters; nothing.
ResampleWeights fourPoints()
{
  ResampleWeights weights;
  weights.add({ { 0, 2.0 }, { 1, 2.0 }, { 2, 2.0 } });
  weights.add({ { 2, 7.0 } });
  weights.add({ { 1, 1.0 }, { 0, 3.0 }, { 2, 0.0 } });
  weights.add({});
  return weights;
}

/// Each of many points made of a few others.
ResampleWeights manyPoints(Index size)
{
  ResampleWeights weights;
  for (int i = 0; i < size; ++i)
  {
    weights.add(
      { { (7 * i) % 100, 1.0 + i % 3 }, { (i % 100) * (i % 100) % 100, 0.5 }, { i % 10, 0.1 } });
  }
  return weights;
}

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Largest = std::numeric_limits<double>::max();
}

TEST(ResampleWeights, AddUpToOne)
{
  const ResampleWeights weights = fourPoints();
  ASSERT_EQ(weights.size(), 4);
  EXPECT_EQ(weights.Offsets, (std::vector<Index>{ 0, 3, 4, 6, 6 }));
  EXPECT_EQ(weights.Ids, (std::vector<int>{ 0, 1, 2, 2, 1, 0 }));
  EXPECT_EQ(
    weights.Weights, (std::vector<double>{ 2.0 / 6.0, 2.0 / 6.0, 2.0 / 6.0, 1.0, 0.25, 0.75 }));
}

TEST(ResampleWeights, MeansAreWeighted)
{
  const auto numbers = resampleNumbers(fourPoints(), { 1.0, 10.0, 5.0, 20.0, 0.0, 30.0 }, 2);
  const std::vector<double> expected = { 2.0, 20.0, 0.0, 30.0, 2.0, 12.5, 0.0, 0.0 };
  ASSERT_EQ(numbers.Values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(numbers.Values[i], expected[i], 1e-14);
  }
  EXPECT_EQ(numbers.NumberOfMissing, 0);
}

TEST(ResampleWeights, MeansStayWithinTheirNumbers)
{
  for (const double value : { 0.1, -1e-300, Largest, -Largest })
  {
    const auto numbers = resampleNumbers(manyPoints(500), std::vector<double>(100, value), 1);
    EXPECT_EQ(numbers.Values, std::vector<double>(500, value));
  }
}

TEST(ResampleWeights, NumbersThatAreNotFiniteDoNotCount)
{
  const auto numbers = resampleNumbers(fourPoints(), { 1.0, 5.0, NaN }, 1);
  EXPECT_NEAR(numbers.Values[0], 3.0, 1e-15);
  EXPECT_EQ(numbers.Values[1], 0.0);
  EXPECT_NEAR(numbers.Values[2], 2.0, 1e-15);
  EXPECT_EQ(numbers.NumberOfMissing, 1); // a point without weights is not missing
  EXPECT_EQ(resampleNumbers(fourPoints(), { HUGE_VAL, 5.0, -HUGE_VAL }, 1).Values[0], 5.0);
}

TEST(ResampleWeights, LabelsGoByTheirTotalWeight)
{
  ResampleWeights weights;
  weights.add({ { 0, 0.4 }, { 1, 0.3 }, { 2, 0.3 } });
  weights.add({ { 2, 0.25 }, { 0, 0.25 }, { 3, 0.5 } });
  weights.add({});
  // Points 1 and 2 share a label and outweigh point 0; a tie goes to the smallest label.
  EXPECT_EQ(heaviestLabels(weights, { 9.0, 4.0, 4.0, 9.0 }), (std::vector<int>{ 1, 0, -1 }));
  EXPECT_EQ(heaviestLabels(weights, { 1.0, 4.0, 4.0, -3.0 })[1], 3);
}

TEST(ResampleWeights, MaskedPointsLeaveTheirWeightToTheOthers)
{
  const ResampleWeights rest = restrictedTo(fourPoints(), { 1, 0, 1 });
  EXPECT_EQ(rest.Ids, (std::vector<int>{ 0, 2, 2, 0 }));
  EXPECT_EQ(rest.Weights, (std::vector<double>{ 0.5, 0.5, 1.0, 1.0 }));
  EXPECT_EQ(restrictedTo(fourPoints(), { 0, 0, 0 }).Offsets, std::vector<Index>(5, 0));
}

TEST(ResampleWeights, SurfacesAreBlendedByTheirShares)
{
  const ResampleWeights one = fourPoints();
  const ResampleWeights both = blended({ &one, &one }, { 3, 3 }, { 0.25, 0.75 });
  const std::vector<double> ofOne = { 1.0, 5.0, 0.0 }, ofOther = { 4.0, -2.0, 8.0 };
  const auto a = resampleNumbers(one, ofOne, 1), b = resampleNumbers(one, ofOther, 1);
  const auto mean = resampleNumbers(both, { 1.0, 5.0, 0.0, 4.0, -2.0, 8.0 }, 1);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(mean.Values[i], 0.25 * a.Values[i] + 0.75 * b.Values[i], 1e-14);
  }
  // A share of 0 leaves the bits of the other one.
  const ResampleWeights first = blended({ &one, &one }, { 3, 3 }, { 1.0, 0.0 });
  EXPECT_EQ(first.Ids, one.Ids);
  EXPECT_EQ(first.Weights, one.Weights);
}

TEST(ResampleWeights, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const ResampleWeights weights = manyPoints(200000);
  std::vector<double> values(100);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = std::sin(static_cast<double>(i));
  }
  EXPECT_EQ(resampleNumbers(weights, values, 1).Values,
    resampleNumbers(weights, values, 1, runs::backwards()).Values);
  EXPECT_EQ(heaviestLabels(weights, values), heaviestLabels(weights, values, runs::backwards()));
  EXPECT_THROW(resampleNumbers(weights, values, 1, runs::stoppingAt(0.5)), conformal::Aborted);
  EXPECT_THROW(heaviestLabels(weights, values, runs::stoppingAt(0.5)), conformal::Aborted);
}
