/// Parse FreeSurfer surfaces and values at their points.

#ifndef ConformalFreeSurferParser_h
#define ConformalFreeSurferParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a surface of triangles, or of quads in either format. Points are Float32. Data after the
/// faces (the geometry of the volume) are not read.
SurfaceResult parseFreeSurferSurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read a curv file in either format: one Float32 for each point, as the only point array of a
/// surface without points.
SurfaceResult parseFreeSurferCurv(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a surface.
bool looksLikeFreeSurferSurface(std::string_view start);
}

#endif
