/// Parse GIFTI files: surfaces, and values at points of surfaces.

#ifndef ConformalGIFTIParser_h
#define ConformalGIFTIParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
/// Read a surface. The array of intent POINTSET (3 floating components) defines the points and
/// their type. The array of intent TRIANGLE (3 integers) defines the triangles. Arrays of other
/// intents are read as in parseGIFTIArrays().
SurfaceResult parseGIFTISurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read the arrays of numbers. They become the point arrays of a surface without points. The name
/// of an array is "Name" of its metadata; without it, the intent, such as "Shape". Repeated names
/// are numbered.
SurfaceResult parseGIFTIArrays(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});
}

#endif
