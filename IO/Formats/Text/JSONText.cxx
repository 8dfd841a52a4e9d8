#include "Text/JSONText.h"

#include <cstddef>
#include <cstdint>

namespace conformal
{
namespace
{
// Return the number of bytes of the first character of a text. If the character is invalid, return
// 0. Invalid characters are truncated, overlong, half of a surrogate pair, or beyond U+10FFFF.
std::size_t lengthOfCharacter(std::string_view text)
{
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = at(0);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xC2 && first < 0xE0       ? 2
    : first >= 0xE0 && first < 0xF0       ? 3
    : first >= 0xF0 && first < 0xF5       ? 4
                                          : 0;
  if (length > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((at(i) & 0xC0U) != 0x80U)
    {
      return 0;
    }
  }
  const bool isBad = (first == 0xE0 && at(1) < 0xA0) || (first == 0xED && at(1) >= 0xA0) ||
    (first == 0xF0 && at(1) < 0x90) || (first == 0xF4 && at(1) >= 0x90);
  return isBad ? 0 : length;
}
}

//------------------------------------------------------------------------------
std::string validUTF8(std::string_view text)
{
  std::string result;
  result.reserve(text.size());
  while (!text.empty())
  {
    const std::size_t length = lengthOfCharacter(text);
    result += length > 0 ? text.substr(0, length) : std::string_view("\xEF\xBF\xBD");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return result;
}

//------------------------------------------------------------------------------
std::string jsonText(std::string_view text)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : validUTF8(text))
  {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
    {
      result += '\\';
      result += c;
    }
    else if (byte < 0x20 || byte == 0x7F || c == '<' || c == '>' || c == '&')
    {
      result += "\\u00";
      result += digits[byte >> 4];
      result += digits[byte & 15];
    }
    else
    {
      result += c;
    }
  }
  return result + '"';
}
}
