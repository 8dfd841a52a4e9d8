/// Parse OFF files of Geomview with all prefixes of the keyword. With prefix n, the number of
/// dimensions must be 3.

#ifndef ConformalOFFParser_h
#define ConformalOFFParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a file of [ST][C][N][4][n]OFF [BINARY]; the keyword and the number of edges may be missing.
///
/// Points are Float64 for text and Float32 for a binary file; points of 4OFF are divided by their
/// fourth coordinate. N becomes "Normals", ST becomes "TCoords" of the type of the points, C
/// becomes "RGB" or "RGBA" (UInt8). In a file without prefixes, numbers after the coordinates are
/// colors.
///
/// Colors after the ids of a face become an array of the polygons. A face without color is white. A
/// single number after the ids becomes the array "ColorIndex" (Int32), with -1 for a face without
/// such a number.
SurfaceResult parseOFF(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of an OFF file with its keyword.
bool looksLikeOFF(std::string_view start);
}

#endif
