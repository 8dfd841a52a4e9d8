#include "Cloud/CloudParts.h"

#include <gtest/gtest.h>

#include <vector>

TEST(CloudParts, AGapSeparatesParts)
{
  // Two squares of 100 points each, 1 apart, with a gap of 3.
  conformal::Points points = conformal::Points::Zero(200, 3);
  for (int i = 0; i < 200; ++i)
  {
    points.row(i) << i / 10 + (i < 100 ? 0.0 : 2.0), i % 10, 0.0;
  }
  const conformal::SampleSpacing spacing(points);
  const std::vector<int> apart = conformal::partsOfCloud(points, spacing, 1.5);
  for (int i = 0; i < 200; ++i)
  {
    EXPECT_EQ(apart[i], apart[i < 100 ? 0 : 100]);
  }
  EXPECT_NE(apart[0], apart[100]);
  const std::vector<int> together = conformal::partsOfCloud(points, spacing, 3.0);
  EXPECT_EQ(together[0], together[199]);
}

TEST(CloudParts, ScanLinesOfOneSurfaceAreOnePart)
{
  // Ten lines of 200 points, 12 times as far apart as the points on them.
  conformal::Points points = conformal::Points::Zero(2000, 3);
  for (int i = 0; i < 2000; ++i)
  {
    points.row(i) << i % 200, 12.0 * (i / 200), 0.0;
  }
  const conformal::SampleSpacing spacing(points);
  const double reach = 4.0 * spacing.median();
  const std::vector<int> parts = conformal::partsOfCloud(points, spacing, reach);
  for (const int part : parts)
  {
    EXPECT_EQ(part, parts[0]);
  }
}
