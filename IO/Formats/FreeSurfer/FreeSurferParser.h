/// Parse FreeSurfer files: surfaces, and values at points of surfaces.

#ifndef ConformalFreeSurferParser_h
#define ConformalFreeSurferParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a surface file of triangles, or of quads in the old or the new format. Points are Float32.
/// Data after the faces (the geometry of the volume) are not read.
SurfaceResult parseFreeSurferSurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read a curv file in the old or the new format. The result is a surface without points whose only
/// point array has one Float32 for each point.
SurfaceResult parseFreeSurferCurv(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a FreeSurfer surface.
bool looksLikeFreeSurferSurface(std::string_view start);
}

#endif
