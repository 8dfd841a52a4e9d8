/// Strings as JSON has them.

#ifndef ConformalJSONText_h
#define ConformalJSONText_h

#include <string>
#include <string_view>

namespace conformal
{
/// UTF-8 with U+FFFD in place of each byte that belongs to no valid character.
std::string validUTF8(std::string_view text);

/// A text in quotes, as JSON has it: valid UTF-8 without control characters, and without <, > and
/// &, so that it may stand in a script of an HTML page.
std::string jsonText(std::string_view text);
}

#endif
