/// Compute plane maps of the whole sphere, \cite Snyder1987 and \cite Peirce1879. The map of a
/// capsule, for long bodies, is an own construction.

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
  Mercator,
  /// The sphere is mapped conformally to a capsule: a cylinder of radius 1 with a hemisphere at
  /// each end. The map shows the cylinder as a rectangle that is 2 pi wide. Above and below are
  /// disks, which touch the rectangle at the central meridian: the hemispheres, in Lambert's
  /// azimuthal projection \cite Snyder1987 Eqs. 24-2 to 24-4.
  ///
  /// Own construction: a conformal map of the sphere multiplies areas along a tube by an
  /// exponential function of the distance from its middle. A capsule as long as the body, in
  /// diameters, undoes this. Conformal maps of surfaces of revolution preserve the isometric
  /// latitude, \cite Snyder1987 Eq. 7-7: the integral of ds / r over the arc length s of the
  /// profile, with radius r. On the cylinder, it is s. On a hemisphere, it increases as that of a
  /// sphere, so that the stereographic image of each cap is multiplied by a number. The map
  /// preserves areas of the capsule everywhere, and angles on the rectangle. On the disks, lengths
  /// in two directions differ at most by a factor of 2, at the rim.
  Capsule
};

/// Largest aspect of a capsule. The ends of longer capsules are too small on the sphere for the
/// precision of doubles.
constexpr double MaximumCapsuleAspect = 25.0;

/// Return half the width and half the height of a map centered at (0, 0).
/// @param[in] capsuleAspect  ratio of length to diameter of the capsule, in [1,
///   MaximumCapsuleAspect]. Used by Capsule. With 1, the capsule is a sphere.
Vector2 halfSizeOfMap(MapProjection projection, double capsuleAspect = 1.0);

/// Return the ratio of a short length on the capsule to the length on the sphere that is mapped to
/// it. For other projections than Capsule, the result is 1.
double capsuleScale(const Vector3& n, MapProjection projection, double capsuleAspect);

/// Project a direction to the map. Directions beyond a Mercator map are moved to its edge.
/// @param[in] n  unit vector; the north pole is (0, 0, 1), longitude 0 on the equator is (1, 0, 0)
/// @param[in] centralLongitude  longitude of the central meridian [degrees]. In maps with a pole in
///   the middle (LambertAzimuthal and PeirceQuincuncial), this meridian runs from the pole
///   downward.
/// @param[in] capsuleAspect  see halfSizeOfMap()
Vector2 sphereToMap(
  const Vector3& n, MapProjection projection, double centralLongitude, double capsuleAspect = 1.0);

/// Compute the direction at a position on the map. This is the inverse of sphereToMap().
/// @param[out] n  unit vector; not changed if the position is outside of the map
/// @return true if the position is on the map
bool mapToSphere(const Vector2& place, MapProjection projection, double centralLongitude,
  Vector3& n, double capsuleAspect = 1.0);
}

#endif
