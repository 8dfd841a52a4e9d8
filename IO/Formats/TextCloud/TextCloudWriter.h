/// Write points as text, one point in each line.

#ifndef ConformalTextCloudWriter_h
#define ConformalTextCloudWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write points as text, one point in each line. If there are arrays besides the points, the first
/// line is a comment with the names of all columns. All arrays are written, one column for each
/// component. Columns of "Normals" are named nx, ny, nz; columns of "RGB" are named r, g, b. Names
/// of other columns are derived from the name of the array. Repeated names are made unique by
/// appending "_".
/// @throws Aborted
std::string makeTextCloud(const SurfaceData& surface, const Run& run = {});
}

#endif
