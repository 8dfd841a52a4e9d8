#include "Cloud/Copies.h"

#include "Ranks.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using conformal::Copies;
using conformal::findCopies;
using conformal::Index;
using conformal::Points;

namespace
{
// The points, one time after another.
Points repeated(const Points& points, Index times)
{
  return points.replicate(times, 1);
}

void expectCopiesFrom(const Copies& copies, Index size, Index first)
{
  for (Index i = 0; i < size; ++i)
  {
    ASSERT_EQ(copies.contains(i), i >= first) << i;
  }
}
}

TEST(Copies, AreAllButTheFirstOfAPosition)
{
  const Points points = spheres::random(1000);
  EXPECT_EQ(findCopies(points).Count, 0);
  EXPECT_TRUE(findCopies(points).IsCopy.empty());
  for (const Index times : { 2, 7 })
  {
    const Copies copies = findCopies(repeated(points, times));
    EXPECT_EQ(copies.Count, (times - 1) * 1000);
    expectCopiesFrom(copies, times * 1000, 1000);
  }
}

TEST(Copies, HaveEqualCoordinatesNotBits)
{
  Points points(4, 3);
  points << 0.0, 1.0, 2.0, -0.0, 1.0, 2.0, 1.0, 0.0, 2.0, 0.0, 1.0, 2.0 + 1e-15;
  const Copies copies = findCopies(points);
  EXPECT_EQ(copies.Count, 1);
  EXPECT_TRUE(copies.contains(1));
}

TEST(Copies, AreNotPointsThatAreSkippedOrNotFinite)
{
  Points points = repeated(spheres::random(100), 2);
  points(0, 0) = points(1, 1) = std::numeric_limits<double>::quiet_NaN();
  points.row(101) = points.row(1);
  const Copies copies = findCopies(points, [](Index i) { return i == 2 || i == 103; });
  EXPECT_EQ(copies.Count, 96);
  expectCopiesFrom(copies, 200, 104);
}

// Above 2^20 points there are parts. If there are few copies, the first part has some.
TEST(Copies, AreFoundInLargeClouds)
{
  const Index size = 1 << 20;
  const Points points = spheres::random(size);
  Points all(size + 2000, 3);
  all << points, points.topRows(2000);
  const Copies copies = findCopies(all);
  EXPECT_EQ(copies.Count, 2000);
  expectCopiesFrom(copies, all.rows(), size);
}

TEST(Copies, AreTheSameOnAnyThreadsAndRanks)
{
  const Points points = repeated(spheres::random(20000), 3);
  const Copies whole = findCopies(points);
  EXPECT_EQ(findCopies(points, {}, {}, runs::backwards()).IsCopy, whole.IsCopy);
  ranks::run(4,
    [&](const conformal::Reduce& reduce)
    {
      // The last process has no points.
      const Index parts = reduce.NumberOfRanks - 1;
      const Index first = points.rows() * std::min<Index>(reduce.Rank, parts) / parts;
      const Index last = points.rows() * std::min<Index>(reduce.Rank + 1, parts) / parts;
      const Copies own = findCopies(Points(points.middleRows(first, last - first)), {}, reduce);
      EXPECT_EQ(own.Count, whole.Count);
      for (Index i = first; i < last; ++i)
      {
        ASSERT_EQ(own.contains(i - first), whole.contains(i)) << i;
      }
    });
}
