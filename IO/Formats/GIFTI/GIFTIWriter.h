/// Write GIFTI surfaces, spheres and values at their points.

#ifndef ConformalGIFTIWriter_h
#define ConformalGIFTIWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a compressed GIFTI file with all point arrays.
/// @param[in] structure  the metadata AnatomicalStructurePrimary, such as CortexLeft; none if empty
/// @throws std::invalid_argument if a polygon has more than 3 corners, or there is none
/// @throws Aborted
std::string makeGIFTISurface(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write only the points, as floats, and the triangles: some programs accept nothing else as a
/// surface.
/// @throws std::invalid_argument as makeGIFTISurface(), or if floats cannot hold the points
/// @throws Aborted
std::string makeGIFTIGeometry(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write the triangles on the sphere of radius 100: "SpherePosition" are the points, as floats.
/// @throws std::invalid_argument as makeGIFTIGeometry(), or if there is no such array or one of its
///   positions has no direction
/// @throws Aborted
std::string makeGIFTISphere(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});

/// Write the point arrays of 1 component, as floats, without the surface.
/// @throws std::invalid_argument if there is none, or floats cannot hold the finite values of one
/// @throws Aborted
std::string makeGIFTIShape(
  const SurfaceData& surface, const std::string& structure = {}, const Run& run = {});
}

#endif
