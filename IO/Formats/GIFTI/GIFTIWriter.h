/// Write GIFTI files: surfaces, spheres, and values at points of surfaces.

#ifndef ConformalGIFTIWriter_h
#define ConformalGIFTIWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a surface as a compressed GIFTI file, with the points, the triangles and all point arrays.
/// @param[in] structure  value of the metadata entry AnatomicalStructurePrimary, such as
///   CortexLeft. If empty, the entry is not written
/// @return the text of the file
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is no polygon
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGIFTISurface(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write a surface as a compressed GIFTI file. The file contains the points, as floats, and the
/// triangles, but no point arrays. Some programs cannot read surfaces with point arrays. The
/// argument `structure` and the result are as for makeGIFTISurface().
/// @throws std::invalid_argument as makeGIFTISurface(), or if floats cannot represent the points
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGIFTIGeometry(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write a surface, mapped to a sphere of radius 100, as a compressed GIFTI file. The file contains
/// points, as floats, and triangles. The position of each point is 100 times its tuple in the array
/// "SpherePosition", its position on the unit sphere. The argument `structure` and the result are
/// as for makeGIFTISurface().
/// @throws std::invalid_argument as makeGIFTIGeometry(). Also thrown if "SpherePosition" is
///   missing, or a position is zero or not finite
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGIFTISphere(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write a compressed GIFTI file with all point arrays of 1 component, as floats, but without
/// points and triangles. The argument `structure` and the result are as for makeGIFTISurface().
/// @throws std::invalid_argument if no array has 1 component, or a finite value exceeds the range
///   of floats
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGIFTIShape(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});
}

#endif
