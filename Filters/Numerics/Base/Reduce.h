/// Add integers over all ranks (MPI processes). Each rank stores a part of the input points.

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
/// Sum of integers over all ranks (MPI processes). All ranks must make the same calls in the same
/// sequence, with equal counts. Integer sums do not depend on the order of addition. Results
/// therefore have the same bits for any number of ranks. Every other reduction (combination of
/// values of all ranks) is expressed as an integer sum.
struct Reduce
{
  int Rank = 0; ///< rank of this process, in [0, NumberOfRanks)
  int NumberOfRanks = 1;
  /// Function that replaces each of `count` values by its sum over all ranks. If there is only one
  /// rank, the function is empty.
  std::function<void(std::int64_t* values, Index count)> Sum;

  void sum(std::int64_t* values, Index count) const
  {
    if (this->Sum)
    {
      this->Sum(values, count);
    }
  }
};

/// Position of one rank's items in the concatenation of the items of all ranks, in rank order.
struct Share
{
  std::int64_t Before = 0; ///< number of items on lower ranks
  std::int64_t Total = 0;  ///< number of items on all ranks
};

inline Share shareOf(const Reduce& reduce, std::int64_t own)
{
  std::vector<std::int64_t> sizes(reduce.NumberOfRanks, 0);
  sizes[reduce.Rank] = own;
  reduce.sum(sizes.data(), reduce.NumberOfRanks);
  return { std::accumulate(sizes.begin(), sizes.begin() + reduce.Rank, std::int64_t(0)),
    std::accumulate(sizes.begin(), sizes.end(), std::int64_t(0)) };
}

/// Concatenate the integers of all ranks in rank order, on every rank.
inline std::vector<std::int64_t> gatherIntegers(
  const Reduce& reduce, const std::vector<std::int64_t>& own)
{
  if (reduce.NumberOfRanks == 1)
  {
    return own;
  }
  // All other ranks add 0, so that the bits do not change.
  const auto [first, size] = shareOf(reduce, static_cast<std::int64_t>(own.size()));
  std::vector<std::int64_t> all(size, 0);
  std::copy(own.begin(), own.end(), all.begin() + first);
  reduce.sum(all.data(), size);
  return all;
}

/// Concatenate the numbers of all ranks in rank order, on every rank.
inline std::vector<double> gather(const Reduce& reduce, const std::vector<double>& own)
{
  if (reduce.NumberOfRanks == 1)
  {
    return own;
  }
  // Each number is sent as an integer with the same bits.
  std::vector<std::int64_t> bits(own.size());
  std::transform(own.begin(), own.end(), bits.begin(),
    [](double number)
    {
      std::int64_t itsBits = 0;
      std::memcpy(&itsBits, &number, sizeof(number));
      return itsBits;
    });
  bits = gatherIntegers(reduce, bits);
  std::vector<double> all(bits.size());
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
