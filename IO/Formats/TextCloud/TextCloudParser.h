/// Parse text files of points: formats XYZ, ASC, TXT, CSV, NTS and PTS.

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
  /// Whether to skip and count malformed lines. If false, a malformed line is an error
  bool SkipMalformedLines = false;
  /// Part of the file to read. Parts have equal numbers of bytes, rounded to whole lines. If a file
  /// states its number of points, all points belong to the first part
  FilePiece Piece;
};

/// Read a text with one point in each line. findTextCloudLayout() determines the meaning of the
/// columns. Colors become "RGB" (UInt8) if they are integers in [0, 255]. Points, "Normals" and all
/// other columns are Float64.
///
/// If the first line of numbers contains only one number, this is the number of points that follow
/// (format PTS). The file may then have several blocks of points, each after its number of points.
SurfaceResult parseTextCloud(ByteReader& input, const TextCloudOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are points as text. Numbers with decimal commas are not
/// recognized.
bool looksLikeTextCloud(std::string_view start);
}

#endif
