/// Measure degree and folds of a sphere map. Degrees are computed by solid angles,
/// \cite VanOosterom1983.

#ifndef ConformalSphereCoverage_h
#define ConformalSphereCoverage_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <string>

namespace conformal
{
struct SphereCoverage
{
  /// Sum of the signed solid angles, divided by 4 pi; 1 for a one-to-one map, -1 if it is mirrored
  int Degree = 0;
  /// Number of triangles that are clockwise seen from outside, by more than rounding
  Index NumberOfFolds = 0;
};

/// Measure degree and folds of a triangle mesh on the unit sphere.
///
/// @param[in] positions  #N by 3 unit vectors
/// @param[in] triangles  #R by 3 ids of a closed surface
SphereCoverage measureSphereCoverage(
  const Points& positions, const Triangles& triangles, const Run& run = {});

/// Return the triangles of a sphere map, counter-clockwise on the sphere seen from outside. The
/// triangles of a mirrored map are reversed.
/// @param[in] map  name of the map for error messages, such as "the map to the sphere"
/// @throws std::invalid_argument if the map does not cover the sphere exactly once or has folds
Triangles turnedToCoverOnce(
  const Points& positions, const Triangles& triangles, const std::string& map, const Run& run = {});
}

#endif
