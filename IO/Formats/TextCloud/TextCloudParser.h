/// Parser of points in text files: XYZ, ASC, TXT, CSV, NTS, PTS.

#ifndef ConformalTextCloudParser_h
#define ConformalTextCloudParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
struct TextCloudOptions
{
  bool DecimalComma = false;       ///< whether numbers are written 0,5
  bool SkipMalformedLines = false; ///< count lines that are no point instead of refusing the file
  FilePiece Piece;                 ///< by bytes, at line ends; a file with a count cannot be cut
};

/// Read a text with one point on a line, see findTextCloudLayout(). Points are Float64; "Normals"
/// are, too, and so is every other column but whole colors, "RGB" (UInt8). A number alone on the
/// first line is the number of points that follow (PTS); a file may have several such blocks.
SurfaceResult parseTextCloud(ByteReader& input, const TextCloudOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are points as text, without decimal commas.
bool looksLikeTextCloud(std::string_view start);
}

#endif
