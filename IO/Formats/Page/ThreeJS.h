/// The library that draws a page: three.js, as a package of the system has it.

#ifndef ConformalThreeJS_h
#define ConformalThreeJS_h

#include <string>

namespace conformal
{
/// Where Debian's package libjs-three has it; the first of its places if it is not installed.
std::string findThreeJS();

/// The text of a classic or CommonJS build of three.js, such as three.js, three.min.js and
/// three.cjs.
/// @param[in] fileName  where it is; findThreeJS() if empty
/// @throws std::invalid_argument that says what to install, if it cannot be read or is no such
/// build
std::string readThreeJS(const std::string& fileName);
}

#endif
