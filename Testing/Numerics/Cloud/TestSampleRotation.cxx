#include "Cloud/SampleRotation.h"

#include "Clouds.h"
#include "Ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

using conformal::Index;
using conformal::Points;
using conformal::SampleRotation;
using conformal::TrainingSamples;

namespace
{
Points someCloud(Index size)
{
  return clouds::inUnitCube(size, 2);
}

std::vector<Index> idsOf(const SampleRotation& rotation)
{
  std::vector<Index> ids;
  for (Index i = 0; i < rotation.count(); ++i)
  {
    ids.push_back(rotation.id(i));
  }
  return ids;
}
}

TEST(SampleRotation, FewPatternsAreAllTakenOnceAndInOrder)
{
  const Points points = someCloud(777);
  const TrainingSamples samples(points);
  SampleRotation rotation(samples, 1);
  for (int turn = 0; turn < 3; ++turn)
  {
    rotation.turn(1000);
    ASSERT_EQ(rotation.count(), 777);
    for (Index i = 0; i < 777; ++i)
    {
      EXPECT_EQ(rotation.id(i), i);
    }
  }
}

TEST(SampleRotation, EvenlySpacedAndAllAreHeardInTheEnd)
{
  const Points points = someCloud(1000);
  const TrainingSamples samples(points);
  SampleRotation rotation(samples, 1);
  std::set<Index> heard;
  for (int turn = 0; turn < 40; ++turn)
  {
    rotation.turn(100);
    const std::vector<Index> ids = idsOf(rotation);
    ASSERT_EQ(ids.size(), 100u);
    for (std::size_t i = 1; i < ids.size(); ++i)
    {
      EXPECT_GE(ids[i] - ids[i - 1], 9);
      EXPECT_LE(ids[i] - ids[i - 1], 11);
    }
    heard.insert(ids.begin(), ids.end());
  }
  EXPECT_EQ(heard.size(), 1000u);
}

TEST(SampleRotation, RanksTakeWhatOneWouldTake)
{
  const Points points = someCloud(1003);
  const TrainingSamples samples(points);
  std::vector<std::vector<Index>> expected;
  SampleRotation whole(samples, 9);
  for (int turn = 0; turn < 4; ++turn)
  {
    whole.turn(150);
    expected.push_back(idsOf(whole));
  }
  const std::vector<Index> firsts = { 0, 400, 400, 1003 }; // the second rank has none
  std::vector<std::vector<std::vector<Index>>> parts(3);
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = firsts[reduce.Rank], size = firsts[reduce.Rank + 1] - first;
      const Points own = points.middleRows(first, size);
      const TrainingSamples part(own, {}, {}, reduce);
      SampleRotation rotation(part, 9);
      for (int turn = 0; turn < 4; ++turn)
      {
        rotation.turn(150);
        parts[reduce.Rank].push_back(idsOf(rotation));
        for (Index& id : parts[reduce.Rank].back())
        {
          id += first;
        }
      }
    });
  for (int turn = 0; turn < 4; ++turn)
  {
    std::vector<Index> together;
    for (const auto& part : parts)
    {
      together.insert(together.end(), part[turn].begin(), part[turn].end());
    }
    EXPECT_EQ(together, expected[turn]) << turn;
  }
}
