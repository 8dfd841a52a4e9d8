/// Parse plate models: triangle meshes of small bodies of the solar system, in the format of the
/// Planetary Data System.

#ifndef ConformalPlateModelParser_h
#define ConformalPlateModelParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <cstdint>
#include <string_view>

namespace conformal
{
/// Read a plate model from a text file. The text contains the number of vertices, a row for each
/// vertex, the number of plates (triangles), and a row for each plate. The numbers of vertices and
/// plates may be on the first line.
///
/// The row of a vertex is X Y Z or I X Y Z, where the index I of the row counts from 0 or 1. The
/// row of a plate is A B C, I A B C, or 3 A B C. A, B and C are the numbers of its vertices, and 3
/// is the number of vertices. The 3 may also be on a separate line before A B C, as in files with
/// the extension .ver. Vertices are numbered from 0 if a plate contains vertex 0, otherwise from 1.
///
/// Two further kinds of files are read. Rows of one kind have a tag: v X Y Z is a vertex, and
/// f A B C a plate, whose vertices are numbered from 1. All vertices precede all plates. Blank
/// lines and comments, which begin with #, are ignored. Files of the other kind are implicitly
/// connected quadrilateral models (ICQ): a number q, and 6 (q + 1)^2 vertices X Y Z without plates
/// (CubedPlates.h).
///
/// Points are Float64, in the length unit of the file.
SurfaceResult parsePlateModel(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify a plate model. One of these must be true:
/// - The bytes begin with a line of one or two counts: the number of vertices, and optionally the
///   number of plates. Three rows of vertices follow. With only one count, the rows have an index.
/// - The bytes begin with three rows v X Y Z. OBJ files may begin in this way, too.
/// - The bytes begin with a number q and three rows X Y Z, and the size of the file is about that
///   of 6 (q + 1)^2 such rows.
/// @param[in] size  size of the file [bytes]; 0: the bytes are the whole file
bool looksLikePlateModel(std::string_view start, std::uint64_t size = 0);

/// Test whether the first bytes of a file with an extension of plate models identify one. Besides
/// the cases of looksLikePlateModel(), the bytes may begin with a number and three rows X Y Z, if
/// the file is longer than this number of rows. Without the extension, such a file can also be a
/// cloud of several scans.
bool looksLikeNamedPlateModel(std::string_view start, std::uint64_t size = 0);
}

#endif
