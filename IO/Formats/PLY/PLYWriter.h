/// Write binary PLY files.

#ifndef ConformalPLYWriter_h
#define ConformalPLYWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a binary little-endian PLY file with all arrays of points and polygons. Integers of 8
/// bytes become doubles. A blank in a name becomes an underscore.
/// @throws Aborted
std::string makePLY(const SurfaceData& surface, const Run& run = {});
}

#endif
