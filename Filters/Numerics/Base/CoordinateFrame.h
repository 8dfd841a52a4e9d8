/// Scale coordinates by a power of two to a size near 1, so that products stay in range. Own
/// construction: scaling by powers of two, because it does not round. Results thus have the same
/// bits in any unit of length.

#ifndef ConformalCoordinateFrame_h
#define ConformalCoordinateFrame_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Return x / unit. If the result has a coordinate beyond 2^26, it is moved to a distance of 2^26
/// in the same direction. In double precision, both points have the same closest point on a surface
/// of size 1.
Vector3 inUnits(const Vector3& x, double unit);

/// Unit of length in which coordinates are near 1. The unit is a power of two, so that conversion
/// into the frame and back does not round. If the unit is a normal number, results of the numerical
/// library have the same bits in any unit of the input.
struct CoordinateFrame
{
  double Unit = 1.0; ///< unit of length, a power of two

  /// Convert one of the points from which frameOf() computed the frame.
  Vector3 toFrame(const Vector3& x) const { return x / this->Unit; }

  /// Convert any other point, possibly far away, by inUnits().
  Vector3 toFrameFromAfar(const Vector3& x) const { return inUnits(x, this->Unit); }
};

/// Choose the frame in which the maximum absolute coordinate lies in [1, 2). Points that are not
/// finite are ignored. The unit is 1 if all other coordinates are 0.
/// @param[in] reduce  sums over the ranks; each rank passes its own part of the points
CoordinateFrame frameOf(
  const std::vector<PointView>& points, const Reduce& reduce = {}, const Run& run = {});

/// Normalize a vector of any length without overflow or underflow. The result is not finite if the
/// vector is zero or not finite.
Vector3 unitVector(const Vector3& v);

/// Normalize each row of a matrix in place, without overflow or underflow.
/// @return number of rows that have no direction because they are zero or not finite
Index normalizeRows(Points& vectors);
}

#endif
