#include "Cloud/FootPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 256;

// Item and the number (Morton key) of its grid cell. Neighboring cells usually have close numbers.
struct Cell
{
  std::uint32_t Key, Item;
};

constexpr int BitsOfAxis = 10, BitsOfKey = 3 * BitsOfAxis;

// Spread the bits of a number below 1024: insert two zero bits before each bit.
std::uint32_t spreadBits(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

// Compute the Morton key of a sample, on a grid over the cube [-1, 1]^3 that contains all samples.
std::uint32_t keyOf(const Vector3& x)
{
  constexpr double cells = 1 << BitsOfAxis;
  std::uint32_t key = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double place = std::clamp(0.5 * (x[k] + 1.0) * cells, 0.0, cells - 1.0);
    key |= spreadBits(static_cast<std::uint32_t>(place)) << k;
  }
  return key;
}

// Sort stably by keys.
void sortByKey(std::vector<Cell>& cells)
{
  constexpr int bitsOfDigit = 10;
  constexpr std::uint32_t digits = 1u << bitsOfDigit;
  std::vector<Cell> sorted(cells.size());
  for (int shift = 0; shift < BitsOfKey; shift += bitsOfDigit)
  {
    std::array<std::uint32_t, digits + 1> begin{};
    for (const Cell& cell : cells)
    {
      ++begin[(cell.Key >> shift) % digits + 1];
    }
    for (std::uint32_t digit = 0; digit < digits; ++digit)
    {
      begin[digit + 1] += begin[digit];
    }
    for (const Cell& cell : cells)
    {
      sorted[begin[(cell.Key >> shift) % digits]++] = cell;
    }
    cells.swap(sorted);
  }
}
}

//------------------------------------------------------------------------------
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  constexpr Index ChunkSize = 64 * BlockSize; // 10 to 20 ms between reports
  const auto id = [&](Index i) { return idOf ? idOf(i) : i; };
  std::vector<FootPoint> found(std::min(count, ChunkSize)), feet(found.size());
  Index delivered = 0, first = 0; // closest points of samples [delivered, first) are in `found`
  const auto deliver = [&]()
  {
    for (Index i = delivered; i < first; ++i)
    {
      body(id(i), samples[id(i)], found[i - delivered]);
    }
  };
  while (delivered < count)
  {
    const Index size = std::min(ChunkSize, count - first);
    const Index blocks = (size + BlockSize - 1) / BlockSize;
    run.forEach(blocks + 1,
      [&](Index job)
      {
        if (job == 0)
        {
          deliver();
          return;
        }
        // The previous sample is often a neighbor in space: use its triangle as the hint.
        int hint = -1;
        for (Index i = (job - 1) * BlockSize; i < std::min(size, job * BlockSize); ++i)
        {
          const Index own = id(first + i);
          feet[i] = closest(own, samples[own], hint);
          hint = feet[i].Triangle;
        }
      });
    found.swap(feet);
    delivered = first;
    first += size;
    run.report(static_cast<double>(delivered) / static_cast<double>(count));
  }
}

//------------------------------------------------------------------------------
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  // Maximum number of samples sorted at a time, to limit the memory
  constexpr Index MaximumSorted = 1 << 20;
  const ClosestPoint closest = [&](Index, const Vector3& x, int hint)
  { return surface.closestPoint(x, hint); };
  std::vector<Cell> cells;
  for (Index first = 0; first < count; first += MaximumSorted)
  {
    const Index size = std::min(MaximumSorted, count - first);
    const auto id = [&](Index i) { return idOf ? idOf(first + i) : first + i; };
    cells.resize(size);
    forBlocks(run, size, BlockSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          cells[i] = { keyOf(samples[id(i)]), static_cast<std::uint32_t>(i) };
        }
      });
    sortByKey(cells);
    const auto whole = static_cast<double>(count);
    forEachFoot(
      samples, closest, size, [&](Index i) { return id(cells[i].Item); },
      [&, next = Index(0)](Index, const Vector3& x, const FootPoint& foot) mutable
      { body(first + cells[next++].Item, x, foot); },
      run.part(static_cast<double>(first) / whole, static_cast<double>(first + size) / whole));
  }
}
}
