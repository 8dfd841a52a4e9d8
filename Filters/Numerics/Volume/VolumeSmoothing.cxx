#include "Volume/VolumeSmoothing.h"

#include "Base/Steps.h"

#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
std::vector<double> gaussianWeights(double deviation)
{
  constexpr double reach = 4.0; // beyond, all weights together are 6e-5
  const auto radius = static_cast<Index>(std::ceil(reach * deviation));
  std::vector<double> weights(2 * radius + 1);
  double sum = 0.0;
  for (Index i = -radius; i <= radius; ++i)
  {
    const double x = static_cast<double>(i) / deviation;
    sum += weights[i + radius] = std::exp(-0.5 * x * x);
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

void smoothAlong(VolumeImage& volume, int axis, const std::vector<double>& weights, const Run& run)
{
  const Index length = volume.Size[axis], radius = static_cast<Index>(weights.size()) / 2;
  const Index step = axis == 0 ? 1 : axis == 1 ? volume.Size[0] : volume.Size[0] * volume.Size[1];
  // Blocks have fewer lines if each line is costly, so that reports are frequent.
  const Index blockSize = std::clamp<Index>(1024 / static_cast<Index>(weights.size()), 1, 64);
  forBlocksReporting(run, volume.size() / length, blockSize,
    [&](Index begin, Index end)
    {
      std::vector<double> line(length + 2 * radius);
      for (Index number = begin; number < end; ++number)
      {
        float* const first = volume.Values.data() + (number / step) * step * length + number % step;
        for (Index i = 0; i < static_cast<Index>(line.size()); ++i)
        {
          line[i] = first[std::clamp<Index>(i - radius, 0, length - 1) * step];
        }
        for (Index i = 0; i < length; ++i)
        {
          double sum = 0.0;
          for (std::size_t w = 0; w < weights.size(); ++w)
          {
            sum += weights[w] * line[i + w];
          }
          first[i * step] = static_cast<float>(sum);
        }
      }
    });
}
}

//------------------------------------------------------------------------------
void smoothVolume(VolumeImage& volume, double deviation, const Run& run)
{
  if (!(deviation >= 0.0 && deviation <= MaximumSmoothing))
  {
    throw std::invalid_argument("the smoothing must be in [0, 100] voxels");
  }
  if (deviation < 1e-3 || volume.size() == 0)
  {
    return;
  }
  const std::vector<double> weights = gaussianWeights(deviation);
  Steps steps(run, { 1.0, 1.0, 1.0 });
  for (int axis = 0; axis < 3; ++axis)
  {
    smoothAlong(volume, axis, weights, steps.next());
  }
}
}
