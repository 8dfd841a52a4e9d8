/// Compute rotations between the triangles of two shapes, by polar decomposition as in
/// \cite Alexa2000.

#ifndef ConformalTriangleRotations_h
#define ConformalTriangleRotations_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Return the rotation about the axis of a vector. The angle is the vector's length in radians.
Eigen::Matrix3d rotationOf(const Vector3& rotationVector);

/// Compute the rotation of a triangle's deformation: the orthogonal factor of the polar
/// decomposition of its gradient. The gradient maps the normal to the normal.
/// @param[in] from, to   corners of the triangle, one in each column
/// @param[in] otherwise  return value if a triangle has zero area
Eigen::Matrix3d triangleRotation(
  const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, const Eigen::Matrix3d& otherwise);

/// Compute the rotation vector of each triangle relative to the rotation of the whole shape: R =
/// exp(whole) exp(vector), where R is triangleRotation().
///
/// Rotation vectors are unique up to multiples of 360 degrees. The triangle of smallest rotation
/// gets its shortest vector. Beginning there, each triangle gets the vector closest to that of a
/// neighbor; neighbors with the most similar rotations are processed first. Limbs may thus rotate
/// by more than 180 degrees. A rotation by 360 degrees is not supported, since its axis is
/// undefined.
///
/// @param[in] neighbors  triangleNeighbors() of the triangles
/// @param[in] from, to   #V by 3
/// @throws Aborted
std::vector<Vector3> triangleRotations(const Triangles& triangles, const Triangles& neighbors,
  const Points& from, const Points& to, const Vector3& whole, const Run& run = {});
}

#endif
