#include "Volume/OutsideMask.h"

#include "Runs.h"
#include "Volumes.h"

#include <gtest/gtest.h>

using conformal::markOutside;
using conformal::Vector3;
using conformal::VolumeImage;

namespace
{
// A shell of radius 12 with a hole around the x axis, and a small ball beside it.
VolumeImage shell(double hole)
{
  return volumes::of({ 41, 41, 41 }, { 1.0, 1.0, 1.0 },
    [=](const Vector3& x)
    {
      const double radius = x.norm();
      const bool isHole = x[0] > 0.0 && std::hypot(x[1], x[2]) < hole;
      const bool isBall = (x - Vector3(17.0, 17.0, 17.0)).norm() < 2.5;
      return (radius > 9.0 && radius < 12.0 && !isHole) || isBall ? 1.0 : 0.0;
    });
}

bool isOutside(
  const VolumeImage& volume, const std::vector<std::uint8_t>& outside, int i, int j, int k)
{
  return outside[volume.id(i, j, k)] != 0;
}
}

TEST(OutsideMask, CavitiesAndNarrowHolesAreInside)
{
  const VolumeImage narrow = shell(1.5), wide = shell(5.5);
  for (const bool isClosed : { true, false })
  {
    const VolumeImage& volume = isClosed ? narrow : wide;
    const auto outside = markOutside(volume, { 0.5, 3.0, true });
    EXPECT_EQ(isOutside(volume, outside, 20, 20, 20), !isClosed); // the middle
    EXPECT_EQ(isOutside(volume, outside, 28, 20, 20), !isClosed); // inside of the hole
    EXPECT_FALSE(isOutside(volume, outside, 20, 31, 20));         // in the shell
    EXPECT_TRUE(isOutside(volume, outside, 1, 1, 1));
    EXPECT_EQ(outside, markOutside(volume, { 0.5, 3.0, true }, runs::backwards()));
  }
  const auto open = markOutside(narrow, { 0.5, 0.0, true });
  EXPECT_TRUE(isOutside(narrow, open, 20, 20, 20));
}

TEST(OutsideMask, OtherObjectsAreOutsideIfOnlyTheLargestIsKept)
{
  const VolumeImage volume = shell(0.0);
  EXPECT_TRUE(isOutside(volume, markOutside(volume, { 0.5, 1.0, true }), 37, 37, 37));
  EXPECT_FALSE(isOutside(volume, markOutside(volume, { 0.5, 1.0, false }), 37, 37, 37));
  EXPECT_FALSE(isOutside(volume, markOutside(volume, { 0.5, 1.0, true }), 20, 20, 20));
}

TEST(OutsideMask, ReportsWhileItFillsTheImage)
{
  const VolumeImage volume = volumes::of({ 150, 150, 150 }, { 1.0, 1.0, 1.0 },
    [](const Vector3& x) { return x.norm() < 60.0 ? 1.0 : 0.0; });
  runs::Watch watch;
  markOutside(volume, { 0.5, 0.0, true }, watch.run());
  double before = 0.0, longest = 0.0;
  for (const double fraction : watch.fractions())
  {
    longest = std::max(longest, fraction - before);
    before = fraction;
  }
  EXPECT_EQ(before, 1.0);
  EXPECT_LT(longest, 0.1);
}

TEST(OutsideMask, WithoutAnObjectAllIsOutside)
{
  const VolumeImage volume = shell(0.0);
  const auto outside = markOutside(volume, { 2.0, 2.0, true });
  EXPECT_EQ(outside, std::vector<std::uint8_t>(outside.size(), 1));
  EXPECT_THROW(markOutside(volume, { 0.5, -1.0, true }), std::invalid_argument);
  EXPECT_THROW(markOutside(volume, { 0.5, 101.0, true }), std::invalid_argument);
}
