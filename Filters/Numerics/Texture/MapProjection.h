/// Plane maps of the whole sphere.

#ifndef ConformalMapProjection_h
#define ConformalMapProjection_h

#include "Base/Types.h"

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// All but Equirectangular are in units of the sphere's radius: areas of the second and third are
/// those of the sphere, the scale of the last is true at the north pole.
enum class MapProjection
{
  Equirectangular,  ///< degrees from the central meridian, and of latitude: 360 by 180
  LambertAzimuthal, ///< equal areas; the northern hemisphere left, the southern right
  Mollweide,        ///< equal areas; an ellipse, 2 : 1
  /// conformal but at four points of the equator, \cite Peirce1879 (by an integral of
  /// \cite Carlson1995); a square with the north pole in the middle, the south pole in the corners
  PeirceQuincuncial
};

/// Half the width and half the height of a map, whose middle is (0, 0).
Vector2 halfSizeOfMap(MapProjection projection);

/// The place of a direction on the map.
/// @param[in] n                 of unit length; the north pole is (0, 0, 1), longitude 0 (1, 0, 0)
/// @param[in] centralLongitude  in degrees: the meridian in the middle; where a pole is there, the
/// one
///   that runs down from it
Vector2 sphereToMap(const Vector3& n, MapProjection projection, double centralLongitude);

/// The inverse.
/// @param[out] n  a unit vector
/// @return whether the place is on the map; n is left alone if not
bool mapToSphere(
  const Vector2& place, MapProjection projection, double centralLongitude, Vector3& n);
}

#endif
