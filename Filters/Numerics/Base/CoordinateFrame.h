/// Scales coordinates by a power of two to a size near 1, so that products stay in range.

#ifndef ConformalCoordinateFrame_h
#define ConformalCoordinateFrame_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// x / unit, but no coordinate is larger than 2^26: a point that is farther away is taken for one
/// in the same direction, since in double precision the same is closest to it.
Vector3 inUnits(const Vector3& x, double unit);

/// The unit is a power of two, so that nothing is rounded on the way into the frame and back: what
/// the core makes of coordinates has the same bits in any unit, as long as it is a normal number.
struct CoordinateFrame
{
  double Unit = 1.0; ///< a power of two

  /// Coordinates of a point that the frame was made for.
  Vector3 toFrame(const Vector3& x) const { return x / this->Unit; }

  /// Coordinates of any other point, by inUnits().
  Vector3 toFrameFromAfar(const Vector3& x) const { return inUnits(x, this->Unit); }
};

/// The frame in which the largest coordinate lies in [1, 2). Points that are not finite do not
/// count; without any other coordinate than 0 the unit is 1.
/// @param[in] reduce  adds up over the processes that hold other parts of the points
CoordinateFrame frameOf(
  const std::vector<PointView>& points, const Reduce& reduce = {}, const Run& run = {});

/// A vector of any length but 0 as a unit vector; not finite where that has no meaning.
Vector3 unitVector(const Vector3& v);

/// The same for each row.
/// @return how many have no direction
Index normalizeRows(Points& vectors);
}

#endif
