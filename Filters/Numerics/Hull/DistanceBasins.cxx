#include "Hull/DistanceBasins.h"

#include "Base/DisjointSets.h"
#include "Base/Steps.h"
#include "Mesh/GeodesicSphere.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace conformal
{
namespace
{
constexpr int NotBeyond = -1; // label of nodes no farther than the offset

// Highest pass between two basins.
struct Saddle
{
  float Height;
  int BasinA, BasinB;
};

// Union of basins. The highest basin represents a set; basin 0, the outside, is the highest of all.
class Joined
{
public:
  explicit Joined(std::vector<float> peaks)
    : Sets(static_cast<Index>(peaks.size()))
    , Peaks(std::move(peaks))
  {
  }
  int find(int basin) { return this->Sets.find(basin); }
  void join(int rootA, int rootB)
  {
    const bool first = this->Peaks[rootA] > this->Peaks[rootB] ||
      (this->Peaks[rootA] == this->Peaks[rootB] && rootA < rootB);
    this->Sets.rename(first ? rootB : rootA, first ? rootA : rootB);
  }
  float peak(int root) const { return this->Peaks[root]; }

private:
  DisjointSets Sets;
  std::vector<float> Peaks;
};

// Return the highest neighbor of each node, or the node itself at a peak.
std::vector<int> climbOneStep(
  const FreudenthalGrid& grid, const std::vector<float>& distances, float offset, const Run& run)
{
  std::vector<int> above(distances.size(), 0); // the faces are one basin, that of node 0
  const std::array<int, 14> steps = grid.neighborSteps();
  forInnerRows(grid, run,
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        int best = node;
        float height = distances[node];
        for (const int step : steps)
        {
          const float other = distances[node + step];
          // Of equal heights, prefer the larger id, so that there are no cycles.
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

struct Basins
{
  std::vector<int> Of;      ///< basin of each node, or NotBeyond
  std::vector<int> Tops;    ///< node of the peak of each basin
  std::vector<float> Peaks; ///< of each basin
  std::vector<Index> Sizes; ///< of each basin, in nodes
};

// Number the basins, given the highest neighbor of each node. Basin 0 contains the faces of the
// grid.
Basins numberBasins(std::vector<int> above, const std::vector<float>& distances, const Run& run)
{
  Basins basins;
  const int size = static_cast<int>(above.size());
  // Compress the paths to the peaks, then number the peaks.
  forBlocksReporting(run.inOrder(), size, 1 << 10,
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
  std::unordered_map<int, int> numberOf;
  for (int node = 0; node < size; ++node)
  {
    if (above[node] == node)
    {
      numberOf.emplace(node, static_cast<int>(basins.Tops.size()));
      basins.Tops.push_back(node);
      basins.Peaks.push_back(distances[node]);
    }
  }
  basins.Sizes.resize(basins.Tops.size(), 0);
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
      ++basins.Sizes[lastNumber];
    }
  }
  basins.Of = std::move(above);
  return basins;
}

// Find the highest saddle between every two adjacent basins, sorted from the highest down.
std::vector<Saddle> findSaddles(const FreudenthalGrid& grid, const std::vector<int>& basins,
  const std::vector<float>& distances, const Run& run)
{
  std::unordered_map<std::uint64_t, float> heights;
  const std::array<int, 14> steps = grid.neighborSteps();
  forInnerRows(grid, run.inOrder(),
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

// Compute the fraction of all directions in which data are visible from a node.
double enclosure(
  const FreudenthalGrid& grid, const std::vector<float>& distances, double offset, int node)
{
  static const Points directions = makeGeodesicSphere(4).Positions;
  Index seen = 0;
  for (Index i = 0; i < directions.rows(); ++i)
  {
    // No sample is nearer to a node than the distance of the node. The nearest node is up to one
    // spacing away from the ray.
    const Vector3 direction = directions.row(i);
    Vector3 x = grid.coordinates(node).cast<double>();
    float distance = distances[node];
    const auto within = [&](int axis) { return x[axis] > 0.0 && x[axis] < grid.Size[axis] - 1; };
    while (distance > offset && within(0) && within(1) && within(2))
    {
      x += std::max(0.5, distance - 1.0) * direction;
      if (within(0) && within(1) && within(2))
      {
        const Eigen::Vector3i nearest = x.array().round().cast<int>();
        distance = distances[grid.node(nearest[0], nearest[1], nearest[2])];
      }
    }
    seen += distance <= offset;
  }
  return static_cast<double>(seen) / static_cast<double>(directions.rows());
}

// Basin that was merged into the outside.
struct LostBasin
{
  int Basin;
  double Peak, Saddle;
};

struct Division
{
  std::vector<bool> Outside; ///< of each basin
  DataHole LargestHole;
  Index NumberOfInsideNodes = 0;
  std::vector<LostBasin> Lost; ///< with peaks higher than the saddles by at least a tenth
};

// Merge basins from the highest saddle down.
// @param[in] kept  basin that never joins the outside, or -1
Division divide(
  const std::vector<Saddle>& saddles, const Basins& basins, double persistence, int kept)
{
  constexpr double minimumRise = 1.1;
  Joined joined(basins.Peaks);
  Division result;
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
      if (peak > persistence * height || (kept >= 0 && joined.find(kept) == basin))
      {
        if (height > result.LargestHole.Saddle)
        {
          result.LargestHole = { height, peak };
        }
        continue;
      }
      if (peak > minimumRise * height)
      {
        result.Lost.push_back({ basin, peak, height });
      }
    }
    joined.join(a, b);
  }
  result.Outside.resize(basins.Peaks.size());
  for (std::size_t i = 0; i < result.Outside.size(); ++i)
  {
    result.Outside[i] = joined.find(static_cast<int>(i)) == 0;
    result.NumberOfInsideNodes += result.Outside[i] ? 0 : basins.Sizes[i];
  }
  return result;
}

// Find the basin that is most likely inside of a leaking cloud. Return -1 if there is no candidate.
int findLikeliest(const FreudenthalGrid& grid, const std::vector<float>& distances, double offset,
  const Basins& basins, const std::vector<LostBasin>& lost)
{
  constexpr double minimumEnclosure = 2.0 / 3.0;
  int best = -1;
  double rise = 0.0;
  for (const LostBasin& basin : lost)
  {
    if (basin.Peak - basin.Saddle > rise &&
      enclosure(grid, distances, offset, basins.Tops[basin.Basin]) >= minimumEnclosure)
    {
      best = basin.Basin;
      rise = basin.Peak - basin.Saddle;
    }
  }
  return best;
}
}

//------------------------------------------------------------------------------
OutsideNodes findOutside(const FreudenthalGrid& grid, std::vector<float>& distances, double offset,
  double persistence, const Run& run)
{
  Steps steps(run, { 0.45, 0.22, 0.26, 0.07 });
  const std::array<int, 3>& size = grid.Size;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      const bool face = z == 0 || z == size[2] - 1 || y == 0 || y == size[1] - 1;
      for (int x = 0; x < size[0]; x += face ? 1 : size[0] - 1)
      {
        distances[grid.node(x, y, z)] = std::numeric_limits<float>::max();
      }
    }
  }
  std::vector<int> above = climbOneStep(grid, distances, static_cast<float>(offset), steps.next());
  const Basins basins = numberBasins(std::move(above), distances, steps.next());
  const std::vector<Saddle> saddles = findSaddles(grid, basins.Of, distances, steps.next());
  steps.next();

  OutsideNodes result;
  Division division = divide(saddles, basins, persistence, -1);
  constexpr double minimumShare = 0.01; // of the nodes near the data
  const Index near = std::count(basins.Of.begin(), basins.Of.end(), NotBeyond);
  if (static_cast<double>(division.NumberOfInsideNodes) < minimumShare * static_cast<double>(near))
  {
    const int likeliest = findLikeliest(grid, distances, offset, basins, division.Lost);
    if (likeliest >= 0)
    {
      division = divide(saddles, basins, persistence, likeliest);
      result.Leaks = true;
    }
  }
  result.LargestHole = division.LargestHole;
  result.Outside.resize(basins.Of.size());
  forBlocks(run, static_cast<Index>(basins.Of.size()), 1 << 16,
    [&](Index begin, Index end)
    {
      for (Index node = begin; node < end; ++node)
      {
        result.Outside[node] = basins.Of[node] != NotBeyond && division.Outside[basins.Of[node]];
      }
    });
  return result;
}
}
