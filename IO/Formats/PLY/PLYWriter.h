/// Write binary PLY files.

#ifndef ConformalPLYWriter_h
#define ConformalPLYWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a surface as a binary little-endian PLY file, with all arrays of its points and polygons.
/// Integers of 8 bytes become doubles, because PLY has no integers of this size. Blanks and control
/// characters in names become underscores.
/// @return the bytes of the file
/// @throws Aborted if the progress callback of `run` returns false
std::string makePLY(const SurfaceData& surface, const Run& run = {});
}

#endif
