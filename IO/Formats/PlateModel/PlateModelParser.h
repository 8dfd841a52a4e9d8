/// Parser of plate models of small bodies, as the Planetary Data System has them.

#ifndef ConformalPlateModelParser_h
#define ConformalPlateModelParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a text of the number of vertices, a row for each, the number of plates, and a row for each.
/// Both numbers may stand on the first line. Rows of vertices are X Y Z, or I X Y Z with I counting
/// from 0 or 1; rows of plates A B C, or I A B C, or 3 A B C, of which 3 may stand on a line of its
/// own (.ver). Vertices are numbered from 1, or from 0 where a plate names vertex 0.
///
/// Points are Float64, in the file's unit.
SurfaceResult parsePlateModel(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of a plate model: counts, then rows as they
/// say.
bool looksLikePlateModel(std::string_view start);
}

#endif
