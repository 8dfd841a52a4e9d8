#include "Base/KeptIds.h"

#include <gtest/gtest.h>

#include <vector>

using conformal::Index;
using conformal::KeptIds;

TEST(KeptIds, NumbersWhatIsKept)
{
  for (Index step : { 1, 2, 7, 600 })
  {
    const Index size = 5000;
    const KeptIds kept(size, [&](Index id) { return id % step == 3 % step; });
    std::vector<Index> expected;
    for (Index id = 3 % step; id < size; id += step)
    {
      expected.push_back(id);
    }
    ASSERT_EQ(kept.size(), static_cast<Index>(expected.size())) << step;
    for (Index i = 0; i < kept.size(); ++i)
    {
      ASSERT_EQ(kept[i], expected[i]) << step;
    }
  }
}

TEST(KeptIds, NoneAndLast)
{
  EXPECT_EQ(KeptIds(0, [](Index) { return true; }).size(), 0);
  EXPECT_EQ(KeptIds(100, [](Index) { return false; }).size(), 0);
  const KeptIds last(1025, [](Index id) { return id == 1024; });
  ASSERT_EQ(last.size(), 1);
  EXPECT_EQ(last[0], 1024);
}
