#include "DistanceBasins.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace conformal
{
namespace
{
constexpr int NotBeyond = -1; // of a node no farther than the offset

// Where two basins meet.
struct Saddle
{
  float Height;
  int BasinA, BasinB;
};

// Basins joined into one; names are basins' numbers.
class Joined
{
public:
  explicit Joined(std::vector<float> peaks)
    : Parents(peaks.size())
    , Peaks(std::move(peaks))
  {
    for (std::size_t i = 0; i < this->Parents.size(); ++i)
    {
      this->Parents[i] = static_cast<int>(i);
    }
  }
  int find(int basin)
  {
    while (this->Parents[basin] != basin)
    {
      this->Parents[basin] = this->Parents[this->Parents[basin]];
      basin = this->Parents[basin];
    }
    return basin;
  }
  // The lower peak joins the higher; the outside, basin 0, has the highest.
  void join(int rootA, int rootB)
  {
    const bool first = this->Peaks[rootA] > this->Peaks[rootB] ||
      (this->Peaks[rootA] == this->Peaks[rootB] && rootA < rootB);
    this->Parents[first ? rootB : rootA] = first ? rootA : rootB;
  }
  float peak(int root) const { return this->Peaks[root]; }

private:
  std::vector<int> Parents;
  std::vector<float> Peaks;
};

// The node each node climbs to, one step up.
std::vector<int> climbOneStep(const FreudenthalLattice& lattice,
  const std::vector<float>& distances, float offset, const ParallelFor& parallelFor,
  const Progress& progress)
{
  std::vector<int> above(distances.size(), 0); // the faces are one basin, that of node 0
  const std::array<int, 14> steps = lattice.neighborSteps();
  forInnerRows(lattice, parallelFor, progress,
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        int best = node;
        float height = distances[node];
        for (const int step : steps)
        {
          const float other = distances[node + step];
          // Of equals, to the later one: nobody goes round in circles.
          if (other > height || (other == height && node + step > best))
          {
            best = node + step;
            height = other;
          }
        }
        above[node] = distances[node] > offset ? best : NotBeyond;
      }
    });
  return above;
}

// Replace steps up by the number of the basin at whose peak they end. Returns the basins' peaks.
std::vector<float> numberBasins(
  std::vector<int>& above, const std::vector<float>& distances, const Progress& progress)
{
  const int size = static_cast<int>(above.size());
  // Shorten the ways to the top, then number the tops.
  forBlocks({}, size, 1 << 10, progress,
    [&](Index begin, Index end)
    {
      for (int node = static_cast<int>(begin); node < end; ++node)
      {
        if (above[node] == NotBeyond)
        {
          continue;
        }
        int top = node;
        while (above[top] != top)
        {
          top = above[top];
        }
        for (int next = node; next != top;)
        {
          const int step = above[next];
          above[next] = top;
          next = step;
        }
      }
    });
  std::vector<float> peaks;
  std::unordered_map<int, int> numberOf;
  for (int node = 0; node < size; ++node)
  {
    if (above[node] == node)
    {
      numberOf.emplace(node, static_cast<int>(peaks.size()));
      peaks.push_back(distances[node]);
    }
  }
  int lastTop = 0, lastNumber = 0;
  for (int& top : above)
  {
    if (top != NotBeyond)
    {
      if (top != lastTop)
      {
        lastTop = top;
        lastNumber = numberOf.at(top);
      }
      top = lastNumber;
    }
  }
  return peaks;
}

// The highest saddle between every two basins that touch, highest first.
std::vector<Saddle> findSaddles(const FreudenthalLattice& lattice, const std::vector<int>& basins,
  const std::vector<float>& distances, const Progress& progress)
{
  std::unordered_map<std::uint64_t, float> heights;
  const std::array<int, 14> steps = lattice.neighborSteps();
  forInnerRows(lattice, {}, progress,
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        const int a = basins[node];
        for (int i = 0; a != NotBeyond && i < 7; ++i)
        {
          const int b = basins[node + steps[i]];
          if (b != a && b != NotBeyond)
          {
            const auto key = static_cast<std::uint64_t>(std::min(a, b)) << 32 |
              static_cast<unsigned>(std::max(a, b));
            float& height = heights.try_emplace(key, 0.0F).first->second;
            height = std::max(height, std::min(distances[node], distances[node + steps[i]]));
          }
        }
      }
    });
  std::vector<Saddle> saddles;
  saddles.reserve(heights.size());
  for (const auto& [key, height] : heights)
  {
    saddles.push_back({ height, static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffffU) });
  }
  std::sort(saddles.begin(), saddles.end(),
    [](const Saddle& a, const Saddle& b)
    {
      return a.Height != b.Height ? a.Height > b.Height
        : a.BasinA != b.BasinA    ? a.BasinA < b.BasinA
                                  : a.BasinB < b.BasinB;
    });
  return saddles;
}

struct Division
{
  std::vector<bool> Outside; ///< of each basin
  DataHole LargestHole;
  bool AnyInside = false;
  int Candidate = -1; ///< basin whose peak rose highest above the saddle by which it was lost
};

// Join basins from the highest saddle down.
// @param[in] kept  basin that never joins the outside, or -1
Division divide(
  const std::vector<Saddle>& saddles, const std::vector<float>& peaks, double persistence, int kept)
{
  Joined joined(peaks);
  Division result;
  double bestRise = 0.0;
  for (const Saddle& saddle : saddles)
  {
    const int a = joined.find(saddle.BasinA), b = joined.find(saddle.BasinB);
    if (a == b)
    {
      continue;
    }
    if (a == 0 || b == 0)
    {
      const int basin = a + b;
      const double peak = joined.peak(basin), height = saddle.Height;
      if ((kept >= 0 && joined.find(kept) == basin) || peak > persistence * height)
      {
        if (height > result.LargestHole.Saddle)
        {
          result.LargestHole = { height, peak };
        }
        continue;
      }
      constexpr double LeastRise = 1.1;
      if (peak > LeastRise * height && peak - height > bestRise)
      {
        bestRise = peak - height;
        result.Candidate = basin;
      }
    }
    joined.join(a, b);
  }
  result.Outside.resize(peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i)
  {
    result.Outside[i] = joined.find(static_cast<int>(i)) == 0;
    result.AnyInside = result.AnyInside || !result.Outside[i];
  }
  return result;
}
}

//------------------------------------------------------------------------------
OutsideNodes findOutside(const FreudenthalLattice& lattice, std::vector<float>& distances,
  double offset, double persistence, const ParallelFor& parallelFor, const Progress& progress)
{
  const auto part = [&](double begin, double end) -> Progress
  {
    return [&progress, begin, end](double fraction)
    {
      report(progress, begin + fraction * (end - begin));
      return true;
    };
  };
  const std::array<int, 3>& size = lattice.Size;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      const bool face = z == 0 || z == size[2] - 1 || y == 0 || y == size[1] - 1;
      for (int x = 0; x < size[0]; x += face ? 1 : size[0] - 1)
      {
        distances[lattice.node(x, y, z)] = std::numeric_limits<float>::max();
      }
    }
  }
  std::vector<int> basins =
    climbOneStep(lattice, distances, static_cast<float>(offset), parallelFor, part(0.0, 0.4));
  const std::vector<float> peaks = numberBasins(basins, distances, part(0.4, 0.6));
  const std::vector<Saddle> saddles = findSaddles(lattice, basins, distances, part(0.6, 1.0));

  OutsideNodes result;
  Division division = divide(saddles, peaks, persistence, -1);
  if (!division.AnyInside && division.Candidate >= 0)
  {
    division = divide(saddles, peaks, persistence, division.Candidate);
    result.Leaks = true;
  }
  result.LargestHole = division.LargestHole;
  result.Outside.resize(basins.size());
  forBlocks(parallelFor, static_cast<Index>(basins.size()), 1 << 16,
    [&](Index begin, Index end)
    {
      for (Index node = begin; node < end; ++node)
      {
        result.Outside[node] = basins[node] != NotBeyond && division.Outside[basins[node]];
      }
    });
  return result;
}
}
