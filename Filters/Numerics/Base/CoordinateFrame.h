/// Scale coordinates by a power of two to a size near 1, so that products stay in range.
/// Own construction: scaling by a power of two does not round, so results keep their bits in any
/// unit.

#ifndef ConformalCoordinateFrame_h
#define ConformalCoordinateFrame_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Return x / unit. A point with a coordinate beyond 2^26 is replaced by the point at that distance
/// in the same direction. In double precision both have the same closest point.
Vector3 inUnits(const Vector3& x, double unit);

/// Unit of length for computations near 1. The unit is a power of two, so that conversion into the
/// frame and back does not round. Results of the core thus have the same bits in any unit, as long
/// as the unit is a normal number.
struct CoordinateFrame
{
  double Unit = 1.0; ///< a power of two

  /// Convert a point that the frame was made for.
  Vector3 toFrame(const Vector3& x) const { return x / this->Unit; }

  /// Convert any other point, by inUnits().
  Vector3 toFrameFromAfar(const Vector3& x) const { return inUnits(x, this->Unit); }
};

/// Choose the frame in which the maximum absolute coordinate lies in [1, 2). Points that are not
/// finite are ignored. The unit is 1 if all other coordinates are 0.
/// @param[in] reduce  sums over the ranks that hold the other parts of the points
CoordinateFrame frameOf(
  const std::vector<PointView>& points, const Reduce& reduce = {}, const Run& run = {});

/// Normalize a vector of any nonzero length without overflow or underflow. The result is not finite
/// for the zero vector and for vectors that are not finite.
Vector3 unitVector(const Vector3& v);

/// Normalize each row of a matrix in place, without overflow or underflow.
/// @return the number of rows without a direction
Index normalizeRows(Points& vectors);
}

#endif
