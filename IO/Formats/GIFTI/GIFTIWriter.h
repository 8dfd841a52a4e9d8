/// Write GIFTI surfaces, spheres and values at their points.

#ifndef ConformalGIFTIWriter_h
#define ConformalGIFTIWriter_h

#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a compressed GIFTI file with all point arrays.
/// @param[in] structure  the metadata AnatomicalStructurePrimary, such as CortexLeft; none if empty
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is none
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeGIFTISurface(const SurfaceData& surface, const std::string& structure = {},
  const ParseProgress& progress = {});

/// Write only the points, as floats, and the triangles: some programs accept nothing else as a
/// surface.
/// @throws std::invalid_argument as makeGIFTISurface(), or if floats cannot hold the points
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeGIFTIGeometry(const SurfaceData& surface, const std::string& structure = {},
  const ParseProgress& progress = {});

/// Write the triangles on the sphere of radius 100: "SpherePosition" are the points, as floats.
/// @throws std::invalid_argument as makeGIFTIGeometry(), or if there is no such array or one of its
///   positions has no direction
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeGIFTISphere(const SurfaceData& surface, const std::string& structure = {},
  const ParseProgress& progress = {});

/// Write the point arrays of 1 component, as floats, without the surface.
/// @throws std::invalid_argument if there is none, or floats cannot hold the finite values of one
/// @throws ParseError with Aborted if the progress callback returns false
std::string makeGIFTIShape(const SurfaceData& surface, const std::string& structure = {},
  const ParseProgress& progress = {});
}

#endif
