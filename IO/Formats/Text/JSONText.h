/// Strings of JSON.

#ifndef ConformalJSONText_h
#define ConformalJSONText_h

#include <string>
#include <string_view>

namespace conformal
{
/// Return valid UTF-8, with U+FFFD in place of each byte outside of a valid character.
std::string validUTF8(std::string_view text);

/// Quote a text for JSON: valid UTF-8 without control characters. It has no <, > or &, so that it
/// may be in a script of an HTML page.
std::string jsonText(std::string_view text);
}

#endif
