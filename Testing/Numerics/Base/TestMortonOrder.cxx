#include "Base/MortonOrder.h"

#include "Clouds.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <vector>

using conformal::Index;
using conformal::mortonOrder;
using conformal::Points;
using conformal::Vector3;

// The eight cells of a cube, in the order of the bits of their coordinates.
TEST(MortonOrder, FollowsTheCurve)
{
  const auto corner = [](Index i)
  { return Vector3(0.25 + 0.5 * (i & 1), 0.25 + 0.5 * (i >> 1 & 1), 0.25 + 0.5 * (i >> 2)); };
  EXPECT_EQ(mortonOrder(8, [&](Index i) { return corner(7 - i); }),
    (std::vector<int>{ 7, 6, 5, 4, 3, 2, 1, 0 }));
  EXPECT_TRUE(mortonOrder(0, {}).empty());
}

TEST(MortonOrder, KeepsTheSequenceInACellAndAcceptsAnyPosition)
{
  EXPECT_EQ(mortonOrder(4, [](Index i) { return Vector3::Constant(i == 1 ? -1e9 : 1e9); }),
    (std::vector<int>{ 1, 0, 2, 3 }));
}

// Successive positions are much closer to each other than random ones, with any threads.
TEST(MortonOrder, BringsNeighborsTogether)
{
  const Points points = clouds::inUnitCube(5000, 3);
  const auto place = [&](Index i) { return Vector3(points.row(i)); };
  const std::vector<int> ids = mortonOrder(points.rows(), place);
  EXPECT_EQ(ids, mortonOrder(points.rows(), place, runs::backwards()));
  std::vector<int> visits(points.rows(), 0);
  double sorted = 0.0, random = 0.0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ++visits[ids[i]];
    if (i > 0)
    {
      sorted += (place(ids[i]) - place(ids[i - 1])).norm();
      random += (place(static_cast<Index>(i)) - place(static_cast<Index>(i) - 1)).norm();
    }
  }
  EXPECT_EQ(visits, std::vector<int>(points.rows(), 1));
  EXPECT_LT(sorted, 0.2 * random);
}
