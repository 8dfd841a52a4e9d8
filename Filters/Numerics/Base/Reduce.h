/// How processes that hold parts of one cloud add up what they found.

#ifndef ConformalReduce_h
#define ConformalReduce_h

#include "Base/Types.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <vector>

namespace conformal
{
/// How processes that hold parts of one cloud add up what they found. Called by all of them, in the
/// same order and with the same counts. Sums of integers are the same in any order, hence the same
/// bits for any number of processes; what is not a sum is written as one.
struct Reduce
{
  int Rank = 0; ///< of this process, in [0, NumberOfRanks)
  int NumberOfRanks = 1;
  /// Replace each of count values by its sum over all processes; empty where there is one.
  std::function<void(std::int64_t* values, Index count)> Sum;

  void sum(std::int64_t* values, Index count) const
  {
    if (this->Sum)
    {
      this->Sum(values, count);
    }
  }
};

/// Where a process's part stands in that of all, which lie one after the other in the order of
/// ranks.
struct Share
{
  std::int64_t Before = 0; ///< of the processes of lower rank
  std::int64_t Total = 0;  ///< of all processes
};

inline Share shareOf(const Reduce& reduce, std::int64_t own)
{
  std::vector<std::int64_t> sizes(reduce.NumberOfRanks, 0);
  sizes[reduce.Rank] = own;
  reduce.sum(sizes.data(), reduce.NumberOfRanks);
  return { std::accumulate(sizes.begin(), sizes.begin() + reduce.Rank, std::int64_t(0)),
    std::accumulate(sizes.begin(), sizes.end(), std::int64_t(0)) };
}

/// The numbers of all processes one after the other, in the order of their ranks, on each of them.
inline std::vector<double> gather(const Reduce& reduce, const std::vector<double>& own)
{
  if (reduce.NumberOfRanks == 1)
  {
    return own;
  }
  const auto [first, size] = shareOf(reduce, static_cast<std::int64_t>(own.size()));
  // Bit patterns, each added to zeros, so that they arrive as they are.
  std::vector<std::int64_t> bits(size, 0);
  std::transform(own.begin(), own.end(), bits.begin() + first,
    [](double number)
    {
      std::int64_t itsBits = 0;
      std::memcpy(&itsBits, &number, sizeof(number));
      return itsBits;
    });
  reduce.sum(bits.data(), size);
  std::vector<double> all(size);
  std::transform(bits.begin(), bits.end(), all.begin(),
    [](std::int64_t itsBits)
    {
      double number = 0.0;
      std::memcpy(&number, &itsBits, sizeof(number));
      return number;
    });
  return all;
}
}

#endif
