/// Whether coordinates can be stored as 32-bit floats, for the writers of formats that have no
/// other.

#ifndef ConformalFloatRange_h
#define ConformalFloatRange_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace conformal
{
/// Refuse coordinates that a float cannot hold, or that are so small that floats would round the
/// largest of them to a few digits or to 0. Beside a large coordinate a small one may become 0.
/// @param[in] coordinate  called with each index below count
/// @throws std::invalid_argument
template <typename Coordinate>
void requireFloatRange(std::size_t count, Coordinate coordinate)
{
  using Limits = std::numeric_limits<float>;
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double size = std::abs(coordinate(i));
    if (!(size <= Limits::max()))
    {
      throw std::invalid_argument("a coordinate is not finite as a 32-bit float");
    }
    largest = std::max(largest, size);
  }
  if (largest > 0.0 && largest < Limits::min())
  {
    throw std::invalid_argument(
      "the coordinates are too small for 32-bit floats, which is all that "
      "the format has; scale the surface");
  }
}
}

#endif
