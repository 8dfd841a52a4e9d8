/// Numbers to and from text, the same in every locale.

#ifndef ConformalNumberText_h
#define ConformalNumberText_h

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace conformal
{
inline bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// A number too small for its type is zero, one too large is none.
template <typename T>
bool isUnderflow(std::string_view text)
{
  return std::is_floating_point<T>::value &&
    (text.find("e-") < text.size() || text.find("E-") < text.size() ||
      text.substr(text.find_first_not_of("+-0"), 1) == ".");
}

/// Read one number at the start of a text; what follows must be a blank or the text's end.
/// @return its length, 0 if there is none that T can hold
template <typename T>
std::size_t readNumber(std::string_view text, T& value)
{
  const char* begin = text.data();
  const char* const last = begin + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    ++begin; // from_chars knows no plus
  }
  const auto [end, error] = std::from_chars(begin, last, value);
  const std::size_t length = end - text.data();
  if (end != last && !isBlank(*end))
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

/// Append a number's shortest text that reads back as the same number.
template <typename T>
void appendNumber(std::string& text, T value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, result.ptr);
}
}

#endif
