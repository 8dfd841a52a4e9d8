#include "Register/ResampleWeights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace conformal
{
//------------------------------------------------------------------------------
void ResampleWeights::add(const std::vector<std::pair<int, double>>& parts)
{
  double sum = 0.0;
  for (const auto& [id, weight] : parts)
  {
    sum += weight;
  }
  for (const auto& [id, weight] : parts)
  {
    if (weight > 0.0)
    {
      this->Ids.push_back(id);
      this->Weights.push_back(weight / sum);
    }
  }
  this->Offsets.push_back(static_cast<Index>(this->Ids.size()));
}

//------------------------------------------------------------------------------
ResampleWeights restrictedTo(const ResampleWeights& weights, const std::vector<char>& counts)
{
  ResampleWeights result;
  std::vector<std::pair<int, double>> parts;
  for (Index i = 0; i < weights.size(); ++i)
  {
    parts.clear();
    for (Index k = weights.Offsets[i]; k < weights.Offsets[i + 1]; ++k)
    {
      if (counts[weights.Ids[k]] != 0)
      {
        parts.emplace_back(weights.Ids[k], weights.Weights[k]);
      }
    }
    result.add(parts);
  }
  return result;
}

//------------------------------------------------------------------------------
ResampleWeights blended(const std::vector<const ResampleWeights*>& ofSurfaces,
  const std::vector<Index>& sizes, const std::vector<double>& shares)
{
  ResampleWeights result;
  std::vector<std::pair<int, double>> parts;
  for (Index i = 0; i < ofSurfaces.front()->size(); ++i)
  {
    parts.clear();
    Index first = 0;
    for (std::size_t s = 0; s < ofSurfaces.size(); ++s)
    {
      const ResampleWeights& own = *ofSurfaces[s];
      for (Index k = own.Offsets[i]; k < own.Offsets[i + 1]; ++k)
      {
        parts.emplace_back(static_cast<int>(first) + own.Ids[k], shares[s] * own.Weights[k]);
      }
      first += sizes[s];
    }
    result.add(parts);
  }
  return result;
}

//------------------------------------------------------------------------------
ResampledNumbers resampleNumbers(const ResampleWeights& weights, const std::vector<double>& values,
  int numberOfComponents, const Run& run)
{
  const Index size = weights.size();
  ResampledNumbers result;
  result.Values.assign(size * numberOfComponents, 0.0);
  std::vector<char> isMissing(size, 0);
  const auto isFinite = [&](int id)
  {
    const double* row = values.data() + static_cast<Index>(id) * numberOfComponents;
    return std::all_of(
      row, row + numberOfComponents, [](double value) { return std::isfinite(value); });
  };
  forBlocksReporting(run, size, LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Index first = weights.Offsets[i], last = weights.Offsets[i + 1];
        double sum = 0.0;
        for (Index k = first; k < last; ++k)
        {
          sum += isFinite(weights.Ids[k]) ? weights.Weights[k] : 0.0;
        }
        isMissing[i] = first < last && sum == 0.0;
        for (int c = 0; c < numberOfComponents && sum > 0.0; ++c)
        {
          double mean = 0.0;
          double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
          for (Index k = first; k < last; ++k)
          {
            if (isFinite(weights.Ids[k]))
            {
              const double value =
                values[static_cast<Index>(weights.Ids[k]) * numberOfComponents + c];
              mean += weights.Weights[k] / sum * value;
              minimum = std::min(minimum, value);
              maximum = std::max(maximum, value);
            }
          }
          result.Values[i * numberOfComponents + c] = std::clamp(mean, minimum, maximum);
        }
      }
    });
  result.NumberOfMissing = std::accumulate(isMissing.begin(), isMissing.end(), Index(0));
  return result;
}

//------------------------------------------------------------------------------
std::vector<int> heaviestLabels(
  const ResampleWeights& weights, const std::vector<double>& labels, const Run& run)
{
  std::vector<int> heaviest(weights.size(), -1);
  forBlocksReporting(run, weights.size(), LightBlock,
    [&](Index begin, Index end)
    {
      std::vector<Index> parts;
      for (Index i = begin; i < end; ++i)
      {
        parts.resize(weights.Offsets[i + 1] - weights.Offsets[i]);
        std::iota(parts.begin(), parts.end(), weights.Offsets[i]);
        std::stable_sort(parts.begin(), parts.end(),
          [&](Index a, Index b) { return labels[weights.Ids[a]] < labels[weights.Ids[b]]; });
        double maximum = 0.0;
        for (std::size_t k = 0; k < parts.size();)
        {
          const int id = weights.Ids[parts[k]];
          double sum = 0.0;
          for (; k < parts.size() && labels[weights.Ids[parts[k]]] == labels[id]; ++k)
          {
            sum += weights.Weights[parts[k]];
          }
          if (sum > maximum)
          {
            maximum = sum;
            heaviest[i] = id;
          }
        }
      }
    });
  return heaviest;
}
}
