/// Pseudorandom numbers that are the same on every machine for the same seed.

#ifndef ConformalRandom_h
#define ConformalRandom_h

#include "Base/Types.h"

#include <algorithm>
#include <cstdint>
#include <random>

namespace conformal
{
/// The standard fixes the engine's numbers but not those of its distributions, hence this.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

  /// In [0, size).
  Index index(Index size)
  {
    return std::min(static_cast<Index>(this->uniform() * static_cast<double>(size)), size - 1);
  }

private:
  std::mt19937_64 Engine;
};
}

#endif
