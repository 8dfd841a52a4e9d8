/// Resample a mapped mesh at given directions. Own construction: point location on the sphere with
/// linear interpolation.

#ifndef ConformalResampling_h
#define ConformalResampling_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Interpolate values of a surface at given directions of the sphere, linearly in the triangle that
/// contains each direction.
/// @param[in] spherePositions  #V by 3 unit vectors, the sphere map of the surface; a mirrored map
///   is reversed first
/// @param[in] values           #V by 3, for example positions
/// @param[in] triangles        #F by 3
/// @param[in] directions       #N by 3 unit vectors
/// @return #N by 3
/// @throws std::invalid_argument if the map does not cover the sphere exactly once
/// @throws Aborted
Points resample(const Points& spherePositions, const Points& values, const Triangles& triangles,
  const Points& directions, const Run& run = {});
}

#endif
