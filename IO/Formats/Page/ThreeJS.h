/// Find and read three.js, the JavaScript library that draws a page, as installed by a system
/// package.

#ifndef ConformalThreeJS_h
#define ConformalThreeJS_h

#include <string>

namespace conformal
{
/// Return the path of three.js in Debian's package libjs-three. If the package is not installed,
/// return the first path where the file could be.
std::string findThreeJS();

/// Read a classic or CommonJS build of three.js, such as three.js, three.min.js or three.cjs.
/// @param[in] fileName  path of the build; findThreeJS() if empty
/// @throws std::invalid_argument if the file cannot be read or is not such a build; the message
///   names the package to install
std::string readThreeJS(const std::string& fileName);
}

#endif
