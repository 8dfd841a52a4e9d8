/// Measure whether a map of a surface to the sphere is one-to-one: compute how often the map covers
/// the sphere, and count its folds (flipped triangles). Solid angles are computed by the formula of
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
  /// Degree of the map: number of times that the map covers the sphere. The degree is the sum of
  /// the signed solid angles of all triangles, divided by 4 pi. The degree of a one-to-one map is
  /// 1, or -1 if the map reverses orientation. If the sum is not a multiple of 4 pi, as for a
  /// sheet, which covers half of the sphere, the degree is 0. Holes below 1 % of the sphere are
  /// permitted.
  int Degree = 0;
  /// Sum of the signed solid angles of all triangles, divided by 4 pi; 0.5 for a sheet. A triangle
  /// in the plane of a great circle has solid angle 0
  double Times = 0.0;
  /// Number of folds: triangles that are clockwise seen from outside, and triangles in the plane
  /// of a great circle whose corners are not on less than half of it. Other triangles that could be
  /// clockwise because of rounding errors do not count
  Index NumberOfFolds = 0;
};

/// Measure degree and number of folds of a triangle mesh on the unit sphere.
///
/// @param[in] positions  #N by 3 unit vectors
/// @param[in] triangles  #R by 3 ids
SphereCoverage measureSphereCoverage(
  const Points& positions, const Triangles& triangles, const Run& run = {});

/// Measure degree and number of folds. If the map reverses orientation, reverse all triangles
/// before, so that the degree is not negative.
SphereCoverage turnToCover(const Points& positions, Triangles& triangles, const Run& run = {});

/// Return the triangles of a map to the sphere, oriented counter-clockwise on the sphere seen from
/// outside. If the map reverses orientation, all triangles are reversed.
/// @param[in] map  name of the map for error messages, such as "the map to the sphere"
/// @throws std::invalid_argument if the map does not cover the sphere exactly once or has folds
Triangles turnedToCoverOnce(
  const Points& positions, const Triangles& triangles, const std::string& map, const Run& run = {});
}

#endif
