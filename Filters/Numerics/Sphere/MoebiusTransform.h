/// Moebius transforms: the conformal maps of the sphere to itself, \cite Baden2018.

#ifndef ConformalMoebiusTransform_h
#define ConformalMoebiusTransform_h

#include "Base/Types.h"

namespace conformal
{
/// Map of the unit ball to itself that is conformal on the sphere and preserves orientation. It
/// first moves one point of the ball to the center, without rotation. Then it rotates the ball.
struct MoebiusTransform
{
  Vector3 Center = Vector3::Zero(); ///< point that is moved to 0; its length is below 1
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();

  /// Transform a point of the sphere.
  /// @param[in] x  unit vector to transform
  /// @return transformed unit vector
  Vector3 operator()(const Vector3& x) const;
  void applyTo(Points& spherePositions) const;
};

/// Move a point into the interior of the unit ball, if rounding or too long a step has put it
/// outside.
Vector3 insideBall(const Vector3& x);

/// Compute the Center of two successive transforms without rotation, with the centers `center` and
/// `step`. It is the point that the first transform moves to `step`.
Vector3 combinedCenter(const Vector3& center, const Vector3& step);

/// Find the rotation that moves the directions `from` as close as possible to the directions `to`,
/// \cite Kabsch1976. It minimizes the weighted mean square distance of the pairs.
/// @param[in] from, to  #P by 3 directions
/// @param[in] weights   #P weights of the pairs, >= 0
Eigen::Matrix3d closestRotation(
  const Points& from, const Points& to, const Eigen::VectorXd& weights);

/// Find the transform without rotation that moves the weighted mean of the positions to the center
/// of the sphere. If one point has half of the total weight or more, this transform may not exist
/// or not be unique. The result is then the best transform found.
/// @param[in] spherePositions  #P by 3 unit vectors
/// @param[in] weights          #P weights, >= 0, not all zero
MoebiusTransform centeringTransform(const Points& spherePositions, const Eigen::VectorXd& weights);
}

#endif
