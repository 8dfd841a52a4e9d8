/// Scale coordinates to a magnitude near 1, so that their products neither overflow nor underflow.
/// The choice of the scale is our own construction. The scale is a power of two, because division
/// by a power of two does not round. If the input is multiplied by a power of two, the scaled
/// coordinates do not change.

#ifndef ConformalCoordinateFrame_h
#define ConformalCoordinateFrame_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Divide the point x by a unit of length. If a coordinate of x / unit exceeds 2^26 in magnitude,
/// return another point: the point at distance 2^26 from the origin in the direction of x. On a
/// surface of size about 1, x / unit and its replacement have the same closest point, up to
/// rounding.
Vector3 inUnits(const Vector3& x, double unit);

/// Unit of length in which coordinates are near 1. The unit is a power of two, so that division and
/// multiplication by the unit do not round. If the input is multiplied by a power of two, the
/// scaled coordinates do not change. Subnormal coordinates (below 2^-1022) are an exception, since
/// they have fewer digits.
struct CoordinateFrame
{
  double Unit = 1.0; ///< unit of length, a power of two

  /// Divide a point by the unit. The point must be one of those from which frameOf() computed the
  /// frame.
  Vector3 toFrame(const Vector3& x) const { return x / this->Unit; }

  /// Divide a point by the unit. The point can be far from the points from which frameOf() computed
  /// the frame, see inUnits().
  Vector3 toFrameFromAfar(const Vector3& x) const { return inUnits(x, this->Unit); }
};

/// Choose the unit so that the maximum absolute coordinate, divided by the unit, is in [1, 2).
/// Points that are not finite are ignored. If all coordinates of finite points are 0, the unit is
/// 1.
/// @param[in] reduce  communication between ranks (MPI processes); each rank passes its part of the
///   points
CoordinateFrame frameOf(
  const std::vector<PointView>& points, const Reduce& reduce = {}, const Run& run = {});

/// Normalize a vector of any length without overflow or underflow. If the vector is zero or not
/// finite, the result is not finite.
Vector3 unitVector(const Vector3& v);

/// Normalize each row of a matrix in place, without overflow or underflow.
/// @return number of rows that are zero or not finite, and therefore cannot be normalized
Index normalizeRows(Points& vectors);
}

#endif
