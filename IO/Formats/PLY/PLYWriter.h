/// Write binary PLY files.

#ifndef ConformalPLYWriter_h
#define ConformalPLYWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write binary little-endian PLY with all arrays of points and polygons. 8-byte integers become
/// doubles, a blank in a name becomes an underscore.
/// @throws Aborted
std::string makePLY(const SurfaceData& surface, const Run& run = {});
}

#endif
