#include "Base/AcrossProcesses.h"

#include "Ranks.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Reduce;

TEST(AcrossProcesses, NumbersAddedInTurnHaveTheBitsOfOneProcess)
{
  constexpr Index size = 1000;
  const auto addPart = [](double* sum, Index begin, Index end)
  {
    for (Index i = begin; i < end; ++i)
    {
      sum[i % 2] += std::sin(static_cast<double>(i));
    }
  };
  double expected[2] = {};
  addPart(expected, 0, size);
  for (const int count : { 1, 2, 4 })
  {
    ranks::run(count,
      [&](const Reduce& reduce)
      {
        double sum[2] = {};
        const Index begin = reduce.Rank * size / count, end = (reduce.Rank + 1) * size / count;
        conformal::inTurn(reduce, sum, 2, [&] { addPart(sum, begin, end); });
        EXPECT_EQ(sum[0], expected[0]) << count;
        EXPECT_EQ(sum[1], expected[1]) << count;
      });
  }
}

TEST(AcrossProcesses, AnEmptyArrayIsUpdatedOnEachRank)
{
  ranks::run(2,
    [](const Reduce& reduce)
    {
      int calls = 0;
      conformal::inTurn(reduce, nullptr, 0, [&] { ++calls; });
      EXPECT_EQ(calls, 1) << reduce.Rank;
    });
}

TEST(AcrossProcesses, SmallestAndLargestAreOfAllRanks)
{
  ranks::run(4,
    [](const Reduce& reduce)
    {
      const double rank = reduce.Rank;
      const std::vector<double> own{ rank, -rank, std::abs(rank - 2.0) };
      EXPECT_EQ(conformal::maximum(reduce, own), (std::vector<double>{ 3.0, 0.0, 2.0 }));
      const std::vector<conformal::Minimum> least = conformal::minimum(reduce, own);
      ASSERT_EQ(least.size(), 3u);
      const std::vector<double> values{ 0.0, -3.0, 0.0 };
      const std::vector<int> owners{ 0, 3, 2 };
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_EQ(least[i].Value, values[i]) << i;
        EXPECT_EQ(least[i].Rank, owners[i]) << i;
      }
    });
}
