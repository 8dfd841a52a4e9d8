/// Parser of OFF files of Geomview, with all prefixes but dimensions other than three.

#ifndef ConformalOFFParser_h
#define ConformalOFFParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a file of [ST][C][N][4][n]OFF [BINARY]; the keyword may be missing, and so may the number
/// of edges.
///
/// Points are Float64 of a text and Float32 of a binary file; those of 4OFF are divided by their
/// fourth coordinate. N gives "Normals", ST "TCoords" of the points' type, C "RGB" or "RGBA"
/// (UInt8). Numbers behind the coordinates of a plain OFF's lines are colors. Colors behind a
/// face's ids are an array of the polygons, white where there are none; a single number there is
/// "ColorIndex" (Int32), -1 where there is none.
SurfaceResult parseOFF(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of an OFF file with its keyword.
bool looksLikeOFF(std::string_view start);
}

#endif
