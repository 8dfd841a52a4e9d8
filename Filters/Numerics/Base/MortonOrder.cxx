#include "Base/MortonOrder.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace conformal
{
namespace
{
constexpr int BitsOfAxis = 10, BitsOfKey = 3 * BitsOfAxis;

struct Cell
{
  std::uint32_t Key;
  int Id;
};

// Spread the bits of a number below 1024: insert two zero bits before each bit.
std::uint32_t spreadBits(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

std::uint32_t keyOf(const Vector3& x)
{
  constexpr double cells = 1 << BitsOfAxis;
  std::uint32_t key = 0;
  for (int k = 0; k < 3; ++k)
  {
    key |= spreadBits(static_cast<std::uint32_t>(std::clamp(x[k] * cells, 0.0, cells - 1.0))) << k;
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
std::vector<int> mortonOrder(
  Index count, const std::function<Vector3(Index)>& place, const Run& run)
{
  std::vector<Cell> cells(count);
  forBlocks(run, count, LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        cells[i] = { keyOf(place(i)), static_cast<int>(i) };
      }
    });
  sortByKey(cells);
  std::vector<int> ids(count);
  std::transform(cells.begin(), cells.end(), ids.begin(), [](const Cell& cell) { return cell.Id; });
  return ids;
}
}
