/// Parser of FreeSurfer surfaces and of values at their points.

#ifndef ConformalFreeSurferParser_h
#define ConformalFreeSurferParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a surface: triangles, or quads of either kind. Points are Float32. What follows the faces
/// (the volume the surface was made from) is not read.
SurfaceResult parseFreeSurferSurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read a curv file of either kind: one Float32 for each point, as the one point array of a surface
/// without points.
SurfaceResult parseFreeSurferCurv(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of a surface.
bool looksLikeFreeSurferSurface(std::string_view start);
}

#endif
