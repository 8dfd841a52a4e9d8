/// Degree and folds of a map to the sphere, by the solid angles of \cite VanOosterom1983.

#ifndef ConformalSphereCoverage_h
#define ConformalSphereCoverage_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <string>

namespace conformal
{
struct SphereCoverage
{
  int Degree = 0; ///< sum of the solid angles over 4 pi: 1 for a one-to-one map, -1 if mirrored
  Index NumberOfFolds = 0; ///< triangles clockwise seen from outside beyond rounding
};

/// Measure degree and folds of a triangle mesh on the unit sphere.
///
/// @param[in] positions  #N by 3 unit vectors
/// @param[in] triangles  #R by 3 ids of a closed surface
SphereCoverage measureSphereCoverage(
  const Points& positions, const Triangles& triangles, const Run& run = {});

/// Orient the triangles of a map counter-clockwise on the sphere seen from outside.
/// @param[in] map  name of the map for the message, such as "the map to the sphere"
/// @throws std::invalid_argument if the map does not cover the sphere exactly once or has folds
Triangles turnedToCoverOnce(
  const Points& positions, const Triangles& triangles, const std::string& map, const Run& run = {});
}

#endif
