#include "Hull/NestedLayers.h"

#include "Base/Steps.h"
#include "Cloud/CloudParts.h"
#include "Cloud/SampleSpacing.h"
#include "Hull/CloudDistance.h"
#include "Hull/DistanceBasins.h"
#include "Hull/FreudenthalGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index WantedSamples = 40000, MinimumSamples = 500;

// Limits of the spacing of the grid, which is usually that of the samples.
constexpr double MinimumSpacing = 0.02, MaximumSpacing = 0.1;

// Distances in grid spacings. The outside is farther than Offset from the samples, and a cavity
// farther than CoreOffset, so that gaps between samples do not connect the cavity to the wall.
// Samples that see the outside or a cavity are within SeenFrom of its nodes, beyond the offset.
constexpr double Offset = 2.0, Persistence = 1.5, CoreOffset = 3.0, SeenFrom = 1.0;

// Offset at which the outside must not reach a cavity.
constexpr double HoleOffset = 4.0;

constexpr double MostAtBoth = 0.1, FewestInner = 0.02;

// Balls in the middle of the wall and at its ends have this radius, relative to its thickness. In
// the middle of a wall, there are fewer samples than at its ends, by this factor. Measured: at most
// 0.43 for shells with noise up to a sixth of the wall, and at least 1.28 for noise on one layer.
constexpr double BallOfWall = 1.0 / 3.0, FilledWall = 0.7;
constexpr Index CountedStep = 3;
constexpr int MaximumCount = 40;

// Marks of nodes: near samples, outside, and inside farther than CoreOffset from all samples. The
// components of the core have marks from FirstRegion on.
constexpr std::uint8_t Near = 0, Beyond = 1, Core = 2, FirstRegion = 3, LastRegion = 254;

// Regions of a grid: the outside, and the connected components of the core of the inside.
struct Regions
{
  FreudenthalGrid Grid;
  std::vector<std::uint8_t> Marks;
  std::uint8_t End = FirstRegion; // one more than the mark of the last component
};

// Remove the components of the core that the outside reaches through wide holes.
void removeReached(const FreudenthalGrid& grid, const std::vector<float>& distances,
  std::vector<std::uint8_t>& marks, const Run& run)
{
  constexpr std::uint8_t open = 1, reached = 2;
  std::vector<std::uint8_t> free(marks.size(), 0);
  forInnerRows(grid, run,
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        free[node] = distances[node] > HoleOffset ? open : 0;
      }
    });
  std::vector<int> piece;
  // The margin of the grid is wide enough that its second layer is open and connected.
  markPiece(grid, free, grid.node(1, 1, 1), reached, piece, run);
  std::array<bool, LastRegion + 2> isReached = {};
  for (std::size_t node = 0; node < marks.size(); ++node)
  {
    isReached[marks[node]] |= marks[node] >= FirstRegion && free[node] == reached;
  }
  for (std::uint8_t& mark : marks)
  {
    mark = isReached[mark] ? Near : mark;
  }
}

Regions regionsOf(const TrainingSamples& samples, double spacing, const Run& run)
{
  // Grid, distances, outside, components.
  Steps steps(run, { 0.05, 0.7, 0.2, 0.05 });
  Regions regions;
  regions.Grid = gridAround(samples, spacing, static_cast<int>(HoleOffset) + 3, steps.next());
  std::vector<float> distances = distanceToSamples(regions.Grid, samples, steps.next());
  regions.Marks = findOutside(regions.Grid, distances, Offset, Persistence, steps.next()).Outside;
  for (std::size_t node = 0; node < distances.size(); ++node)
  {
    regions.Marks[node] = regions.Marks[node] ? Beyond : distances[node] > CoreOffset ? Core : Near;
  }
  constexpr std::size_t smallest = 30;
  std::vector<int> piece;
  const Run marking = steps.next();
  for (int node = 0; node < static_cast<int>(regions.Marks.size()); ++node)
  {
    if (regions.Marks[node] == Core && regions.End <= LastRegion)
    {
      markPiece(regions.Grid, regions.Marks, node, regions.End, piece, marking);
      if (piece.size() >= smallest)
      {
        ++regions.End;
        continue;
      }
      for (const int other : piece)
      {
        regions.Marks[other] = Near;
      }
    }
  }
  removeReached(regions.Grid, distances, regions.Marks, marking);
  return regions;
}

// Regions near a sample.
struct Seen
{
  bool Outside = false;
  std::vector<std::uint8_t> Cores;
};

Seen seenFrom(const Regions& regions, const Vector3& x)
{
  const FreudenthalGrid& grid = regions.Grid;
  const Vector3 place = grid.toGrid(x);
  const double far = CoreOffset + SeenFrom;
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::max(0, static_cast<int>(std::ceil(place[axis] - far)));
    high[axis] = std::min(grid.Size[axis] - 1, static_cast<int>(std::floor(place[axis] + far)));
  }
  Seen seen;
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int i = low[0]; i <= high[0]; ++i)
      {
        const std::uint8_t mark = regions.Marks[grid.node(i, y, z)];
        const double squared = (Vector3(i, y, z) - place).squaredNorm();
        constexpr double outside = (Offset + SeenFrom) * (Offset + SeenFrom);
        seen.Outside = seen.Outside || (mark == Beyond && squared <= outside);
        if (mark >= FirstRegion && squared <= far * far &&
          std::find(seen.Cores.begin(), seen.Cores.end(), mark) == seen.Cores.end())
        {
          seen.Cores.push_back(mark);
        }
      }
    }
  }
  return seen;
}

// Return for each component of the core whether it is a cavity: few samples see both the component
// and the outside.
std::vector<char> cavitiesOf(const Regions& regions, const std::vector<Seen>& seen)
{
  std::vector<int> all(regions.End, 0), atBoth(regions.End, 0);
  for (const Seen& sample : seen)
  {
    for (const std::uint8_t core : sample.Cores)
    {
      ++all[core];
      atBoth[core] += sample.Outside;
    }
  }
  std::vector<char> isCavity(regions.End, 0);
  for (int core = FirstRegion; core < regions.End; ++core)
  {
    isCavity[core] = all[core] > 0 && atBoth[core] <= MostAtBoth * all[core];
  }
  return isCavity;
}

Points rowsAt(const Points& points, const std::vector<int>& ids)
{
  Points rows(static_cast<Index>(ids.size()), 3);
  for (Index k = 0; k < rows.rows(); ++k)
  {
    rows.row(k) = points.row(ids[k]);
  }
  return rows;
}

// Mark the samples of the inner layer: those at a cavity, and those connected to them by samples
// that do not see the outside.
std::vector<char> innerSamples(
  const Regions& regions, const Points& points, const std::vector<Seen>& seen, double reach)
{
  const std::vector<char> isCavity = cavitiesOf(regions, seen);
  std::vector<int> hidden;
  for (int i = 0; i < static_cast<int>(seen.size()); ++i)
  {
    if (!seen[i].Outside)
    {
      hidden.push_back(i);
    }
  }
  const Points places = rowsAt(points, hidden);
  const std::vector<int> parts = partsOfCloud(places, SampleSpacing(places), reach);
  std::vector<char> isInnerPart(parts.size(), 0), isInner(seen.size(), 0);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const std::vector<std::uint8_t>& cores = seen[hidden[k]].Cores;
    isInnerPart[parts[k]] = isInnerPart[parts[k]] ||
      std::any_of(cores.begin(), cores.end(), [&](std::uint8_t core) { return isCavity[core]; });
  }
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    isInner[hidden[k]] = isInnerPart[parts[k]];
  }
  return isInner;
}

// Give each sample the layer of most of its neighbors. Gaps between samples otherwise let single
// samples of the inner layer see the outside.
std::vector<char> smoothed(
  const Points& points, const PointTree& tree, const std::vector<char>& isInner)
{
  constexpr int neighbors = 12;
  std::vector<char> result(isInner.size());
  std::vector<Neighbor> around;
  for (Index i = 0; i < points.rows(); ++i)
  {
    tree.nearest(points.row(i), neighbors + 1, around);
    const auto inner = std::count_if(
      around.begin(), around.end(), [&](const Neighbor& neighbor) { return isInner[neighbor.Id]; });
    result[i] = 2 * inner > static_cast<std::ptrdiff_t>(around.size());
  }
  return result;
}

// Return whether there are few samples in the wall between the inner layer and the samples that see
// the outside. In noise, samples are as dense between these two as at them.
bool wallIsEmpty(const Points& points, const PointTree& tree, const std::vector<char>& isInner,
  const std::vector<Seen>& seen)
{
  std::vector<int> outer;
  for (int i = 0; i < static_cast<int>(seen.size()); ++i)
  {
    if (seen[i].Outside)
    {
      outer.push_back(i);
    }
  }
  if (outer.empty())
  {
    return false;
  }
  const Points places = rowsAt(points, outer);
  const PointTree outside(places);
  std::vector<Neighbor> around;
  // Count samples in a ball, up to a maximum.
  const auto count = [&](const Vector3& x, double radius)
  {
    tree.nearest(x, MaximumCount, around);
    return std::count_if(around.begin(), around.end(),
      [&](const Neighbor& neighbor) { return neighbor.SquareDistance <= radius * radius; });
  };
  double inMiddle = 0.0, atEnds = 0.0;
  for (Index i = 0; i < points.rows(); i += CountedStep)
  {
    if (isInner[i])
    {
      const Vector3 x = points.row(i), y = places.row(outside.nearest(x).Id);
      const double radius = BallOfWall * (x - y).norm();
      inMiddle += static_cast<double>(count(0.5 * (x + y), radius));
      atEnds += 0.5 * static_cast<double>(count(x, radius) + count(y, radius)) - 1.0;
    }
  }
  return inMiddle <= FilledWall * atEnds;
}
}

//------------------------------------------------------------------------------
bool NestedLayers::isInner(const Vector3& x) const
{
  return this->Sorted->IsInner[this->Sorted->Tree.nearest(x).Id];
}

//------------------------------------------------------------------------------
NestedLayers findNestedLayers(const TrainingSamples& samples, const Run& run)
{
  constexpr double reach = 1.5;
  if (samples.totalSize() < MinimumSamples || samples.dimension() < 3)
  {
    return {};
  }
  const Points points = selectedSamples(samples, WantedSamples);
  const SampleSpacing spacings(points);
  const double step = spacings.median();
  const double spacing = std::clamp(
    step * std::sqrt(static_cast<double>(points.rows()) / static_cast<double>(samples.totalSize())),
    MinimumSpacing, MaximumSpacing);
  const Regions regions = regionsOf(samples, spacing, run);
  if (regions.End == FirstRegion)
  {
    return {};
  }
  std::vector<Seen> seen(points.rows());
  constexpr Index blockSize = 256;
  forBlocks(run.unwatched(), points.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        seen[i] = seenFrom(regions, points.row(i));
      }
    });
  std::vector<char> isInner = innerSamples(regions, points, seen, reach * step);
  const auto inner = static_cast<double>(std::count(isInner.begin(), isInner.end(), 1));
  if (inner < FewestInner * static_cast<double>(points.rows()))
  {
    return {};
  }
  auto sorted = std::make_shared<NestedLayers::SortedSamples>();
  sorted->Tree = spacings.tree();
  if (!wallIsEmpty(points, sorted->Tree, isInner, seen))
  {
    return {};
  }
  sorted->IsInner = smoothed(points, sorted->Tree, isInner);
  NestedLayers layers;
  layers.Sorted = std::move(sorted);
  return layers;
}
}
