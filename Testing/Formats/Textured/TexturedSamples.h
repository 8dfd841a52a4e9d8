// Make a textured surface, and read numbers of binary files, for tests.
#ifndef TexturedSamples_h
#define TexturedSamples_h

#include "Textured/TexturedSurface.h"

#include <cstdint>
#include <cstring>
#include <string>

namespace samples
{
inline conformal::TexturedSurface triangle()
{
  conformal::TexturedSurface surface;
  surface.Positions = { 0, 0, 0, 1.5, 0, 0, 0, 0.1, -2 };
  surface.TexCoords = { 0, 0, 1, 0.25F, 0.5F, 1 };
  surface.Corners = { 0, 1, 2 };
  return surface;
}

// Return the little-endian number at a position.
inline std::uint32_t uint32At(const std::string& bytes, std::size_t offset)
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    value |= std::uint32_t(static_cast<unsigned char>(bytes.at(offset + i))) << 8 * i;
  }
  return value;
}

inline float floatAt(const std::string& bytes, std::size_t offset)
{
  const std::uint32_t bits = uint32At(bytes, offset);
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}
}

#endif
