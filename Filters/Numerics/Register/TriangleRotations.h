/// How the triangles of one shape turn to become those of another.
/// Polar decomposition as in \cite Alexa2000.

#ifndef ConformalTriangleRotations_h
#define ConformalTriangleRotations_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// The rotation about an axis by its length in radians.
Eigen::Matrix3d rotationOf(const Vector3& rotationVector);

/// The rotation of a triangle's deformation: the orthogonal factor of the polar decomposition of
/// its gradient, which takes the normal to the normal.
/// @param[in] from, to  corners by columns
/// @return the other rotation where a triangle has no area
Eigen::Matrix3d triangleRotation(
  const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, const Eigen::Matrix3d& otherwise);

/// For each triangle the vector of the rotation that is left of triangleRotation() after the turn
/// of the whole shape: R = exp(whole) exp(vector).
///
/// A rotation has many vectors, by full turns. The triangle that turns least gets its shortest one,
/// and from there each triangle the one closest to that of a neighbor, those that turn most alike
/// first: so a limb may be turned by more than half a turn. Not by a whole one: there rotations
/// have no axis to be followed.
///
/// @param[in] neighbors  triangleNeighbors of the triangles
/// @param[in] from, to   #V by 3
/// @throws Aborted
std::vector<Vector3> triangleRotations(const Triangles& triangles, const Triangles& neighbors,
  const Points& from, const Points& to, const Vector3& whole, const Run& run = {});
}

#endif
