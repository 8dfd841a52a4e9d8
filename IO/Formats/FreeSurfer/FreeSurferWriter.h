/// Write FreeSurfer surfaces, spheres and values at their points.

#ifndef ConformalFreeSurferWriter_h
#define ConformalFreeSurferWriter_h

#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a triangle surface. Points are written as floats.
/// @throws std::invalid_argument if a polygon has more than 3 corners, or floats cannot hold the
///   points: too far apart, too close together, or too far from the origin
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeFreeSurferSurface(const SurfaceData& surface, const ParseProgress& progress = {});

/// Write the triangles on the sphere of radius 100: "SpherePosition" are the points.
/// @throws std::invalid_argument if it is missing or has no direction, or a polygon has more than 3
///   corners
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeFreeSurferSphere(const SurfaceData& surface, const ParseProgress& progress = {});

/// Write an array of 1 component as a curv file in the new format. Values are written as floats.
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const ParseProgress& progress = {});
}

#endif
