/// Define the position and axes of an image on the sphere, \cite Liou2008 section 4.2.

#ifndef ConformalSphereView_h
#define ConformalSphereView_h

#include "Base/Types.h"

namespace conformal
{
/// Orthonormal axes of an image on the sphere. Pole is the middle of the image. Up points to the
/// top edge, and Right to the right edge. The axes Right, Up and Pole are right-handed, unless the
/// sphere map of the surface is mirrored.
struct SphereView
{
  Vector3 Pole = { 0, 0, 1 };
  Vector3 Up = { 0, 1, 0 };
  Vector3 Right = { 1, 0, 0 };
};

/// Minimum angle of the sphere that an image shows [degrees].
constexpr double MinimumFieldOfView = 0.001;
/// Maximum angle of the sphere that an image shows [degrees].
constexpr double MaximumFieldOfView = 340.0;
}

#endif
