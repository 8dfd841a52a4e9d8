/// Colors read from a file, given as bytes or as fractions.

#ifndef ConformalColorList_h
#define ConformalColorList_h

#include "Bytes/ByteReader.h"
#include "Bytes/NamedArray.h"

#include <cstddef>
#include <vector>

namespace conformal
{
/// List of colors of 3 or 4 numbers. Files do not state the range of the numbers. If no number
/// exceeds 1, colors are fractions; otherwise they are bytes.
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

  /// Append white in place of a missing color.
  void addMissing();

  /// Test whether any color was appended that is not missing.
  bool hasAny() const { return this->HasAny; }

  /// Return the array of all colors, named "RGB", or "RGBA" if a color has 4 numbers.
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
