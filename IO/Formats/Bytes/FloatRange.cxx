#include "Bytes/FloatRange.h"

#include <charconv>
#include <string>

namespace conformal
{
namespace
{
// Three digits, in every locale.
std::string shortText(double value)
{
  char buffer[40];
  const auto end =
    std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, 3).ptr;
  return { buffer, end };
}
}

//------------------------------------------------------------------------------
void requireFinePositions(const FloatRounding& rounding)
{
  if (rounding.isTooCoarse())
  {
    throw std::invalid_argument("the surface is too far from the origin for 32-bit floats, which "
                                "is all that the format has: they shift coordinates by up to " +
      shortText(rounding.LargestShift) + " on a surface of size " + shortText(rounding.size()) +
      "; subtract its center from the points, or write a format of doubles, such as PLY");
  }
}
}
