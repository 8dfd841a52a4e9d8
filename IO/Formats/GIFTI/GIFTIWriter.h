/// Write GIFTI files: surfaces, spheres, and values at points of surfaces.

#ifndef ConformalGIFTIWriter_h
#define ConformalGIFTIWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a compressed GIFTI file with the points, the triangles and all point arrays.
/// @param[in] structure  value of the metadata AnatomicalStructurePrimary, such as CortexLeft; if
///   empty, there is no such metadata
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is no polygon
/// @throws Aborted
std::string makeGIFTISurface(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write only the points, as floats, and the triangles. Some programs accept only such files as
/// surfaces.
/// @throws std::invalid_argument as makeGIFTISurface(), or if floats cannot represent the points
/// @throws Aborted
std::string makeGIFTIGeometry(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write the triangles as a sphere of radius 100. Its points are those of the array
/// "SpherePosition", as floats.
/// @throws std::invalid_argument as makeGIFTIGeometry(), or if there is no such array or one of its
///   positions has no direction
/// @throws Aborted
std::string makeGIFTISphere(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write the point arrays of 1 component, as floats, without the surface.
/// @throws std::invalid_argument if there is no such array, or floats cannot represent its finite
///   values
/// @throws Aborted
std::string makeGIFTIShape(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});
}

#endif
