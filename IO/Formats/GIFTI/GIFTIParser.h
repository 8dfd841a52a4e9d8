/// Parse GIFTI files: surfaces, and values at points of surfaces.

#ifndef ConformalGIFTIParser_h
#define ConformalGIFTIParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
/// Read a surface from a GIFTI file. Each array of the file has an intent, which states its
/// meaning. The array of intent POINTSET (3 floating-point components) defines the points and their
/// type. The array of intent TRIANGLE (3 integer components) defines the triangles. Arrays of other
/// intents become point arrays, with names as in parseGIFTIArrays().
SurfaceResult parseGIFTISurface(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Read all arrays of a GIFTI file except the points (POINTSET) and the triangles (TRIANGLE). The
/// result is a surface without points; each array becomes a point array of this surface. The name
/// of an array is the entry "Name" of its metadata. If this entry is missing, the array is named by
/// its intent, such as "Shape". Repeated names get numbers, such as "Shape2".
SurfaceResult parseGIFTIArrays(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});
}

#endif
