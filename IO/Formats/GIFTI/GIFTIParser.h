/// Parse GIFTI surfaces and values at their points.

#ifndef ConformalGIFTIParser_h
#define ConformalGIFTIParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
/// Read a surface. The array of intent POINTSET (3 floating components) defines the points and
/// their type, that of intent TRIANGLE (3 integers) the triangles. Arrays of other intents are read
/// as by parseGIFTIArrays().
SurfaceResult parseGIFTISurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read the arrays of numbers, as the point arrays of a surface without points. The name of an
/// array is its metadata "Name", else its intent, such as "Shape". Repeated names are numbered.
SurfaceResult parseGIFTIArrays(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});
}

#endif
