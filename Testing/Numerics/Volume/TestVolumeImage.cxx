#include "Volume/VolumeImage.h"

#include "Volumes.h"

#include <gtest/gtest.h>

using conformal::interpolate;
using conformal::Vector3;

// Interpolation along the axes reproduces x y z, and is constant beyond the border.
TEST(VolumeImage, InterpolatesProductsExactly)
{
  const auto product = [](const Vector3& x) { return (x[0] + 3.0) * (x[1] - 1.0) * x[2]; };
  const conformal::VolumeImage volume = volumes::of({ 5, 6, 7 }, { 1.0, 1.0, 1.0 }, product);
  for (double s = 0.0; s <= 4.0; s += 0.37)
  {
    const Vector3 index(s, 5.0 - s, 1.5 * s);
    EXPECT_NEAR(interpolate(volume, index), product(volume.Origin + index), 1e-5);
  }
  EXPECT_EQ(interpolate(volume, { -3.0, 2.0, 9.0 }), interpolate(volume, { 0.0, 2.0, 6.0 }));
  EXPECT_EQ(interpolate(volume, { 4.0, 5.0, 6.0 }), volume.Values.back());
}

TEST(VolumeImage, SizeOfAVoxelIsTheEdgeOfACube)
{
  conformal::VolumeImage volume;
  volume.Axes = Vector3(2.0, -4.0, 1.0).asDiagonal();
  EXPECT_NEAR(volume.voxelSize(), 2.0, 1e-15);
}
