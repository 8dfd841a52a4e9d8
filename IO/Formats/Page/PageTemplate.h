/// Define the fixed parts of the web page that makeSurfacePage() writes: page.html, page.css and
/// the script. CMake compiles these files into the library.

#ifndef ConformalPageTemplate_h
#define ConformalPageTemplate_h

#include <string_view>

namespace conformal
{
/// Text of page.html. makeSurfacePage() replaces each {{NAME}} by data.
extern const std::string_view PageHTML;
extern const std::string_view PageCSS;
extern const std::string_view PageScript;
}

#endif
