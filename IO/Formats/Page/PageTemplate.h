/// Texts of page.html, page.css and the script, compiled in by CMake.

#ifndef ConformalPageTemplate_h
#define ConformalPageTemplate_h

#include <string_view>

namespace conformal
{
extern const std::string_view PageHTML; ///< with {{NAME}} at insertions
extern const std::string_view PageCSS;
extern const std::string_view PageScript;
}

#endif
