/// Parse text files of points: XYZ, ASC, TXT, CSV, NTS, PTS.

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
  bool DecimalComma = false; ///< whether numbers use a decimal comma, as in 0,5
  /// Whether to count lines that are not points, instead of rejecting the file
  bool SkipMalformedLines = false;
  /// Part of the file to read. Parts have equal numbers of bytes, rounded to line ends. A file with
  /// a count cannot be divided
  FilePiece Piece;
};

/// Read a text with one point in each line. findTextCloudLayout() defines the meaning of the
/// columns. Points, "Normals" and all other columns are Float64, except integer colors, which
/// become "RGB" (UInt8). A single number on the first line is the number of points that follow
/// (PTS). A file may have several such blocks.
SurfaceResult parseTextCloud(ByteReader& input, const TextCloudOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are points as text, without decimal commas.
bool looksLikeTextCloud(std::string_view start);
}

#endif
