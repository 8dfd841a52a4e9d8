/// Coordinates of which squares and cubes can be taken without a thought of the unit.

#ifndef ConformalUnitBox_h
#define ConformalUnitBox_h

#include "Types.h"

namespace conformal
{
/// Points moved and scaled so that the longest side of their bounding box is [0, 1]. For measures
/// that do not depend on place and size.
/// @throws std::invalid_argument with their number, if points are not finite
Points inUnitBox(const PointView& points);
}

#endif
