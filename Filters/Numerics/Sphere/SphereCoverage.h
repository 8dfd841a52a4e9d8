/// Degree and folds of a map to the sphere.

#ifndef ConformalSphereCoverage_h
#define ConformalSphereCoverage_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <string>

namespace conformal
{
struct SphereCoverage
{
  int Degree = 0; ///< sum of the solid angles over 4 pi: 1 for a map one to one, -1 for a mirror
  Index NumberOfFolds = 0; ///< triangles clockwise seen from outside, by more than rounding
};

/// Solid angles of a triangle mesh on the unit sphere.
///
/// @param[in] positions  #N by 3 unit vectors
/// @param[in] triangles      #R by 3 ids of a closed surface
SphereCoverage measureSphereCoverage(
  const Points& positions, const Triangles& triangles, const Run& run = {});

/// The triangles of a map that covers the sphere exactly once, turned to be counter-clockwise on
/// the sphere seen from outside.
/// @param[in] map  what the message calls it: "the map to the sphere"
/// @throws std::invalid_argument if it does not cover the sphere once, or folds
Triangles turnedToCoverOnce(
  const Points& positions, const Triangles& triangles, const std::string& map, const Run& run = {});
}

#endif
