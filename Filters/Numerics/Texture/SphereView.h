/// Position and axes of an image on the sphere.

#ifndef ConformalSphereView_h
#define ConformalSphereView_h

#include "Base/Types.h"

namespace conformal
{
/// Where and how an image touches the sphere: its middle at Pole, its top towards Up, its right
/// edge towards Right. Orthonormal, and right-handed in the order Right, Up, Pole, unless the
/// surface's map to the sphere is mirrored.
struct SphereView
{
  Vector3 Pole = { 0, 0, 1 };
  Vector3 Up = { 0, 1, 0 };
  Vector3 Right = { 1, 0, 0 };
};

constexpr double MinimumFieldOfView = 0.001; ///< degrees
constexpr double MaximumFieldOfView = 340.0; ///< degrees
}

#endif
