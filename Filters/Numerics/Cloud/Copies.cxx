#include "Cloud/Copies.h"

#include "Base/Steps.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace conformal
{
namespace
{
constexpr Index PointsPerBlock = 1 << 14;
constexpr Index PointsPerPart = 1 << 20;

// The mixing function of \cite Steele2014: each bit of the result depends on each bit of the
// argument.
std::uint64_t mixed(std::uint64_t bits)
{
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

constexpr std::uint64_t NoKey = 0; // of a point that is not examined

// Compute a number for a position. Among ten million different positions, two have the same number
// with a probability of 3e-6; one of these points would then be left out.
std::uint64_t keyOf(const Vector3& x)
{
  std::uint64_t key = NoKey;
  for (int c = 0; c < 3; ++c)
  {
    const double coordinate = x[c] + 0.0; // 0 and -0 are equal
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    key = mixed(key + bits + 0x9e3779b97f4a7c15U);
  }
  return key;
}

// Keys of the points of one part on this rank, and their ids.
struct Part
{
  std::vector<std::int64_t> Keys;
  std::vector<Index> Ids;
};

// Set of keys: a table in which a key is at its place, or at the next free one behind.
class KeySet
{
public:
  explicit KeySet(std::size_t size)
  {
    std::size_t places = 64;
    while (places < 2 * size)
    {
      places *= 2;
    }
    this->Table.assign(places, NoKey);
  }

  // Add a key. Return false if the set has it already.
  bool add(std::uint64_t key)
  {
    const std::size_t last = this->Table.size() - 1;
    std::size_t place = (key >> 20) & last; // parts are chosen by the lower bits
    while (this->Table[place] != NoKey && this->Table[place] != key)
    {
      place = (place + 1) & last;
    }
    const bool isNew = this->Table[place] == NoKey;
    this->Table[place] = key;
    return isNew;
  }

private:
  std::vector<std::uint64_t> Table;
};

// Mark the copies within one part. Return their number on all ranks.
Index markCopies(const Part& part, const Reduce& reduce, std::vector<bool>& isCopy)
{
  const Share share = shareOf(reduce, static_cast<std::int64_t>(part.Keys.size()));
  const std::vector<std::int64_t> all = gatherIntegers(reduce, part.Keys);
  KeySet keys(all.size());
  Index count = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (!keys.add(static_cast<std::uint64_t>(all[i])))
    {
      ++count;
      const Index own = static_cast<Index>(i) - share.Before;
      if (own >= 0 && own < static_cast<Index>(part.Ids.size()))
      {
        isCopy[part.Ids[own]] = true;
      }
    }
  }
  return count;
}
}

//------------------------------------------------------------------------------
Copies findCopies(const PointView& points, const std::function<bool(Index)>& skip,
  const Reduce& reduce, const Run& run)
{
  const std::uint64_t parts = 1 + shareOf(reduce, points.size()).Total / PointsPerPart;
  std::vector<std::uint64_t> keys(points.size());
  Steps steps(run, { 0.5, 0.5 }); // keys, copies
  forBlocksReporting(steps.next(), points.size(), PointsPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        keys[i] = (skip && skip(i)) || !points[i].allFinite() ? NoKey : keyOf(points[i]);
      }
    });
  const Run marking = steps.next();
  Copies result;
  std::vector<bool> isCopy(points.size(), false);
  for (std::uint64_t part = 0; part < parts && (part == 0 || result.Count > 0); ++part)
  {
    Part own;
    for (Index i = 0; i < points.size(); ++i)
    {
      if (keys[i] != NoKey && keys[i] % parts == part)
      {
        own.Keys.push_back(static_cast<std::int64_t>(keys[i]));
        own.Ids.push_back(i);
      }
    }
    result.Count += markCopies(own, reduce, isCopy);
    marking.report(static_cast<double>(part + 1) / static_cast<double>(parts));
  }
  if (result.Count > 0)
  {
    result.IsCopy = std::move(isCopy);
  }
  return result;
}
}
