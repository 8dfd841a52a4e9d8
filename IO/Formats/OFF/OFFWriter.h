/// Write OFF text files.

#ifndef ConformalOFFWriter_h
#define ConformalOFFWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write OFF as text: "Normals", "RGB" or "RGBA", and "TCoords" of the points, colors and
/// "ColorIndex" of the polygons. Other arrays are omitted.
/// @throws Aborted
std::string makeOFF(const SurfaceData& surface, const Run& run = {});
}

#endif
