/// Position and axes of an image on the sphere, \cite Liou2008 section 4.2.

#ifndef ConformalSphereView_h
#define ConformalSphereView_h

#include "Base/Types.h"

namespace conformal
{
/// Orthonormal axes of an image on the sphere. The middle of the image is at Pole, its top points
/// towards Up, its right edge towards Right. The axes Right, Up and Pole are right-handed, unless
/// the sphere map of the surface is mirrored.
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
