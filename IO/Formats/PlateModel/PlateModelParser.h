/// Parse plate models of small bodies in the format of the Planetary Data System.

#ifndef ConformalPlateModelParser_h
#define ConformalPlateModelParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read the number of vertices, a row for each vertex, the number of plates (triangles), and a row
/// for each plate. Both numbers may be on the first line. Rows of vertices are X Y Z, or I X Y Z
/// with I counting from 0 or 1. Rows of plates are A B C, I A B C, or 3 A B C. In .ver files, the 3
/// may be on a separate line. Vertices are numbered from 1, or from 0 if a plate contains vertex 0.
///
/// Points are Float64, in the unit of the file.
SurfaceResult parsePlateModel(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a plate model: counts, followed by rows that
/// match the counts.
bool looksLikePlateModel(std::string_view start);
}

#endif
