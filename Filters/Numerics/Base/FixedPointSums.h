/// Add real numbers as fixed-point numbers, so that sums do not depend on the order of addition.
/// Fixed-point numbers are stored as integers, whose addition is associative. Threads and ranks
/// (MPI processes) can thus add in any order. Sums by fixed-point numbers are our own construction,
/// not from a publication.

#ifndef ConformalFixedPointSums_h
#define ConformalFixedPointSums_h

#include "Base/Reduce.h"
#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Sums of numbers of magnitude up to about 1, stored as integer multiples of 2^-38. The bits of a
/// sum do not depend on the order in which threads and ranks add. A sum does not overflow for fewer
/// than 2^24 numbers of magnitude up to 2.
class FixedPointSums
{
public:
  explicit FixedPointSums(Index size = 0)
    : Steps(size, 0)
  {
  }
  void add(Index i, double value) { this->Steps[i] += std::llrint(value * Unit); }
  double operator[](Index i) const { return static_cast<double>(this->Steps[i]) / Unit; }

  /// Reset all sums to zero.
  void clear() { std::fill(this->Steps.begin(), this->Steps.end(), 0); }

  /// Replace each sum by its total over all ranks.
  void reduce(const Reduce& reduce)
  {
    reduce.sum(this->Steps.data(), static_cast<Index>(this->Steps.size()));
  }

private:
  static constexpr double Unit = 0x1p38;
  std::vector<std::int64_t> Steps;
};
}

#endif
