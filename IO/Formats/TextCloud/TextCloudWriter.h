/// Write points as text, one point in each line.

#ifndef ConformalTextCloudWriter_h
#define ConformalTextCloudWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write points as text, with names of the columns in a comment if there are columns beside x, y
/// and z. All arrays are written. Arrays of several components other than "Normals" and "RGB"
/// become several columns. Repeated names are made unique by appending "_".
/// @throws Aborted
std::string makeTextCloud(const SurfaceData& surface, const Run& run = {});
}

#endif
