/// Find and read three.js, the JavaScript library for the 3-D graphics of the pages that
/// makeSurfacePage() writes.

#ifndef ConformalThreeJS_h
#define ConformalThreeJS_h

#include <string>
#include <string_view>

namespace conformal
{
/// Return the text of three.js that was compiled in. It is empty except in wheels.
std::string_view includedThreeJS();

/// Return the path of three.js in Debian's package libjs-three. If the package is not installed,
/// the result is the first searched path, at which there is no file.
std::string findThreeJS();

/// Read a file of three.js. The file must be a classic script or a CommonJS module, such as
/// three.js, three.min.js or three.cjs.
/// @param[in] fileName  path of the file. If empty, the result is includedThreeJS(); if that is
///   empty too, the path is that of findThreeJS()
/// @throws std::invalid_argument if the file cannot be read, or is of another kind. The message
///   contains the name of the package to install
std::string readThreeJS(const std::string& fileName);
}

#endif
