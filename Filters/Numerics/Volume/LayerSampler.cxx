#include "Volume/LayerSampler.h"

#include <stdexcept>
#include <utility>

namespace conformal
{
//------------------------------------------------------------------------------
std::vector<double> layerDepths(double first, double last, int count)
{
  std::vector<double> depths(count);
  for (int i = 0; i < count; ++i)
  {
    const double t = count > 1 ? double(i) / (count - 1) : 0.5;
    depths[i] = (1.0 - t) * first + t * last;
  }
  return depths;
}

//------------------------------------------------------------------------------
LayerSampler::LayerSampler(
  const VolumeImage& volume, std::vector<double> depths, double first, double last)
  : Volume(volume)
  , Depths(std::move(depths))
  , ToIndex(volume.Axes.inverse())
{
  if (volume.size() == 0)
  {
    throw std::invalid_argument("the image has no voxels");
  }
  if (!this->ToIndex.allFinite() || !volume.Axes.allFinite() || !volume.Origin.allFinite())
  {
    throw std::invalid_argument("the spacing and the directions of the image must be finite and "
                                "independent, and not extremely large or small");
  }
  const auto [lowest, highest] = std::minmax_element(volume.Values.begin(), volume.Values.end());
  this->Lowest = *lowest;
  this->Highest = *highest;
  // Depths are rounded: a layer at an end of the range can be slightly beyond it.
  const double rounding =
    this->Depths.empty() ? 0.0 : 1e-9 * (this->Depths.back() - this->Depths.front());
  this->First = first - rounding;
  this->Last = last + rounding;
  if (std::none_of(this->Depths.begin(), this->Depths.end(),
        [this](double depth) { return this->isInRange(depth); }))
  {
    throw std::invalid_argument("no layer is in the range of depths to summarize");
  }
}

//------------------------------------------------------------------------------
void LayerSampler::sample(const Vector3& position, const Vector3& normal, double inward,
  double outward, float* values) const
{
  const Vector3 start = this->ToIndex * (position - this->Volume.Origin),
                step = this->ToIndex * normal;
  constexpr double half = 0.5;
  for (std::size_t i = 0; i < this->Depths.size(); ++i)
  {
    const Vector3 index = start + std::clamp(this->Depths[i], -inward, outward) * step;
    bool isInside = index.allFinite();
    for (int a = 0; a < 3; ++a)
    {
      isInside = isInside && index[a] >= -half &&
        index[a] <= static_cast<double>(this->Volume.Size[a]) - half;
    }
    values[i] = isInside
      ? static_cast<float>(interpolate(this->Volume, index, this->Lowest, this->Highest))
      : 0.0F;
  }
}

//------------------------------------------------------------------------------
LayerSummary LayerSampler::summarize(const float* values, double inward, double outward) const
{
  const auto apart = [&](double depth) {
    return std::max({ -inward - depth, depth - outward, 0.0 });
  };
  const int size = this->numberOfLayers();
  int nearest = -1, best = -1, count = 0;
  double sum = 0.0;
  const auto isUsed = [&](int i) {
    return i >= 0 && i < size && this->isInRange(this->Depths[i]) && apart(this->Depths[i]) == 0.0;
  };
  for (int i = 0; i < size; ++i)
  {
    if (this->isInRange(this->Depths[i]) &&
      (nearest < 0 || apart(this->Depths[i]) < apart(this->Depths[nearest])))
    {
      nearest = i;
    }
    if (isUsed(i))
    {
      sum += values[i];
      ++count;
      best = best < 0 || values[i] > values[best] ? i : best;
    }
  }
  if (count == 0)
  {
    return { values[nearest], values[nearest],
      std::clamp(this->Depths[nearest], -inward, outward) };
  }
  LayerSummary summary = { values[best], sum / count, this->Depths[best] };
  if (isUsed(best - 1) && isUsed(best + 1))
  {
    const double before = values[best - 1], here = values[best], after = values[best + 1];
    const double curvature = before - 2.0 * here + after;
    const double shift = curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
    summary.DepthOfMaximum +=
      std::clamp(shift, -0.5, 0.5) * (this->Depths[best + 1] - this->Depths[best]);
  }
  return summary;
}
}
