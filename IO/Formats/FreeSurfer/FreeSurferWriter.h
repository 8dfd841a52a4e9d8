/// Write FreeSurfer files: surfaces, spheres, and values at points of surfaces.

#ifndef ConformalFreeSurferWriter_h
#define ConformalFreeSurferWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a triangle surface. Points are written as floats.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or floats cannot represent
///   the points: too far apart, too close together, or too far from the origin
/// @throws Aborted
std::string makeFreeSurferSurface(const SurfaceData& surface, const Run& run = {});

/// Write the triangles as a sphere file of radius 100. Its points are those of the array
/// "SpherePosition".
/// @throws std::invalid_argument if "SpherePosition" is missing or a position has no direction, or
///   a polygon has more than 3 corners
/// @throws Aborted
std::string makeFreeSurferSphere(const SurfaceData& surface, const Run& run = {});

/// Write an array of 1 component as a curv file in the new format. Values are written as floats.
/// @throws Aborted
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const Run& run = {});
}

#endif
