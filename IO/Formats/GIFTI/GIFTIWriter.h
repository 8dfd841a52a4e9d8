/// Writer of GIFTI surfaces.

#ifndef ConformalGIFTIWriter_h
#define ConformalGIFTIWriter_h

#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// GIFTI, compressed, all arrays of points.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is none
/// @throws ParseError if the caller says stop
std::string makeGIFTI(const SurfaceData& surface, const ParseProgress& progress = {});
}

#endif
