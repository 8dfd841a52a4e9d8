/// Plane maps of the whole sphere, \cite Snyder1987 and \cite Peirce1879.

#ifndef ConformalMapProjection_h
#define ConformalMapProjection_h

#include "Base/Types.h"

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Projection. Equirectangular is in degrees, the others are in units of the radius of the sphere.
/// Lambert and Mollweide maps preserve areas; the Peirce map has true scale at the north pole.
enum class MapProjection
{
  Equirectangular,  ///< degrees of longitude from the central meridian, and of latitude: 360 by 180
  LambertAzimuthal, ///< equal areas; northern hemisphere left, southern hemisphere right
  Mollweide,        ///< equal areas; an ellipse, 2 : 1
  /// Conformal except at four points of the equator, \cite Peirce1879 (by an integral of \cite
  /// Carlson1995). A square with the north pole in the middle and the south pole in the corners.
  PeirceQuincuncial
};

/// Return half the width and half the height of a map centered at (0, 0).
Vector2 halfSizeOfMap(MapProjection projection);

/// Project a direction to the map.
/// @param[in] n                 unit vector; the north pole is (0, 0, 1), longitude 0 is (1, 0, 0)
/// @param[in] centralLongitude  degrees: the meridian in the middle; if a pole is in the middle,
///   the meridian that runs down from it
Vector2 sphereToMap(const Vector3& n, MapProjection projection, double centralLongitude);

/// Compute the direction of a position on the map: the inverse of sphereToMap().
/// @param[out] n  unit vector; unchanged outside of the map
/// @return whether the position is on the map
bool mapToSphere(
  const Vector2& place, MapProjection projection, double centralLongitude, Vector3& n);
}

#endif
