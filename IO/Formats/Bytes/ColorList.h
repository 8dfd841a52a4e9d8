/// Colors read from a file, given as bytes or as fractions.

#ifndef ConformalColorList_h
#define ConformalColorList_h

#include "Bytes/ByteReader.h"
#include "Bytes/NamedArray.h"

#include <cstddef>
#include <vector>

namespace conformal
{
/// Collects colors of 3 or 4 numbers. Files do not say what they count in: if none is more than 1
/// they are fractions, else bytes.
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

  /// Append a color that the file does not give; it becomes white.
  void addMissing();

  /// Whether the file gave any.
  bool hasAny() const { return this->HasAny; }

  /// "RGB", or "RGBA" if one color has 4 numbers.
  NamedArray take();

private:
  const ByteReader& Input;
  std::vector<float> Values; ///< 4 for each, -1 where the file gives none
  float Maximum = 0.0F;
  std::size_t Components = 3;
  bool HasAny = false;
};
}

#endif
