/// Convert numbers to text and back, independently of the locale.

#ifndef ConformalNumberText_h
#define ConformalNumberText_h

#include <cfloat>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace conformal
{
inline bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Test whether a text starts with "#", the beginning of a comment that extends to the end of the
/// line.
inline bool isRemark(std::string_view text)
{
  return !text.empty() && text[0] == '#';
}

/// Test whether a number outside of the range of the type T is too close to 0 for T. If the result
/// is true, readNumber() reads the number as 0. If the result is false, the magnitude of the number
/// is too large for T. readNumber() then rejects the number.
/// @pre the text is a number outside of the range of T
template <typename T>
bool isUnderflow(std::string_view text)
{
  return std::is_floating_point<T>::value &&
    (text.find("e-") < text.size() || text.find("E-") < text.size() ||
      text.substr(text.find_first_not_of("+-0"), 1) == ".");
}

/// Read a decimal number without exponent, rounded only once. The value is an integer, made of all
/// digits, divided by a power of ten. For example, 12.5 is 125 / 10. If T represents the integer
/// and the power exactly, the quotient is the nearest T (W. D. Clinger, How to read floating point
/// numbers accurately, 1990). This condition holds for nearly all numbers of a scan.
/// std::from_chars, which reads all other numbers, is three times slower.
/// @return pointer to the end of the number; null if the text is not a number, has too many digits,
///   or has an exponent
template <typename T>
const char* readShortDecimal(const char* begin, const char* end, T& value)
{
  constexpr T powers[] = { T(1e0), T(1e1), T(1e2), T(1e3), T(1e4), T(1e5), T(1e6), T(1e7), T(1e8),
    T(1e9), T(1e10) };
  constexpr int maximumPower = 10; // floats represent 10^10 = 2^10 5^10, since 5^10 < 2^24
  constexpr std::uint64_t maximum = std::uint64_t(1) << std::numeric_limits<T>::digits;
  if (FLT_EVAL_METHOD != 0)
  {
    return nullptr; // quotients would be rounded twice
  }
  const bool isNegative = begin != end && *begin == '-';
  const char* c = begin + (isNegative ? 1 : 0);
  const char* const first = c;
  std::uint64_t digits = 0;
  const auto takeDigits = [&]()
  {
    for (; c != end && *c >= '0' && *c <= '9' && digits < maximum; ++c)
    {
      digits = 10 * digits + static_cast<std::uint64_t>(*c - '0');
    }
  };
  takeDigits();
  std::ptrdiff_t numberOfDigits = c - first;
  std::ptrdiff_t power = 0;
  if (c != end && *c == '.')
  {
    const char* const fraction = ++c;
    takeDigits();
    power = c - fraction;
    numberOfDigits += power;
  }
  const bool goesOn = c != end && ((*c >= '0' && *c <= '9') || *c == 'e' || *c == 'E');
  if (numberOfDigits == 0 || goesOn || digits > maximum || power > maximumPower)
  {
    return nullptr;
  }
  const T magnitude = static_cast<T>(digits) / powers[power];
  value = isNegative ? -magnitude : magnitude;
  return c;
}

/// Read one number at the start of a text. The number must be followed by a blank, the delimiter,
/// or the end of the text.
/// @return the length of the number [bytes]; 0 if the text does not start with a number in the
///   range of T
template <typename T>
std::size_t readNumber(std::string_view text, T& value, char delimiter = ' ')
{
  const char* begin = text.data();
  const char* const last = begin + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    ++begin; // from_chars rejects a plus sign
  }
  const auto isEnd = [&](const char* c) { return c == last || isBlank(*c) || *c == delimiter; };
  if constexpr (std::is_floating_point<T>::value)
  {
    const char* const end = readShortDecimal(begin, last, value);
    if (end && isEnd(end))
    {
      return end - text.data();
    }
  }
  const auto [end, error] = std::from_chars(begin, last, value);
  const std::size_t length = end - text.data();
  if (!isEnd(end))
  {
    return 0;
  }
  if (error == std::errc::result_out_of_range && isUnderflow<T>(text.substr(0, length)))
  {
    value = T(0);
    return length;
  }
  return error == std::errc() ? length : 0;
}

/// Append the shortest text that readNumber() converts to the same number.
template <typename T>
void appendNumber(std::string& text, T value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, result.ptr);
}
}

#endif
