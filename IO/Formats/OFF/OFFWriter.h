/// Write OFF text files.

#ifndef ConformalOFFWriter_h
#define ConformalOFFWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a surface, or points without polygons, as OFF text. The point arrays "Normals", "RGB" or
/// "RGBA", and "TCoords" are written. Colors of the polygons are also written. If the polygons have
/// no colors, their array "ColorIndex" is written. Other arrays are omitted.
/// @return the text of the file
/// @throws Aborted if the progress callback of `run` returns false
std::string makeOFF(const SurfaceData& surface, const Run& run = {});
}

#endif
