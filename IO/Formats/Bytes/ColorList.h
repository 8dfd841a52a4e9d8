/// Convert colors of a file to bytes. In the file, the numbers of a color are byte values in [0,
/// 255] or fractions in [0, 1].

#ifndef ConformalColorList_h
#define ConformalColorList_h

#include "Bytes/ByteReader.h"
#include "Bytes/NamedArray.h"

#include <cstddef>
#include <vector>

namespace conformal
{
/// List of colors of 3 or 4 numbers: red, green, blue, and optionally opacity. Files do not state
/// the range of the numbers. If no number in the list exceeds 1, all numbers are fractions.
/// Otherwise, all numbers are byte values.
class ColorList
{
public:
  explicit ColorList(const ByteReader& input)
    : Input(input)
  {
  }

  void reserve(std::size_t count) { this->Values.reserve(4 * count); }

  /// Append a color.
  /// @throws ParseError if a number is not in [0, 255]
  void add(const double* color, std::size_t components);

  /// Append a missing color, which take() returns as white.
  void addMissing();

  /// Test whether the list contains a color that is not missing.
  bool hasAny() const { return this->HasAny; }

  /// Return the array of all colors (UInt8). The array is named "RGBA" if at least one color has 4
  /// numbers, and "RGB" if all have 3.
  NamedArray take();

private:
  const ByteReader& Input;
  std::vector<float> Values; ///< 4 numbers for each color; -1 if the color is missing
  float Maximum = 0.0F;
  std::size_t Components = 3;
  bool HasAny = false;
};
}

#endif
