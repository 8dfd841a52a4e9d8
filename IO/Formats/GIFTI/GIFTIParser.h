/// Parser of GIFTI surfaces and of values at their points.

#ifndef ConformalGIFTIParser_h
#define ConformalGIFTIParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
/// Read a surface: the array of intent POINTSET (3 floating components) gives the points, in their
/// type, that of intent TRIANGLE (3 integers) the triangles. Arrays of other intents are as in
/// parseGIFTIArrays().
SurfaceResult parseGIFTISurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read the arrays of numbers, as the point arrays of a surface without points. They are named by
/// their metadata "Name", else by their intent, as "Shape"; a second one of a name by a number
/// behind it.
SurfaceResult parseGIFTIArrays(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});
}

#endif
