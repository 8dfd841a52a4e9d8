/// Fixed-point sums: the result does not depend on the order of addition.

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
/// Sums of numbers of magnitude up to about 1, in integer steps of 2^-38. Integers add the same in
/// any order, so threads and processes may add as they come and the bits stay the same. There is
/// room for 2^24 addends of magnitude 2 in one sum.
class FixedPointSums
{
public:
  explicit FixedPointSums(Index size = 0)
    : Steps(size, 0)
  {
  }
  void add(Index i, double value) { this->Steps[i] += std::llrint(value * Unit); }
  double operator[](Index i) const { return static_cast<double>(this->Steps[i]) / Unit; }

  /// All sums back to zero.
  void clear() { std::fill(this->Steps.begin(), this->Steps.end(), 0); }

  /// Add what the other processes have.
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
