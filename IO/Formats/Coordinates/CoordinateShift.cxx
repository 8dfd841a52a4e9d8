#include "Coordinates/CoordinateShift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace conformal
{
namespace
{
constexpr double FarDistance = 10.0;    // minimum distance from the origin [sides of the box]
constexpr double MaximumUnits = 0x1p52; // doubles above this number are integers

struct Box
{
  std::array<double, 3> Low;
  std::array<double, 3> High;

  double largestSide() const
  {
    double side = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      side = std::max(side, this->High[c] - this->Low[c]);
    }
    return side;
  }

  // Return the largest magnitude of a coordinate after the subtraction of a vector.
  double largestCoordinate(const std::array<double, 3>& shift) const
  {
    double largest = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      largest = std::max(
        { largest, std::abs(this->Low[c] - shift[c]), std::abs(this->High[c] - shift[c]) });
    }
    return largest;
  }
};

double coordinateOf(const NamedArray& points, std::size_t i)
{
  double value = 0.0;
  std::memcpy(&value, points.Values.data() + i * sizeof(value), sizeof(value));
  return value;
}

Box boxOf(const NamedArray& points)
{
  Box box;
  box.Low.fill(std::numeric_limits<double>::max());
  box.High.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < points.numberOfTuples(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double value = coordinateOf(points, 3 * i + c);
      box.Low[c] = std::min(box.Low[c], value);
      box.High[c] = std::max(box.High[c], value);
    }
  }
  return box;
}

// Rounding to a float changes a number by at most 2^-24 of its magnitude.
bool areFloatsSufficient(double largestCoordinate, double resolution)
{
  return std::ldexp(largestCoordinate, -24) <= resolution / 4 &&
    largestCoordinate <= std::numeric_limits<float>::max() &&
    resolution >= std::numeric_limits<float>::min();
}

std::array<double, 3> roundCenter(const Box& box)
{
  const double unit = std::pow(10.0, std::floor(std::log10(box.largestSide())));
  std::array<double, 3> center;
  for (std::size_t c = 0; c < 3; ++c)
  {
    center[c] = box.Low[c] / 2 + box.High[c] / 2;
    const double units = center[c] / unit;
    if (std::abs(units) < MaximumUnits)
    {
      center[c] = std::round(units) * unit;
    }
  }
  return center;
}

template <typename T>
void storeAs(NamedArray& points, const std::array<double, 3>& shift)
{
  const std::size_t count = 3 * points.numberOfTuples();
  for (std::size_t i = 0; i < count; ++i) // floats are written behind the doubles still to read
  {
    const T value = static_cast<T>(coordinateOf(points, i) - shift[i % 3]);
    std::memcpy(points.Values.data() + i * sizeof(T), &value, sizeof(T));
  }
  points.Values.resize(count * sizeof(T));
}
}

//------------------------------------------------------------------------------
std::vector<double> storeCoordinates(NamedArray& points, double resolution, bool canShift)
{
  std::array<double, 3> shift = { 0.0, 0.0, 0.0 };
  const Box box = boxOf(points);
  const bool isEmpty = points.numberOfTuples() == 0;
  const double side = isEmpty ? 0.0 : box.largestSide();
  double largest = isEmpty ? 0.0 : box.largestCoordinate(shift);
  const bool isFar = side > 0.0 && largest >= FarDistance * side;
  const bool isShifted = canShift && isFar && !areFloatsSufficient(largest, resolution);
  if (isShifted)
  {
    shift = roundCenter(box);
    largest = box.largestCoordinate(shift);
  }
  if (isEmpty || areFloatsSufficient(largest, resolution))
  {
    storeAs<float>(points, shift);
    points.Type = ScalarType::Float32;
  }
  else if (isShifted)
  {
    storeAs<double>(points, shift);
  }
  return isShifted ? std::vector<double>(shift.begin(), shift.end()) : std::vector<double>();
}
}
