#include "Cloud/Copies.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 1 << 14;
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

// Mark the copies within one part. Return their number on all ranks.
Index markCopies(const Part& part, const Reduce& reduce, std::vector<bool>& isCopy)
{
  const Share share = shareOf(reduce, static_cast<std::int64_t>(part.Keys.size()));
  const std::vector<std::int64_t> all = gatherIntegers(reduce, part.Keys);
  std::vector<std::pair<std::int64_t, Index>> sorted(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    sorted[i] = { all[i], static_cast<Index>(i) };
  }
  std::sort(sorted.begin(), sorted.end());
  Index count = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].first == sorted[i - 1].first)
    {
      ++count;
      const Index own = sorted[i].second - share.Before;
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
  forBlocks(run, points.size(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        keys[i] = (skip && skip(i)) || !points[i].allFinite() ? NoKey : keyOf(points[i]);
      }
    });
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
    run.report(static_cast<double>(part + 1) / static_cast<double>(parts));
  }
  if (result.Count > 0)
  {
    result.IsCopy = std::move(isCopy);
  }
  return result;
}
}
