/// Generate pseudorandom numbers that depend only on a seed, not on the machine.

#ifndef ConformalRandom_h
#define ConformalRandom_h

#include "Base/Types.h"

#include <algorithm>
#include <cstdint>
#include <random>

namespace conformal
{
/// Pseudorandom numbers from the Mersenne Twister. The C++ standard specifies the numbers of
/// std::mt19937_64, but not the numbers of its distributions. This class therefore computes uniform
/// numbers without a standard distribution.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  /// Return a uniformly distributed number in [0, 1).
  double uniform() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

  /// Return a uniformly distributed id in [0, size).
  Index index(Index size)
  {
    return std::min(static_cast<Index>(this->uniform() * static_cast<double>(size)), size - 1);
  }

private:
  std::mt19937_64 Engine;
};
}

#endif
