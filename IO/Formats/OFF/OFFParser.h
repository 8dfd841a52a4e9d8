/// Parse OFF files of the program Geomview. The keyword OFF at the start of a file may have
/// prefixes, such as N for normals. All prefixes are supported. With the prefix n, the file states
/// its number of dimensions, which must be 3.

#ifndef ConformalOFFParser_h
#define ConformalOFFParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read an OFF file, text or binary. The file begins with the keyword [ST][C][N][4][n]OFF, where
/// brackets enclose optional prefixes. In a binary file, the word BINARY follows. Then the numbers
/// of points, faces and edges follow. A text file is also accepted without the keyword or the
/// number of edges.
///
/// Points are Float64 in a text file and Float32 in a binary file. The prefixes have these
/// meanings:
/// - 4: the first three coordinates are divided by the fourth coordinate.
/// - N: the file has normals, which become "Normals", of the type of the points.
/// - ST: the file has texture coordinates, which become "TCoords", of the type of the points.
/// - C: the file has colors, which become "RGB" or "RGBA" (UInt8).
///
/// In a text file without prefix C, three or four additional numbers of each point are read as a
/// color.
///
/// Three or four numbers after the ids of a face are a color. Colors of faces become the polygon
/// array "RGB" or "RGBA". A face without a color is white. A single number after the ids becomes
/// the polygon array "ColorIndex" (Int32). For a face without this number, the index is -1.
SurfaceResult parseOFF(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify an OFF file, by its keyword.
bool looksLikeOFF(std::string_view start);
}

#endif
