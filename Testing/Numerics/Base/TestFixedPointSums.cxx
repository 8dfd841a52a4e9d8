#include "Base/FixedPointSums.h"

#include "Base/Random.h"
#include "Ranks.h"

#include <gtest/gtest.h>

using conformal::FixedPointSums;

TEST(FixedPointSums, AnyOrderGivesTheSameBits)
{
  conformal::Random random(3);
  std::vector<double> values(10000);
  for (double& value : values)
  {
    value = 2.0 * random.uniform() - 1.0;
  }
  FixedPointSums forward(1), backward(1);
  double plain = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    forward.add(0, values[i]);
    backward.add(0, values[values.size() - 1 - i]);
    plain += values[i];
  }
  EXPECT_EQ(forward[0], backward[0]);
  EXPECT_NEAR(forward[0], plain, values.size() * 0x1p-39);
  forward.clear();
  EXPECT_EQ(forward[0], 0.0);
}

TEST(FixedPointSums, RanksAddUpToTheWhole)
{
  FixedPointSums whole(5);
  for (int i = 0; i < 1000; ++i)
  {
    whole.add(i % 5, 1.0 / (i + 3));
  }
  for (int size : { 2, 3 })
  {
    ranks::run(size,
      [&](const conformal::Reduce& reduce)
      {
        FixedPointSums part(5);
        for (int i = reduce.Rank; i < 1000; i += size)
        {
          part.add(i % 5, 1.0 / (i + 3));
        }
        part.reduce(reduce);
        for (int k = 0; k < 5; ++k)
        {
          EXPECT_EQ(part[k], whole[k]);
        }
      });
  }
}

TEST(FixedPointSums, GatherKeepsTheOrderOfRanksAndEveryBit)
{
  const std::vector<double> all = { 1.0 / 3.0, -0.0, 1e-300, 7.0, -1e300, 2.0 };
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      // Rank 0 has three numbers, rank 1 none, rank 2 the rest.
      const std::vector<double> own = reduce.Rank == 1 ? std::vector<double>()
        : reduce.Rank == 0 ? std::vector<double>(all.begin(), all.begin() + 3)
                           : std::vector<double>(all.begin() + 3, all.end());
      const std::vector<double> got = conformal::gather(reduce, own);
      ASSERT_EQ(got.size(), all.size());
      EXPECT_EQ(std::memcmp(got.data(), all.data(), all.size() * sizeof(double)), 0);
    });
}
