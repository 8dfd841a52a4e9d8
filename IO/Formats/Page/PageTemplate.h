/// Define the texts of page.html, page.css and the script. CMake compiles these files into the
/// library.

#ifndef ConformalPageTemplate_h
#define ConformalPageTemplate_h

#include <string_view>

namespace conformal
{
extern const std::string_view PageHTML; ///< text of page.html; text replaces each {{NAME}}
extern const std::string_view PageCSS;
extern const std::string_view PageScript;
}

#endif
