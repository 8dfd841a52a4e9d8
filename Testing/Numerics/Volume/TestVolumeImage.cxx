#include "Volume/VolumeImage.h"

#include "Volumes.h"

#include <gtest/gtest.h>

using conformal::interpolate;
using conformal::Vector3;

// Cubic convolution reproduces squares along each axis, away from the border.
TEST(VolumeImage, InterpolatesSquaresExactly)
{
  const auto product = [](const Vector3& x)
  { return (x[0] * x[0] + 3.0) * (x[1] - 1.0) * (x[2] * x[2] - x[2]); };
  const conformal::VolumeImage volume = volumes::of({ 9, 9, 9 }, { 1.0, 1.0, 1.0 }, product);
  for (double s = 1.0; s <= 7.0; s += 0.37)
  {
    const Vector3 index(s, 8.0 - s, 0.5 * s + 1.5);
    EXPECT_NEAR(interpolate(volume, index, -1e9, 1e9), product(volume.Origin + index), 1e-3);
  }
}

TEST(VolumeImage, StaysInTheRangeAndGoesOnBeyondTheBorder)
{
  const conformal::VolumeImage step = volumes::of(
    { 8, 2, 1 }, { 1.0, 1.0, 1.0 }, [](const Vector3& x) { return x[0] > 0.0 ? 5.0 : 0.0; });
  for (double i = -2.0; i < 10.0; i += 0.25)
  {
    const double value = interpolate(step, { i, 0.5, 0.0 }, 0.0, 5.0);
    EXPECT_TRUE(value >= 0.0 && value <= 5.0);
    EXPECT_TRUE(i > 2.0 || value == 0.0);
    EXPECT_TRUE(i < 5.0 || value == 5.0);
  }
  EXPECT_GT(interpolate(step, { 4.4, 0.5, 0.0 }, 0.0, 9.0), 5.0); // without a range
}

TEST(VolumeImage, SizeOfAVoxelIsTheEdgeOfACube)
{
  conformal::VolumeImage volume;
  volume.Axes = Vector3(2.0, -4.0, 1.0).asDiagonal();
  EXPECT_NEAR(volume.voxelSize(), 2.0, 1e-15);
}
