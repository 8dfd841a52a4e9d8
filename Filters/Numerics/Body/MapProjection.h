/// Compute plane maps of the whole sphere, \cite Snyder1987 and \cite Peirce1879.

#ifndef ConformalMapProjection_h
#define ConformalMapProjection_h

#include "Base/Types.h"

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Projection of the sphere to a plane map. The unit of an equirectangular map is one degree. The
/// unit of the other maps is the radius of the sphere. Lambert and Mollweide maps preserve areas.
/// The scale of the Peirce map is 1 at the north pole, that of the Mercator map on the equator.
enum class MapProjection
{
  /// The map is 360 by 180 units. Its coordinates are degrees of longitude from the central
  /// meridian, and degrees of latitude.
  Equirectangular,
  /// The map consists of two disks: the northern hemisphere left, the southern hemisphere right.
  LambertAzimuthal,
  /// The map is an ellipse, twice as wide as high.
  Mollweide,
  /// The map is a square with the north pole in the middle and the south pole in the corners. The
  /// map is conformal except at four points of the equator, \cite Peirce1879. The projection is
  /// computed by an integral of \cite Carlson1995.
  PeirceQuincuncial,
  /// The map is a square with the equator in the middle, \cite Snyder1987 Eqs. 7-1 and 7-2. The map
  /// is conformal. It ends at latitudes of 85.05 degrees; the poles are not on it.
  Mercator
};

/// Return half the width and half the height of a map centered at (0, 0).
Vector2 halfSizeOfMap(MapProjection projection);

/// Project a direction to the map. Directions beyond a Mercator map are moved to its edge.
/// @param[in] n  unit vector; the north pole is (0, 0, 1), longitude 0 on the equator is (1, 0, 0)
/// @param[in] centralLongitude  longitude of the central meridian [degrees]. In maps with a pole in
///   the middle (LambertAzimuthal and PeirceQuincuncial), this meridian runs from the pole
///   downward.
Vector2 sphereToMap(const Vector3& n, MapProjection projection, double centralLongitude);

/// Compute the direction at a position on the map. This is the inverse of sphereToMap().
/// @param[out] n  unit vector; not changed if the position is outside of the map
/// @return true if the position is on the map
bool mapToSphere(
  const Vector2& place, MapProjection projection, double centralLongitude, Vector3& n);
}

#endif
