/// Convert texts to strings of JSON.

#ifndef ConformalJSONText_h
#define ConformalJSONText_h

#include <string>
#include <string_view>

namespace conformal
{
/// Convert a text to valid UTF-8. Each byte that is not part of a valid character is replaced by
/// U+FFFD, the replacement character.
std::string validUTF8(std::string_view text);

/// Quote a text for JSON. The result is valid UTF-8 without control characters. The result contains
/// no <, > or &, so that it may be part of a script in an HTML page.
std::string jsonText(std::string_view text);
}

#endif
