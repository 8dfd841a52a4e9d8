/// Make and move shapes for tests. The shapes are functions of a direction.

#ifndef ConformalTestShapes_h
#define ConformalTestShapes_h

#include "Base/Types.h"

#include <Eigen/Geometry>

namespace shapes
{
/// Return the position place(n) for each direction n.
template <typename Place>
conformal::Points over(const conformal::Points& directions, Place place)
{
  conformal::Points points(directions.rows(), 3);
  for (conformal::Index i = 0; i < points.rows(); ++i)
  {
    const conformal::Vector3 n = directions.row(i);
    points.row(i) = place(n);
  }
  return points;
}

/// Scale points, rotate them about the axis (1, 2, -0.5), then translate them.
/// @param[in] angle  angle of the rotation [radians]
/// @param[in] by     translation
inline conformal::Points moved(
  const conformal::Points& points, double angle, const conformal::Vector3& by, double scale = 1.0)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(angle, conformal::Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  return (scale * points * turn.transpose()).rowwise() + by.transpose();
}
}

#endif
