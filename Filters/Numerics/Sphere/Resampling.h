/// Interpolate values of a surface at given directions of its sphere map (map to the unit sphere).
/// The method is our own construction: linear interpolation in the triangle found by SphereLocator.
/// SphereLocator is used because it is exact for triangles of any size.

#ifndef ConformalResampling_h
#define ConformalResampling_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Interpolate values of a surface at given directions of its sphere map. A direction is a point of
/// the unit sphere. The interpolation is linear in the triangle of the sphere map that contains the
/// direction.
/// @param[in] spherePositions  #V by 3 unit vectors, the sphere map of the surface. If the map
///   reverses orientation, the map is first reflected at the plane x = 0. Directions are not
///   reflected.
/// @param[in] values           #V by 3 values at the vertices, for example positions
/// @param[in] triangles        #F by 3 ids
/// @param[in] directions       #N by 3 unit vectors
/// @return #N by 3 interpolated values
/// @throws std::invalid_argument if the map does not cover the sphere exactly once, or a direction
///   is far from all triangles, in a hole
/// @throws Aborted
Points resample(const Points& spherePositions, const Points& values, const Triangles& triangles,
  const Points& directions, const Run& run = {});
}

#endif
