#include "Hull/CloudDistance.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/StrayPoints.h"
#include "Search/BoxTree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr Index SamplesPerBlock = 1 << 12;
constexpr int PlanesPerReport = 16;
constexpr double SamplesPerSquare = 32.0; // samples per square of the grid spacing

// The second sweep along each axis propagates seeds around corners that block the first.
constexpr int NumberOfSweeps = 6;

// Square distance in the high bits, id in the low bits: as integers, entries compare by distance,
// then by id.
using Entry = std::uint64_t;
constexpr Entry NoEntry = std::numeric_limits<Entry>::max();

Entry makeEntry(float squareDistance, std::uint32_t id)
{
  std::uint32_t bits;
  std::memcpy(&bits, &squareDistance, sizeof(bits)); // preserves order, since not negative
  return static_cast<Entry>(bits) << 32 | id;
}

float squareDistanceOf(Entry entry)
{
  const std::uint32_t bits = static_cast<std::uint32_t>(entry >> 32);
  float squareDistance;
  std::memcpy(&squareDistance, &bits, sizeof(bits));
  return squareDistance;
}

// Compute the number of nodes along each axis for a grid that contains a box, without a margin.
Vector3 stepsOver(const Box& bounds, double spacing)
{
  return ((bounds.Upper - bounds.Lower) / spacing).array().floor() + 2.0;
}

// Compute the minimum spacing of a grid within MaximumNumberOfNodes, rounded up to 1e-6.
double minimumSpacing(const Box& bounds, double tooSmall, int margin)
{
  const auto fits = [&](double spacing)
  {
    return (stepsOver(bounds, spacing).array() + 2.0 * margin).prod() <=
      static_cast<double>(MaximumNumberOfNodes);
  };
  double low = tooSmall, high = 2.0 * tooSmall;
  for (; !fits(high); high *= 2.0)
  {
    low = high;
  }
  constexpr double Digit = 1e-6;
  while (high - low > 0.1 * Digit)
  {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? high : low) = middle;
  }
  return std::ceil(high / Digit) * Digit;
}

// Find the nearest sample of every node by propagation.
class NearestSamples
{
public:
  NearestSamples(const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run)
    : Grid(grid)
    , Taken(selectSamples(samples, SamplesPerSquare / (grid.Spacing * grid.Spacing)).Positions)
    , Threads(run.unwatched())
    , Entries(grid.numberOfNodes())
  {
    forBlocks(this->Threads, grid.numberOfNodes(), 1 << 16,
      [&](Index begin, Index end)
      {
        for (Index node = begin; node < end; ++node)
        {
          this->Entries[node].store(NoEntry, std::memory_order_relaxed);
        }
      });
  }

  // Mark samples that do not lie on the surface of the others, since these would cause bumps.
  void dropStray(const Run& run) { this->Stray = strayPoints(this->Taken, run); }

  // Update the 8 corners of the cube of every sample. The minimum does not depend on the order.
  void scatter(const Run& run)
  {
    const std::array<int, 8> steps = this->Grid.cornerSteps();
    forBlocksReporting(run, this->Taken.rows(), SamplesPerBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          if (this->Stray[i])
          {
            continue;
          }
          const auto sample = static_cast<std::uint32_t>(i);
          const Eigen::Vector3f x = this->place(sample);
          const Eigen::Vector3f f = x - x.array().floor().matrix(), g = f.array() - 1.0F;
          const Eigen::Vector3f lower = f.cwiseAbs2(), upper = g.cwiseAbs2();
          const int node = this->cubeOf(x);
          for (int s = 0; s < 8; ++s)
          {
            const float square = ((s & 1) ? upper : lower)[0] + ((s & 2) ? upper : lower)[1] +
              ((s & 4) ? upper : lower)[2];
            this->offer(node + steps[s], makeEntry(square, sample));
          }
        }
      });
  }

  // Remove isolated samples, whose cubes form small components of the grid. This requires a dense
  // cloud, in which isolation is significant, and few such samples.
  void dropIsolated(const Run& run)
  {
    constexpr std::uint8_t untouched = 0, touched = 1, large = 2, small = 3;
    constexpr std::size_t maximumIsolated = 32; // corners of four separate cubes
    constexpr Index nodesPerSample = 4;         // 8 for a single cube, 1 or 2 for a sheet of cubes
    constexpr Index minimumRatio = 20;          // all samples over isolated ones
    const Index size = this->Grid.numberOfNodes();
    std::vector<std::uint8_t> marks(size);
    Index numberTouched = 0;
    for (Index node = 0; node < size; ++node)
    {
      marks[node] = this->entry(node) == NoEntry ? untouched : touched;
      numberTouched += marks[node];
    }
    if (numberTouched > nodesPerSample * this->Taken.rows())
    {
      return;
    }
    std::vector<int> piece, isolated;
    for (Index node = 0; node < size; ++node)
    {
      if (marks[node] == touched)
      {
        markPiece(this->Grid, marks, static_cast<int>(node), large, piece, run);
        if (piece.size() <= maximumIsolated)
        {
          isolated.insert(isolated.end(), piece.begin(), piece.end());
        }
      }
    }
    for (const int node : isolated)
    {
      marks[node] = small;
    }
    Index count = 0;
    for (Index i = 0; i < this->Taken.rows() && !isolated.empty(); ++i)
    {
      count += marks[this->cubeOf(this->place(i))] == small;
    }
    if (minimumRatio * count <= this->Taken.rows())
    {
      for (const int node : isolated)
      {
        this->Entries[node].store(NoEntry, std::memory_order_relaxed);
      }
    }
    run.report(1.0);
  }

  // Replace sample ids by indices into a small table, since nodes share few samples of a large
  // cloud.
  void gatherSeeds(const Run& run)
  {
    forBlocksReporting(run.inOrder(), this->Grid.numberOfNodes(), 1 << 10,
      [&](Index begin, Index end)
      {
        for (Index node = begin; node < end; ++node)
        {
          const Entry entry = this->entry(node);
          if (entry != NoEntry)
          {
            const auto sample = static_cast<std::uint32_t>(entry);
            this->Entries[node].store(
              makeEntry(squareDistanceOf(entry), static_cast<std::uint32_t>(this->Seeds.size())),
              std::memory_order_relaxed);
            this->Seeds.push_back(this->place(sample));
          }
        }
      });
  }

  // Propagate seeds forward and backward along all lines of an axis.
  void sweep(int axis, const Run& run)
  {
    // Process the planes that contain the lines, in groups.
    const std::array<int, 3>& size = this->Grid.Size;
    const int normal = axis == 2 ? 1 : 2;
    const int groups = (size[normal] + PlanesPerReport - 1) / PlanesPerReport;
    for (int group = 0; group < groups; ++group)
    {
      const int first = group * PlanesPerReport;
      const int count = std::min(PlanesPerReport, size[normal] - first);
      forBlocks(this->Threads, count, 1,
        [&](Index begin, Index)
        {
          const int plane = first + static_cast<int>(begin);
          if (axis == 0)
          {
            this->sweepRows(plane);
          }
          else
          {
            this->sweepPlane(axis, normal, plane);
          }
        });
      run.report((group + 1.0) / groups);
    }
  }

  std::vector<float> distances() const
  {
    std::vector<float> result(this->Entries.size());
    forBlocks(this->Threads, static_cast<Index>(this->Entries.size()), 1 << 16,
      [&](Index begin, Index end)
      {
        for (Index node = begin; node < end; ++node)
        {
          result[node] = std::sqrt(squareDistanceOf(this->entry(node)));
        }
      });
    return result;
  }

private:
  Entry entry(Index node) const { return this->Entries[node].load(std::memory_order_relaxed); }
  Eigen::Vector3f place(Index sample) const
  {
    return this->Grid.toGrid(this->Taken.row(sample)).cast<float>();
  }
  // Return the lowest corner of the cube that contains a position.
  int cubeOf(const Eigen::Vector3f& x) const
  {
    const Eigen::Vector3i low = x.array().floor().cast<int>();
    return this->Grid.node(low[0], low[1], low[2]);
  }

  void offer(int node, Entry entry)
  {
    std::atomic<Entry>& held = this->Entries[node];
    Entry best = held.load(std::memory_order_relaxed);
    while (entry < best && !held.compare_exchange_weak(best, entry, std::memory_order_relaxed))
    {
    }
  }

  void sweepRows(int z)
  {
    const std::array<int, 3>& size = this->Grid.Size;
    for (int y = 0; y < size[1]; ++y)
    {
      const int row = this->Grid.node(0, y, z);
      for (int x = 1; x < size[0]; ++x)
      {
        this->handOn(row + x - 1, row + x, { x, y, z });
      }
      for (int x = size[0] - 2; x >= 0; --x)
      {
        this->handOn(row + x + 1, row + x, { x, y, z });
      }
    }
  }

  // Process whole rows, which are contiguous in memory.
  void sweepPlane(int axis, int normal, int plane)
  {
    const std::array<int, 3>& size = this->Grid.Size;
    Eigen::Vector3i start = Eigen::Vector3i::Zero();
    start[normal] = plane;
    const auto handOnRow = [&](int from, int to)
    {
      Eigen::Vector3i source = start, place = start;
      source[axis] = from;
      place[axis] = to;
      const int fromNode = this->Grid.node(0, source[1], source[2]);
      const int toNode = this->Grid.node(0, place[1], place[2]);
      for (int x = 0; x < size[0]; ++x)
      {
        this->handOn(fromNode + x, toNode + x, { x, place[1], place[2] });
      }
    };
    for (int line = 1; line < size[axis]; ++line)
    {
      handOnRow(line - 1, line);
    }
    for (int line = size[axis] - 2; line >= 0; --line)
    {
      handOnRow(line + 1, line);
    }
  }

  void handOn(int from, int to, const Eigen::Vector3i& place)
  {
    const Entry theirs = this->entry(from);
    const Entry ours = this->entry(to);
    const auto seed = static_cast<std::uint32_t>(theirs);
    if (theirs == NoEntry || seed == static_cast<std::uint32_t>(ours))
    {
      return;
    }
    const float square = (this->Seeds[seed] - place.cast<float>()).squaredNorm();
    this->Entries[to].store(std::min(ours, makeEntry(square, seed)), std::memory_order_relaxed);
  }

  const FreudenthalGrid& Grid;
  const Points Taken;              ///< the samples used
  const Run Threads;               // without progress
  std::vector<std::uint8_t> Stray; ///< for each sample used
  std::vector<std::atomic<Entry>> Entries;
  std::vector<Eigen::Vector3f> Seeds; ///< in grid coordinates
};
}

//------------------------------------------------------------------------------
FreudenthalGrid gridAround(
  const TrainingSamples& samples, double spacing, int margin, const Run& run)
{
  std::vector<Box> boxes((samples.size() + SamplesPerBlock - 1) / SamplesPerBlock);
  forBlocksReporting(run, samples.size(), SamplesPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        boxes[begin / SamplesPerBlock].extend(samples[i]);
      }
    });
  Box own;
  for (const Box& box : boxes)
  {
    own.extend(box);
  }
  const std::vector<double> corners = gather(samples.reduce(),
    { own.Lower[0], own.Lower[1], own.Lower[2], own.Upper[0], own.Upper[1], own.Upper[2] });
  Box bounds;
  for (std::size_t i = 0; i < corners.size(); i += 6)
  {
    bounds.Lower = bounds.Lower.cwiseMin(Eigen::Map<const Vector3>(corners.data() + i));
    bounds.Upper = bounds.Upper.cwiseMax(Eigen::Map<const Vector3>(corners.data() + i + 3));
  }
  return gridAround(bounds, spacing, margin);
}

//------------------------------------------------------------------------------
FreudenthalGrid gridAround(const Box& bounds, double spacing, int margin)
{
  const Vector3 steps = stepsOver(bounds, spacing);
  const double nodes = (steps.array() + 2.0 * margin).prod();
  if (!(nodes <= static_cast<double>(MaximumNumberOfNodes)))
  {
    throw std::invalid_argument("a grid of spacing " + std::to_string(spacing) +
      " times the largest radius would have " + std::to_string(std::llround(nodes)) +
      " nodes around these points; the limit is " + std::to_string(MaximumNumberOfNodes) +
      ", and the smallest spacing possible here " +
      std::to_string(minimumSpacing(bounds, spacing, margin)));
  }
  FreudenthalGrid grid;
  grid.Spacing = spacing;
  // Center the cloud; no sample lies on the last node of an axis.
  grid.Origin =
    0.5 * (bounds.Lower + bounds.Upper) - spacing * (0.5 * (steps.array() - 1.0) + margin).matrix();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = static_cast<int>(steps[axis]) + 2 * margin;
  }
  return grid;
}

//------------------------------------------------------------------------------
std::vector<float> distanceToSamples(
  const FreudenthalGrid& grid, const TrainingSamples& samples, const Run& run)
{
  std::vector<double> shares = { 0.02, 0.65, 0.04, 0.02, 0.02 };
  shares.insert(shares.end(), NumberOfSweeps, 0.04);
  shares.push_back(0.01);
  Steps steps(run, shares);
  steps.next();
  NearestSamples nearest(grid, samples, run);
  nearest.dropStray(steps.next());
  nearest.scatter(steps.next());
  nearest.dropIsolated(steps.next());
  nearest.gatherSeeds(steps.next());
  for (int i = 0; i < NumberOfSweeps; ++i)
  {
    nearest.sweep(i % 3, steps.next());
  }
  steps.next();
  return nearest.distances();
}
}
