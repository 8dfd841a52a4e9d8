/// Write points as text, one point in each line.

#ifndef ConformalTextCloudWriter_h
#define ConformalTextCloudWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write points as text, one point in each line. All point arrays are written, with one column for
/// each component. If there are point arrays, the first line is a comment with the names of all
/// columns. Columns of "Normals" are named nx, ny, nz, and columns of "RGB" are named r, g, b. The
/// names of other columns are derived from the name of the array. If a name is repeated, "_" is
/// appended until the name is unique.
/// @return the text of the file
/// @throws Aborted if the progress callback of `run` returns false
std::string makeTextCloud(const SurfaceData& surface, const Run& run = {});
}

#endif
