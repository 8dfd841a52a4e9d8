/// Find and read three.js, the library that draws a page, as installed by a system package.

#ifndef ConformalThreeJS_h
#define ConformalThreeJS_h

#include <string>

namespace conformal
{
/// Return the file of Debian's package libjs-three; the first candidate if it is not installed.
std::string findThreeJS();

/// Read a classic or CommonJS build of three.js, such as three.js, three.min.js or three.cjs.
/// @param[in] fileName  path of the build; findThreeJS() if empty
/// @throws std::invalid_argument with the package to install, if it cannot be read or is not such a
///   build
std::string readThreeJS(const std::string& fileName);
}

#endif
