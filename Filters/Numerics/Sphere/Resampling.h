/// Resamples a mapped mesh at given directions.

#ifndef ConformalResampling_h
#define ConformalResampling_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// The points of a surface that lie at given directions of the sphere, by linear interpolation in
/// the triangle that holds each direction.
/// @param[in] spherePositions  #V by 3 unit vectors, the surface's map to the sphere; a map that
///                             mirrors the surface is turned round first
/// @param[in] values           #V by 3, for example positions
/// @param[in] triangles            #F by 3
/// @param[in] directions       #N by 3 unit vectors
/// @return #N by 3
/// @throws std::invalid_argument if the map does not cover the sphere exactly once
/// @throws Aborted
Points resample(const Points& spherePositions, const Points& values, const Triangles& triangles,
  const Points& directions, const Run& run = {});
}

#endif
