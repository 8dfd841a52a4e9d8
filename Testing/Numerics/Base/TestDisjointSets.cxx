#include "Base/DisjointSets.h"

#include <gtest/gtest.h>

#include <random>

using conformal::DisjointSets;

TEST(DisjointSets, AreOneForEachIdAtFirst)
{
  DisjointSets sets(4);
  for (int id = 0; id < 4; ++id)
  {
    EXPECT_EQ(sets.find(id), id);
  }
}

TEST(DisjointSets, UniteTellsWhetherSetsWereDifferent)
{
  DisjointSets sets(3);
  EXPECT_TRUE(sets.unite(2, 1));
  EXPECT_FALSE(sets.unite(1, 2));
  EXPECT_FALSE(sets.unite(0, 0));
}

TEST(DisjointSets, RenameChoosesTheName)
{
  DisjointSets sets(3);
  sets.rename(0, 2);
  EXPECT_EQ(sets.find(0), 2);
}

// Against sets that are kept as labels of all ids.
TEST(DisjointSets, AgreeWithLabelsAndAreNamedByTheSmallestId)
{
  constexpr int size = 200;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> anyId(0, size - 1);
  DisjointSets sets(size);
  std::vector<int> labels(size);
  std::iota(labels.begin(), labels.end(), 0);
  for (int step = 0; step < 250; ++step)
  {
    const int a = anyId(random), b = anyId(random);
    const int low = std::min(labels[a], labels[b]), high = std::max(labels[a], labels[b]);
    EXPECT_EQ(sets.unite(a, b), low != high);
    std::replace(labels.begin(), labels.end(), high, low);
    for (int id = 0; id < size; ++id)
    {
      ASSERT_EQ(sets.find(id), labels[id]);
    }
  }
}
