/// Conformal maps of the sphere to itself.

#ifndef ConformalMoebiusTransform_h
#define ConformalMoebiusTransform_h

#include "Base/Types.h"

namespace conformal
{
/// A map of the unit ball to itself that is conformal on the sphere and keeps orientation: a point
/// of the ball is moved to the ball's center without turning, then all is rotated.
struct MoebiusTransform
{
  Vector3 Center = Vector3::Zero(); ///< the point that is moved to 0, of length below one
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity();

  /// @param[in] x  of unit length; so is the result
  Vector3 operator()(const Vector3& x) const;
  void applyTo(Points& spherePositions) const;
};

/// A point of the ball, where rounding or too long a step has brought it out.
Vector3 insideBall(const Vector3& x);

/// The center of two transforms in a row: the point that goes to `step` after `center` went to 0.
Vector3 combinedCenter(const Vector3& center, const Vector3& step);

/// The rotation that brings directions closest to others, in the sense of weighted least squares
/// \cite Kabsch1976.
/// @param[in] from, to  #P by 3
/// @param[in] weights   #P, not negative
Eigen::Matrix3d closestRotation(
  const Points& from, const Points& to, const Eigen::VectorXd& weights);

/// The transform without rotation after which the weighted mean of the positions is the sphere's
/// center. It is unique where no point has half of all the weight; otherwise the best that was
/// found is returned.
/// @param[in] spherePositions  #P by 3 unit vectors
/// @param[in] weights          #P, not negative, not all zero
MoebiusTransform centeringTransform(const Points& spherePositions, const Eigen::VectorXd& weights);
}

#endif
