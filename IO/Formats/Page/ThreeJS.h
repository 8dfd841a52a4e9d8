/// Find and read three.js, the JavaScript library that draws the surface in a web page.

#ifndef ConformalThreeJS_h
#define ConformalThreeJS_h

#include <string>

namespace conformal
{
/// Return the path of three.js in Debian's package libjs-three. If the package is not installed,
/// return the first of the paths that were searched.
std::string findThreeJS();

/// Read a build of three.js as a classic script or a CommonJS module, such as three.js,
/// three.min.js or three.cjs.
/// @param[in] fileName  path of the build; if empty, the path of findThreeJS()
/// @throws std::invalid_argument if the file cannot be read, or is neither a classic script nor a
///   CommonJS module of three.js. The message contains the name of the package to install
std::string readThreeJS(const std::string& fileName);
}

#endif
