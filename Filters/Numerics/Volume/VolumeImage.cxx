#include "Volume/VolumeImage.h"

#include <algorithm>

namespace conformal
{
namespace
{
// Weights of the four voxels around a position, \cite Keys1981 Eq. 15.
std::array<double, 4> cubicWeights(double t)
{
  const double t2 = t * t, t3 = t2 * t;
  return { 0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
    0.5 * (-3.0 * t3 + 4.0 * t2 + t), 0.5 * (t3 - t2) };
}
}

//------------------------------------------------------------------------------
double interpolate(const VolumeImage& volume, const Vector3& index, double lowest, double highest)
{
  constexpr int taps = 4;
  std::array<std::array<Index, taps>, 3> ids;
  std::array<std::array<double, taps>, 3> weights;
  for (int a = 0; a < 3; ++a)
  {
    const Index end = volume.Size[a] - 1;
    const double place = std::clamp(index[a], 0.0, static_cast<double>(end));
    const auto first = static_cast<Index>(place);
    weights[a] = cubicWeights(place - static_cast<double>(first));
    for (Index tap = 0; tap < taps; ++tap)
    {
      ids[a][tap] = std::clamp<Index>(first + tap - 1, 0, end);
    }
  }
  double sum = 0.0;
  for (int k = 0; k < taps; ++k)
  {
    double plane = 0.0;
    for (int j = 0; j < taps; ++j)
    {
      const float* const row = volume.Values.data() + volume.id(0, ids[1][j], ids[2][k]);
      const double line = weights[0][0] * row[ids[0][0]] + weights[0][1] * row[ids[0][1]] +
        weights[0][2] * row[ids[0][2]] + weights[0][3] * row[ids[0][3]];
      plane += weights[1][j] * line;
    }
    sum += weights[2][k] * plane;
  }
  return std::clamp(sum, lowest, highest);
}
}
