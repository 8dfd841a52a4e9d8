/// Parse the XML of an E57 file, which describes the scans of the file.

#ifndef ConformalE57Description_h
#define ConformalE57Description_h

#include "E57/E57Pages.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace conformal
{
enum class E57Kind
{
  Integer,
  ScaledInteger, ///< the value is Scale times the integer, plus Offset
  Float32,
  Float64,
  Text
};

/// Number that each point of a scan has.
struct E57Field
{
  std::string Name; ///< name of the element, such as cartesianX
  E57Kind Kind = E57Kind::Float64;
  std::int64_t Minimum = std::numeric_limits<std::int64_t>::min(); ///< of the integers
  std::int64_t Maximum = std::numeric_limits<std::int64_t>::max();
  double Scale = 1.0;
  double Offset = 0.0;

  bool isInteger() const
  {
    return this->Kind == E57Kind::Integer || this->Kind == E57Kind::ScaledInteger;
  }

  /// Return Maximum - Minimum of an integer, the largest number that is stored.
  std::uint64_t range() const
  {
    return static_cast<std::uint64_t>(this->Maximum) - static_cast<std::uint64_t>(this->Minimum);
  }

  /// Return the number of bits of a value in the file. Integers of one possible value have none.
  /// For texts, whose lengths differ, return 8, the minimum.
  std::size_t bits() const;
};

/// Scan of an E57 file, an element of data3D.
struct E57Scan
{
  std::array<double, 4> Rotation = { 1.0, 0.0, 0.0, 0.0 }; ///< quaternion (w, x, y, z)
  std::array<double, 3> Translation = { 0.0, 0.0, 0.0 };
  /// Numbers of colorLimits, by name, such as colorRedMaximum
  std::map<std::string, double> ColorLimits;
  std::uint64_t Section = 0; ///< physical offset of the section that contains the points
  std::uint64_t NumberOfPoints = 0;
  std::vector<E57Field> Fields; ///< in the order of the file; names are unique

  const E57Field* find(const std::string& name) const;
};

/// Read the descriptions of all scans. Scans without points have no fields.
/// @throws ParseError if the XML is malformed, or its numbers are invalid
std::vector<E57Scan> readE57Description(E57Pages& pages);
}

#endif
