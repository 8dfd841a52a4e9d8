/// Longitude and latitude on a body with a sphere map. Own construction: a Moebius transform of the
/// map, because it is conformal. It moves both ends of the rotation axis to the poles of the
/// sphere.

#ifndef ConformalBodyCoordinates_h
#define ConformalBodyCoordinates_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Rotation axis and prime meridian of a body.
struct BodyCoordinatesOptions
{
  Vector3 Center = { 0, 0, 0 };       ///< point on the rotation axis
  Vector3 RotationAxis = { 0, 0, 1 }; ///< direction from Center to the north pole, of any length
  bool UseMarkerPoint = false;        ///< whether longitude 0 passes through MarkerPoint
  Vector3 MarkerPoint = { 1, 0, 0 };  ///< point on the surface, or close to it
};

struct BodyCoordinates
{
  /// #V by 3 unit vectors; the north pole is at (0, 0, 1), longitude 0 towards (1, 0, 0)
  Points SpherePositions;
  Vector3 NorthPole, SouthPole, Marker; ///< positions of the poles and of the marker on the surface
};

/// Transform a sphere map so that longitude and latitude on the sphere are those of the body.
///
/// From Center, the axis intersects the surface in both directions. The farthest intersections are
/// the poles. A conformal transform of the sphere moves them to opposite points. Several transforms
/// do so. The chosen transform balances north and south: the sum of the body's areas, each times
/// the sine of its latitude, is 0.
///
/// Longitude 0 passes through the point of the surface closest to MarkerPoint. Without a marker
/// point, a ray from Center defines longitude 0. Its direction is x, or y if the axis is x, made
/// perpendicular to the axis. Longitude 0 then passes through the farthest intersection of this ray
/// with the surface. East is counter-clockwise around the north pole seen from outside, also for a
/// mirrored map.
///
/// @param[in] surface  body with its sphere map; finite
/// @throws std::invalid_argument if there are no triangles, or numbers are not finite. Also if the
///   axis has no length, or does not intersect the surface on both sides of Center. Also if both
///   poles coincide on the sphere. Also if no point defines longitude 0, or that point is a pole.
BodyCoordinates findBodyCoordinates(
  const MappedMesh& surface, const BodyCoordinatesOptions& options = {}, const Run& run = {});

/// Convert a direction to longitude and latitude in degrees. Longitude is in [0, 360), latitude in
/// [-90, 90].
Vector2 toLongitudeLatitude(const Vector3& direction);

/// Convert longitude and latitude in degrees to a unit vector. The longitude may have any value.
Vector3 toDirection(const Vector2& longitudeLatitude);

/// Find the points of the body at given directions of the sphere. Coordinates are infinite in a
/// hole of the map.
/// @param[in] directions  #P by 3 unit vectors
Points placeOnBody(const MappedMesh& body, const Points& directions, const Run& run = {});

/// Meridian or parallel as a polyline on the body.
struct GraticuleLine
{
  bool IsMeridian = false;
  double Degrees = 0.0; ///< longitude of a meridian, in [0, 360), or latitude of a parallel
  Points Positions; ///< #L by 3 points along the line; parallels repeat the first point at the end
};

/// Compute meridians and parallels on the body. The points of a line lie on the surface, about a
/// hundredth of the body's size apart.
/// @param[in] spacing  degrees between neighboring lines, in [1, 90]
/// @throws std::invalid_argument if the spacing is out of range or there are no triangles
std::vector<GraticuleLine> makeGraticule(
  const MappedMesh& body, double spacing, const Run& run = {});
}

#endif
