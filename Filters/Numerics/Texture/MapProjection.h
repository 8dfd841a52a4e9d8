/// Plane maps of the whole sphere, \cite Snyder1987 and \cite Peirce1879.

#ifndef ConformalMapProjection_h
#define ConformalMapProjection_h

#include "Base/Types.h"

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Map projection. The unit of an equirectangular map is one degree; that of the others is the
/// radius of the sphere. Lambert and Mollweide maps preserve areas; the Peirce map has true scale
/// at the north pole.
enum class MapProjection
{
  /// Degrees of longitude from the central meridian, and degrees of latitude; 360 by 180
  Equirectangular,
  /// Equal areas; two disks, with the northern hemisphere left, the southern right
  LambertAzimuthal,
  /// Equal areas; an ellipse, twice as wide as high
  Mollweide,
  /// Conformal except at four points of the equator, \cite Peirce1879, computed by an integral of
  /// \cite Carlson1995; a square with the north pole in the middle, the south pole in the corners
  PeirceQuincuncial
};

/// Return half the width and half the height of a map centered at (0, 0).
Vector2 halfSizeOfMap(MapProjection projection);

/// Project a direction to the map.
/// @param[in] n                 unit vector; the north pole is (0, 0, 1), longitude 0 on the
///   equator is (1, 0, 0)
/// @param[in] centralLongitude  longitude of the meridian in the middle [degrees]. If a pole is in
///   the middle, it is the meridian from the pole downward.
Vector2 sphereToMap(const Vector3& n, MapProjection projection, double centralLongitude);

/// Compute the direction at a position on the map. This is the inverse of sphereToMap().
/// @param[out] n  unit vector; not changed if the position is outside of the map
/// @return whether the position is on the map
bool mapToSphere(
  const Vector2& place, MapProjection projection, double centralLongitude, Vector3& n);
}

#endif
