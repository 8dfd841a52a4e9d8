/// Write FreeSurfer surfaces, spheres and values at their points.

#ifndef ConformalFreeSurferWriter_h
#define ConformalFreeSurferWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a triangle surface. Points are written as floats.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or floats cannot hold the
///   points: too far apart, too close together, or too far from the origin
/// @throws Aborted
std::string makeFreeSurferSurface(const SurfaceData& surface, const Run& run = {});

/// Write the triangles on the sphere of radius 100: "SpherePosition" are the points.
/// @throws std::invalid_argument if it is missing or has no direction, or a polygon has more than 3
///   corners
/// @throws Aborted
std::string makeFreeSurferSphere(const SurfaceData& surface, const Run& run = {});

/// Write an array of 1 component as a curv file in the new format. Values are written as floats.
/// @throws Aborted
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const Run& run = {});
}

#endif
