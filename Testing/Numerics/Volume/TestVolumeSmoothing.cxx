#include "Volume/VolumeSmoothing.h"

#include "Runs.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using conformal::smoothVolume;
using conformal::Vector3;
using conformal::VolumeImage;

namespace
{
VolumeImage impulse()
{
  return volumes::of({ 25, 27, 29 }, { 1.0, 1.0, 1.0 },
    [](const Vector3& x) { return x.squaredNorm() < 0.1 ? 1.0 : 0.0; });
}
}

// A single voxel becomes a Gaussian of the same sum with the given variance along each axis.
TEST(VolumeSmoothing, ImpulseBecomesAGaussian)
{
  VolumeImage volume = impulse();
  smoothVolume(volume, 1.5);
  const double sum = std::accumulate(volume.Values.begin(), volume.Values.end(), 0.0);
  EXPECT_NEAR(sum, 1.0, 1e-5);
  for (int axis = 0; axis < 3; ++axis)
  {
    double variance = 0.0;
    for (conformal::Index i = 0; i < volume.size(); ++i)
    {
      const Vector3 index(double(i % 25), double(i / 25 % 27), double(i / 25 / 27));
      const double x = (volume.Origin + index)[axis];
      variance += x * x * volume.Values[i];
    }
    EXPECT_NEAR(variance, 2.25, 0.02) << axis;
  }
  const double peak = volume.Values[volume.id(12, 13, 14)];
  EXPECT_NEAR(volume.Values[volume.id(13, 14, 15)] / peak, std::exp(-1.5 / 2.25), 1e-4);
}

TEST(VolumeSmoothing, ConstantImagesStayConstant)
{
  VolumeImage volume =
    volumes::of({ 4, 1, 9 }, { 1.0, 1.0, 1.0 }, [](const Vector3&) { return 7.0; });
  smoothVolume(volume, 3.0);
  for (const float value : volume.Values)
  {
    EXPECT_NEAR(value, 7.0, 1e-5);
  }
}

// Each line of voxels costs as many operations as there are weights.
TEST(VolumeSmoothing, ReportsMoreOftenIfWeightsAreMany)
{
  VolumeImage volume =
    volumes::of({ 4, 40, 40 }, { 1, 1, 1 }, [](const Vector3& x) { return x[0]; });
  runs::Watch watch;
  smoothVolume(volume, 100.0, watch.run());
  EXPECT_GE(watch.calls(), 16);
}

TEST(VolumeSmoothing, SameBitsOnAnyThreadsAndNothingWithZero)
{
  VolumeImage one = impulse(), two = impulse();
  smoothVolume(one, 2.0);
  smoothVolume(two, 2.0, runs::backwards());
  EXPECT_EQ(one.Values, two.Values);
  VolumeImage same = impulse();
  smoothVolume(same, 0.0);
  EXPECT_EQ(same.Values, impulse().Values);
  EXPECT_THROW(smoothVolume(one, -1.0), std::invalid_argument);
  EXPECT_THROW(smoothVolume(one, std::nan("")), std::invalid_argument);
  EXPECT_THROW(smoothVolume(one, 1.0, runs::stoppingAt(0.5)), conformal::Aborted);
}
