/// Check whether coordinates can be stored as 32-bit floats, for file formats that have no doubles.

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
/// Reject coordinates that floats cannot represent. The coordinates are rejected in two cases:
/// - A coordinate is not finite, or its magnitude is above 3.4e38, the maximum of floats.
/// - The largest magnitude is above 0 but below 1.2e-38. Floats of this size have few digits, or
///   are 0.
///
/// A small coordinate is accepted if the magnitude of another coordinate is at least 1.2e-38.
/// Floats may then round the small coordinate to 0.
///
/// @param[in] count       number of coordinates
/// @param[in] coordinate  function that returns the coordinate of an index below `count`
/// @throws std::invalid_argument if the coordinates are rejected
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

/// Round a value of an array to a float.
/// @throws std::invalid_argument if the value is finite, but beyond the range of floats
inline float floatOf(double value, const std::string& array)
{
  if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max())
  {
    throw std::invalid_argument(
      "array \"" + array + "\" has values that a 32-bit float cannot hold");
  }
  return static_cast<float>(value);
}

/// Effect of rounding the points of a surface to floats. All members are in the unit of the points.
struct FloatRounding
{
  double MaximumShift = 0.0;                      ///< maximum change of a coordinate by rounding
  std::array<double, 3> Low = { 0.0, 0.0, 0.0 };  ///< minimum corner of the bounding box
  std::array<double, 3> High = { 0.0, 0.0, 0.0 }; ///< maximum corner of the bounding box

  /// Return the diagonal of the bounding box.
  double size() const
  {
    return std::hypot(
      this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2]);
  }

  /// Test whether rounding changes a coordinate by more than the limit, ToleratedShift times
  /// size(). If all points coincide, the result is false. If the result is false, points whose
  /// distance along an axis exceeds twice the limit stay distinct after rounding.
  bool isTooCoarse() const
  {
    return this->size() > 0.0 && this->MaximumShift > ToleratedShift * this->size();
  }

  /// Maximum tolerated change of a coordinate, relative to the size of the surface (the diagonal of
  /// its bounding box). Own construction: the limit detects surfaces far from the origin, since
  /// rounding changes large coordinates more. If the center of the surface is the origin, rounding
  /// changes coordinates by at most 3e-8 of the size. The change reaches the limit if the distance
  /// of the surface from the origin is about 200 times the size.
  static constexpr double ToleratedShift = 1e-5;
};

/// Measure the effect of rounding coordinates to floats.
/// @param[in] count       number of coordinates, 3 for each point
/// @param[in] coordinate  function that returns the coordinate of an index below `count`; all
///   coordinates must be in the range of floats
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

/// Reject a surface if rounding to floats would change its coordinates too much.
/// @throws std::invalid_argument if rounding.isTooCoarse(). The message contains the change of
///   coordinates, the size of the surface, and a remedy
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
