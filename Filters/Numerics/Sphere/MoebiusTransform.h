/// Compute Moebius transforms, the conformal maps of the sphere to itself, \cite Baden2018.

#ifndef ConformalMoebiusTransform_h
#define ConformalMoebiusTransform_h

#include "Base/Types.h"

namespace conformal
{
/// Map of the unit ball to itself that is conformal and preserves orientation. The map first moves
/// the point Center of the ball to the origin, without rotation. Then the map rotates the ball.
struct MoebiusTransform
{
  /// Point of the ball that is moved to the origin; its length is below 1
  Vector3 Center = Vector3::Zero();
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();

  /// Transform a point of the sphere.
  /// @param[in] x  unit vector to transform
  /// @return transformed unit vector
  Vector3 operator()(const Vector3& x) const;
  void applyTo(Points& spherePositions) const;
};

/// Return the point if it is in the interior of the unit ball. Otherwise, return a point in the
/// interior, in the same direction. A computed point can be outside because of rounding, or after a
/// large step of an iterative method.
Vector3 insideBall(const Vector3& x);

/// Compute the member Center of the composition of two transforms without rotation. The first
/// transform has the Center `center`, the second has the Center `step`. The result is the point
/// that the first transform moves to `step`.
Vector3 combinedCenter(const Vector3& center, const Vector3& step);

/// Find the rotation that minimizes the weighted mean square distance of the rotated directions
/// `from` to the directions `to`, \cite Kabsch1976.
/// @param[in] from, to  #P by 3 directions
/// @param[in] weights   #P weights of the pairs, >= 0
Eigen::Matrix3d closestRotation(
  const Points& from, const Points& to, const Eigen::VectorXd& weights);

/// Find the transform without rotation that moves the weighted mean of the positions to the center
/// of the sphere. If one position has half of the total weight or more, there may be no such
/// transform, or several. In this case, the result is the best transform that was found: its mean
/// is closest to the center.
/// @param[in] spherePositions  #P by 3 unit vectors
/// @param[in] weights          #P weights, >= 0, not all zero
MoebiusTransform centeringTransform(const Points& spherePositions, const Eigen::VectorXd& weights);
}

#endif
