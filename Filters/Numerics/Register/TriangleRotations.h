/// Compute the rotation of each triangle between two shapes with the same triangles, by polar
/// decomposition as in \cite Alexa2000.

#ifndef ConformalTriangleRotations_h
#define ConformalTriangleRotations_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Return the rotation matrix of a rotation vector. The direction of the vector is the axis. The
/// length of the vector is the angle in radians.
Eigen::Matrix3d rotationOf(const Vector3& rotationVector);

/// Compute the rotation of a triangle's deformation: the orthogonal factor in the polar
/// decomposition of the deformation gradient. The gradient is the linear map of the first
/// triangle's edges to those of the second triangle. It also maps the unit normal of the first
/// triangle to that of the second triangle.
/// @param[in] from, to   corners of the triangle before and after the deformation, one per column
/// @param[in] otherwise  return value if the triangle has zero area in `from` or `to`
Eigen::Matrix3d triangleRotation(
  const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, const Eigen::Matrix3d& otherwise);

/// Compute a rotation vector for each triangle, relative to the rotation of the whole shape. Let R
/// be triangleRotation() of the triangle, and exp() the function rotationOf(). Then R = exp(whole)
/// exp(vector).
///
/// A rotation vector is unique up to multiples of 360 degrees along its axis. These multiples are
/// chosen so that vectors are continuous between neighboring triangles. The triangle of smallest
/// rotation gets its shortest vector. Then triangle after triangle gets the vector closest to that
/// of a neighbor with a known vector. Neighbors with the most similar rotations are processed
/// first.
///
/// With this choice, parts of a shape (limbs) can rotate by more than 180 degrees. Rotations by 360
/// degrees are not supported, since their axes are undefined.
///
/// @param[in] neighbors  adjacent triangles of each triangle: the result of triangleNeighbors()
/// @param[in] from, to   #V by 3, vertices of both shapes
/// @param[in] whole      rotation vector of the whole shape
/// @throws Aborted
std::vector<Vector3> triangleRotations(const Triangles& triangles, const Triangles& neighbors,
  const Points& from, const Points& to, const Vector3& whole, const Run& run = {});
}

#endif
