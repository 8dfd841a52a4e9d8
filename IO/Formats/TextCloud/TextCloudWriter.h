/// Writer of points as text, one point a line.

#ifndef ConformalTextCloudWriter_h
#define ConformalTextCloudWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Points as text with names of the columns in a remark, if there are more than x, y and z. All
/// arrays; those of several components other than "Normals" and "RGB" become several columns. A
/// name that another column has gets "_" behind it, as often as it takes.
/// @throws Aborted
std::string makeTextCloud(const SurfaceData& surface, const Run& run = {});
}

#endif
