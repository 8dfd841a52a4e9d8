/// Scales coordinates to a unit box, so that products neither overflow nor underflow.

#ifndef ConformalUnitBox_h
#define ConformalUnitBox_h

#include "Base/CoordinateFrame.h"
#include "Base/Types.h"

namespace conformal
{
/// Moves and scales a bounding box so that its longest side is [0, 1].
struct UnitBox
{
  Vector3 Lower = Vector3::Zero();
  double Half = 1.0; ///< of the longest side; halves, since a difference may overflow

  Vector3 operator()(const Vector3& p) const { return (0.5 * p - 0.5 * this->Lower) / this->Half; }

  /// Of a point that may lie outside, by inUnits().
  Vector3 fromAfar(const Vector3& p) const
  {
    return inUnits(0.5 * p - 0.5 * this->Lower, this->Half);
  }
};

/// @throws std::invalid_argument with their number, if points are not finite
UnitBox unitBoxOf(const PointView& points);

/// Points in their unit box. For measures that do not depend on place and size.
/// @throws std::invalid_argument with their number, if points are not finite
Points inUnitBox(const PointView& points);
}

#endif
