/// Write OFF text files.

#ifndef ConformalOFFWriter_h
#define ConformalOFFWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a surface or a cloud as OFF text. The point arrays "Normals", "RGB" or "RGBA", and
/// "TCoords" are written, and colors and "ColorIndex" of the polygons. Other arrays are omitted.
/// @throws Aborted
std::string makeOFF(const SurfaceData& surface, const Run& run = {});
}

#endif
