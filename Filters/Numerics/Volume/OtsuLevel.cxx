#include "Volume/OtsuLevel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

namespace conformal
{
//------------------------------------------------------------------------------
double otsuLevel(const std::vector<float>& values, const Run& run)
{
  if (values.empty())
  {
    throw std::invalid_argument("the image has no voxels");
  }
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest, range = static_cast<double>(*highest) - low;
  if (!(range > 0.0))
  {
    return low;
  }
  constexpr int bins = 1024;
  std::array<std::int64_t, bins> counts{};
  constexpr Index blockSize = Index(1) << 14;
  forBlocksReporting(run.inOrder(), static_cast<Index>(values.size()), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        ++counts[std::min(bins - 1, static_cast<int>((values[i] - low) / range * bins))];
      }
    });
  // In the unit of one bin: omega(k) of Eq. 6 and mu(k) of Eq. 7, and mu_T of Eq. 8.
  const auto total = static_cast<double>(values.size());
  double mean = 0.0;
  for (int k = 0; k < bins; ++k)
  {
    mean += k * (static_cast<double>(counts[k]) / total);
  }
  double omega = 0.0, mu = 0.0, best = -1.0;
  int first = 1, last = 1; // the borders that share the largest variance
  for (int k = 0; k + 1 < bins; ++k)
  {
    const double p = static_cast<double>(counts[k]) / total;
    omega += p;
    mu += k * p;
    const double difference = mean * omega - mu, product = omega * (1.0 - omega);
    const double variance = product > 0.0 ? difference * difference / product : 0.0; // Eq. 18
    if (variance > best)
    {
      best = variance;
      first = last = k + 1;
    }
    else if (variance >= best)
    {
      last = k + 1; // an empty bin: the level is in the middle of all of them
    }
  }
  return low + 0.5 * (first + last) / bins * range;
}
}
