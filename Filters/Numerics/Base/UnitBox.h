/// Scale coordinates to a unit box, so that products neither overflow nor underflow.

#ifndef ConformalUnitBox_h
#define ConformalUnitBox_h

#include "Base/CoordinateFrame.h"
#include "Base/Types.h"

namespace conformal
{
/// Transformation of points to a unit box: translation and scaling. The lower corner of their
/// bounding box becomes the origin. The length of its longest side becomes 1.
struct UnitBox
{
  Vector3 Lower = Vector3::Zero();
  double Half = 1.0; ///< half of the longest side of the bounding box; the whole side may overflow

  Vector3 operator()(const Vector3& p) const { return (0.5 * p - 0.5 * this->Lower) / this->Half; }

  /// Convert a point that may be far outside of the box, see inUnits().
  Vector3 fromAfar(const Vector3& p) const
  {
    return inUnits(0.5 * p - 0.5 * this->Lower, this->Half);
  }
};

/// Compute the transformation to the unit box of points, from their bounding box.
/// @throws std::invalid_argument if some points are not finite; the message contains their number
UnitBox unitBoxOf(const PointView& points);

/// Transform points to their unit box. Quantities computed from the result depend neither on the
/// position nor on the size of the input.
/// @throws std::invalid_argument if some points are not finite; the message contains their number
Points inUnitBox(const PointView& points);
}

#endif
