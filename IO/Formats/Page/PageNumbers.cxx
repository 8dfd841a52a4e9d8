#include "Page/PageNumbers.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
//------------------------------------------------------------------------------
PageRange rangeOf(const std::vector<double>& values)
{
  PageRange range;
  bool isFirst = true;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range.Low = isFirst ? value : std::min(range.Low, value);
      range.High = isFirst ? value : std::max(range.High, value);
      isFirst = false;
    }
  }
  return range;
}

//------------------------------------------------------------------------------
std::uint32_t codeOf(double value, const PageRange& range, std::uint32_t steps)
{
  const double length = range.High - range.Low;
  if (!(length > 0.0))
  {
    return 0;
  }
  const double fraction = std::isfinite(length)
    ? (value - range.Low) / length
    : (0.5 * value - 0.5 * range.Low) / (0.5 * range.High - 0.5 * range.Low);
  return static_cast<std::uint32_t>(std::round(std::clamp(fraction, 0.0, 1.0) * steps));
}

//------------------------------------------------------------------------------
double valueOfCode(std::uint32_t code, const PageRange& range, std::uint32_t steps)
{
  const double fraction = steps > 0 ? static_cast<double>(code) / steps : 0.0;
  return range.Low * (1.0 - fraction) + range.High * fraction;
}

//------------------------------------------------------------------------------
std::array<std::uint32_t, 2> octahedralCode(double x, double y, double z)
{
  const double maximum = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  x /= maximum; // avoid overflow of the sum below
  y /= maximum;
  z /= maximum;
  const double sum = std::abs(x) + std::abs(y) + std::abs(z);
  double u = x / sum;
  double v = y / sum;
  if (z < 0.0)
  {
    const double folded = (1.0 - std::abs(v)) * (u < 0.0 ? -1.0 : 1.0);
    v = (1.0 - std::abs(u)) * (v < 0.0 ? -1.0 : 1.0);
    u = folded;
  }
  const PageRange range = { -1.0, 1.0 };
  return { codeOf(u, range, PositionSteps), codeOf(v, range, PositionSteps) };
}

//------------------------------------------------------------------------------
std::array<double, 3> octahedralDirection(const std::array<std::uint32_t, 2>& code)
{
  const PageRange range = { -1.0, 1.0 };
  double x = valueOfCode(code[0], range, PositionSteps);
  double y = valueOfCode(code[1], range, PositionSteps);
  const double z = 1.0 - std::abs(x) - std::abs(y);
  if (z < 0.0)
  {
    const double folded = (1.0 - std::abs(y)) * (x < 0.0 ? -1.0 : 1.0);
    y = (1.0 - std::abs(x)) * (y < 0.0 ? -1.0 : 1.0);
    x = folded;
  }
  const double length = std::hypot(x, y, z);
  return { x / length, y / length, z / length };
}

//------------------------------------------------------------------------------
void appendCodes(std::string& bytes, const std::vector<std::uint32_t>& codes, std::size_t width)
{
  const std::size_t begin = bytes.size();
  bytes.resize(begin + width * codes.size());
  const std::uint32_t mask = 0xFFFFFFFFU >> (32 - 8 * width);
  const std::uint32_t sign = (mask >> 1) + 1;
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    const std::uint32_t difference = (codes[i] - before) & mask;
    before = codes[i];
    const bool isNegative = (difference & sign) != 0;
    const std::uint32_t folded = ((difference << 1) ^ (isNegative ? mask : 0U)) & mask;
    for (std::size_t b = 0; b < width; ++b)
    {
      bytes[begin + b * codes.size() + i] = static_cast<char>(folded >> (8 * b) & 255U);
    }
  }
}

//------------------------------------------------------------------------------
std::uint32_t mortonCode(const std::array<std::uint32_t, 2>& code)
{
  std::uint32_t result = 0;
  for (unsigned int bit = 0; bit < 16; ++bit)
  {
    result |= (code[0] >> bit & 1U) << (2 * bit) | (code[1] >> bit & 1U) << (2 * bit + 1);
  }
  return result;
}
}
