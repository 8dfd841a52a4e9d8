/// Conformal maps of the sphere to itself, \cite Baden2018.

#ifndef ConformalMoebiusTransform_h
#define ConformalMoebiusTransform_h

#include "Base/Types.h"

namespace conformal
{
/// Map of the unit ball to itself that is conformal on the sphere and preserves orientation. A
/// point of the ball is moved to the center without rotation, then the ball is rotated.
struct MoebiusTransform
{
  Vector3 Center = Vector3::Zero(); ///< point that is moved to 0, of length below 1
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();

  /// Transform a point of the sphere.
  /// @param[in] x  unit vector
  /// @return unit vector
  Vector3 operator()(const Vector3& x) const;
  void applyTo(Points& spherePositions) const;
};

/// Clamp a point to the interior of the ball, after rounding or an overlong step.
Vector3 insideBall(const Vector3& x);

/// Compute the center of two successive transforms: the point moved to `step` by the transform that
/// moves `center` to 0.
Vector3 combinedCenter(const Vector3& center, const Vector3& step);

/// Find the rotation that minimizes the weighted mean square distance between rotated and target
/// directions \cite Kabsch1976.
/// @param[in] from, to  #P by 3
/// @param[in] weights   #P, >= 0
Eigen::Matrix3d closestRotation(
  const Points& from, const Points& to, const Eigen::VectorXd& weights);

/// Find the transform without rotation that moves the weighted mean of the positions to the center
/// of the sphere. It is unique unless one point has half of the total weight or more. Otherwise the
/// best transform found is returned.
/// @param[in] spherePositions  #P by 3 unit vectors
/// @param[in] weights          #P, >= 0, not all zero
MoebiusTransform centeringTransform(const Points& spherePositions, const Eigen::VectorXd& weights);
}

#endif
