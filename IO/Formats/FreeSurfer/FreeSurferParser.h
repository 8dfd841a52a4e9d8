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
/// Read a FreeSurfer surface file of triangles or quadrilaterals. In old files of quadrilaterals,
/// each coordinate is stored as a 16-bit integer, which is 100 times the coordinate. Points are
/// Float32. Data after the faces, such as the geometry of the scanned volume, are not read.
SurfaceResult parseFreeSurferSurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read a FreeSurfer curv file, which contains values at points. In old files, each value is stored
/// as a 16-bit integer, which is 100 times the value. In new files, the values are floats. The
/// result is a surface without points. Its only point array, "Curvature", has one Float32 for each
/// point.
SurfaceResult parseFreeSurferCurv(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify a FreeSurfer surface.
bool looksLikeFreeSurferSurface(std::string_view start);
}

#endif
