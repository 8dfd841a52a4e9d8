#include "Cloud/CloudParts.h"

#include <gtest/gtest.h>

#include <vector>

TEST(CloudParts, AGapSeparatesParts)
{
  // Two rows of points, 1 apart, with a gap of 3.
  conformal::Points points = conformal::Points::Zero(20, 3);
  for (int i = 0; i < 20; ++i)
  {
    points(i, 0) = i < 10 ? i : i + 2.0;
  }
  const conformal::PointTree tree(points);
  const std::vector<int> apart = conformal::partsOfCloud(points, tree, 1.5);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(apart[i], apart[i < 10 ? 0 : 10]);
  }
  EXPECT_NE(apart[0], apart[10]);
  const std::vector<int> together = conformal::partsOfCloud(points, tree, 3.0);
  EXPECT_EQ(together[0], together[19]);
}
