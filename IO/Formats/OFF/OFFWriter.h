/// Writer of OFF text files.

#ifndef ConformalOFFWriter_h
#define ConformalOFFWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// OFF as text: "Normals", "RGB" or "RGBA", "TCoords" of the points, colors and "ColorIndex" of
/// the polygons. Other arrays are left out.
/// @throws Aborted
std::string makeOFF(const SurfaceData& surface, const Run& run = {});
}

#endif
