/// Write OFF text files.

#ifndef ConformalOFFWriter_h
#define ConformalOFFWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a surface, or points without polygons, as OFF text. The point arrays "Normals", "RGB" or
/// "RGBA", and "TCoords" are written. If the polygons have colors, their colors are written,
/// otherwise their array "ColorIndex". Other arrays are omitted.
/// @return the text of the file
/// @throws Aborted
std::string makeOFF(const SurfaceData& surface, const Run& run = {});
}

#endif
