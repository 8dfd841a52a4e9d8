/// Parse OFF files of the program Geomview. All prefixes of the keyword OFF are supported. If the
/// keyword has the prefix n, the number of dimensions must be 3.

#ifndef ConformalOFFParser_h
#define ConformalOFFParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read an OFF file, as text or as binary data. The file begins with [ST][C][N][4][n]OFF, where
/// brackets enclose optional prefixes. The word BINARY may follow. In a text file, this keyword and
/// the number of edges may be missing.
///
/// Points are Float64 in a text file and Float32 in a binary file. With prefix 4, the first three
/// coordinates are divided by the fourth coordinate. With prefix N, the file has "Normals". With
/// prefix ST, the file has "TCoords". Both arrays have the type of the points. With prefix C, the
/// file has the colors "RGB" or "RGBA" (UInt8). In a text file without prefix C, three or four
/// additional numbers of each point are read as a color.
///
/// Three or four numbers after the ids of a face are a color. Colors become an array of the
/// polygons; a face without a color is white. A single number after the ids becomes the polygon
/// array "ColorIndex" (Int32). For a face without this number, the index is -1.
SurfaceResult parseOFF(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify an OFF file, by its keyword.
bool looksLikeOFF(std::string_view start);
}

#endif
