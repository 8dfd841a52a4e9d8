/// Check whether coordinates can be stored as 32-bit floats, for writers of formats that have no
/// doubles.

#ifndef ConformalFloatRange_h
#define ConformalFloatRange_h

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace conformal
{
/// Reject coordinates outside of the range of floats. Also reject coordinates if all are so small
/// that floats would round them to a few digits or to 0. A small coordinate is accepted if others
/// are large; it may become 0.
/// @param[in] coordinate  called with each index below count
/// @throws std::invalid_argument
template <typename Coordinate>
void requireFloatRange(std::size_t count, Coordinate coordinate)
{
  using Limits = std::numeric_limits<float>;
  double maximum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double size = std::abs(coordinate(i));
    if (!(size <= Limits::max()))
    {
      throw std::invalid_argument("a coordinate is not finite as a 32-bit float");
    }
    maximum = std::max(maximum, size);
  }
  if (maximum > 0.0 && maximum < Limits::min())
  {
    throw std::invalid_argument("the coordinates are too small for 32-bit floats, the only type of "
                                "the format; scale the surface");
  }
}

/// Effect of rounding points to floats, in the unit of their coordinates.
struct FloatRounding
{
  double MaximumShift = 0.0; ///< maximum shift of a coordinate
  std::array<double, 3> Low = { 0.0, 0.0, 0.0 };
  std::array<double, 3> High = { 0.0, 0.0, 0.0 };

  /// Return the diagonal of the bounding box.
  double size() const
  {
    return std::hypot(
      this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2]);
  }

  /// Test whether a coordinate is shifted by more than ToleratedShift times size(). Otherwise
  /// points stay distinct if they are farther apart than twice this limit. The result is false if
  /// all points coincide.
  bool isTooCoarse() const
  {
    return this->size() > 0.0 && this->MaximumShift > ToleratedShift * this->size();
  }

  /// Own construction: a maximum relative shift, because the effect of rounding grows with the
  /// distance of the surface from the origin. For a surface around the origin, floats shift points
  /// by 3e-8 of the size. At a distance of about 200 times the size, the shift reaches this limit.
  static constexpr double ToleratedShift = 1e-5;
};

/// Measure the effect of rounding coordinates to floats.
/// @param[in] count       number of coordinates, 3 for each point
/// @param[in] coordinate  called with each index below count; in the range of floats
template <typename Coordinate>
FloatRounding floatRoundingOf(std::size_t count, Coordinate coordinate)
{
  FloatRounding result;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = coordinate(i);
    double& low = result.Low[i % 3];
    double& high = result.High[i % 3];
    low = i < 3 ? value : std::min(low, value);
    high = i < 3 ? value : std::max(high, value);
    const double shift = std::abs(value - static_cast<double>(static_cast<float>(value)));
    result.MaximumShift = std::max(result.MaximumShift, shift);
  }
  return result;
}

/// Reject points whose shape floats would change.
/// @throws std::invalid_argument if isTooCoarse(); the message has the shift, the size, and a
///   remedy
inline void requireFinePositions(const FloatRounding& rounding)
{
  if (!rounding.isTooCoarse())
  {
    return;
  }
  const auto shortText = [](double value) // three digits, in every locale
  {
    char buffer[40];
    const auto result =
      std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, 3);
    return std::string(buffer, result.ptr);
  };
  throw std::invalid_argument("the surface is too far from the origin for 32-bit floats, the only "
                              "type of the format: they shift coordinates by up to " +
    shortText(rounding.MaximumShift) + " on a surface of size " + shortText(rounding.size()) +
    "; subtract its center from the points, or write a format of doubles, such as PLY");
}
}

#endif
