/// The texts of page.html, page.css and the script; CMake compiles them in.

#ifndef ConformalPageTemplate_h
#define ConformalPageTemplate_h

#include <string_view>

namespace conformal
{
extern const std::string_view PageHTML; ///< with {{NAME}} where something is put in
extern const std::string_view PageCSS;
extern const std::string_view PageScript;
}

#endif
