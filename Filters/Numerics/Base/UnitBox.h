/// Move and scale points to a unit box (bounding box whose longest side is 1). Products of
/// coordinates in this box neither overflow nor underflow.

#ifndef ConformalUnitBox_h
#define ConformalUnitBox_h

#include "Base/CoordinateFrame.h"
#include "Base/Types.h"

namespace conformal
{
/// Transformation of points to a unit box: translation and scaling. The lower corner of the points'
/// bounding box becomes the origin. The longest side of the bounding box gets the length 1.
struct UnitBox
{
  Vector3 Lower = Vector3::Zero();
  /// Half of the longest side of the bounding box. The half is stored because the whole length
  /// could overflow.
  double Half = 1.0;

  Vector3 operator()(const Vector3& p) const { return (0.5 * p - 0.5 * this->Lower) / this->Half; }

  /// Transform a point that can be far outside of the box. Very distant points are moved closer,
  /// see inUnits() in CoordinateFrame.h.
  Vector3 fromAfar(const Vector3& p) const
  {
    return inUnits(0.5 * p - 0.5 * this->Lower, this->Half);
  }
};

/// Compute the transformation to the unit box of points, from their bounding box.
/// @throws std::invalid_argument if some points are not finite; the message contains their number
UnitBox unitBoxOf(const PointView& points);

/// Transform points to their unit box. Except for rounding, the result does not depend on the
/// position and size of the input.
/// @throws std::invalid_argument if some points are not finite; the message contains their number
Points inUnitBox(const PointView& points);
}

#endif
