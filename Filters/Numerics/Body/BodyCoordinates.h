/// Compute longitude and latitude on a body, such as an asteroid, that has a map to the sphere. The
/// method is an own construction, not from a publication. A Moebius transform of the sphere moves
/// both ends of the body's rotation axis to the poles of the sphere. If the map is conformal, it
/// remains conformal.

#ifndef ConformalBodyCoordinates_h
#define ConformalBodyCoordinates_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Rotation axis and prime meridian of a body. All positions are in the coordinates of the surface.
struct BodyCoordinatesOptions
{
  Vector3 Center = { 0, 0, 0 };       ///< point on the rotation axis
  Vector3 RotationAxis = { 0, 0, 1 }; ///< direction from Center to the north pole, of any length
  /// Whether the poles are the ends of the surface, for bent bodies: two points that are farthest
  /// apart along the surface. The north pole is the one farther in the direction of RotationAxis.
  bool UseEnds = false;
  bool UseMarkerPoint = false;       ///< whether MarkerPoint defines longitude 0
  Vector3 MarkerPoint = { 1, 0, 0 }; ///< point on the surface, or close to the surface
};

struct BodyCoordinates
{
  /// Transformed sphere map, #V by 3 unit vectors. The north pole is (0, 0, 1), and longitude 0 on
  /// the equator is (1, 0, 0).
  Points SpherePositions;
  /// Points of the surface: both poles, and the point that defines longitude 0.
  Vector3 NorthPole, SouthPole, Marker;
};

/// Transform a sphere map so that longitude and latitude on the sphere are those of the body.
///
/// From Center, the rotation axis intersects the surface in both directions. In each direction, the
/// farthest intersection is a pole. A conformal transform of the sphere moves both poles to
/// opposite points of the sphere. Several transforms have this property. The transform is chosen
/// that balances north and south: the mean sine of latitude over the area of the body is 0.
///
/// With UseEnds, the poles are vertices: the vertex that is farthest from the first vertex along
/// edges of the triangles, and the vertex farthest from this pole. Without a marker point,
/// longitude 0 passes through the vertex that is farthest in the direction of the ray below, of
/// those about midway between the poles.
///
/// Longitude 0 passes through the point of the surface closest to MarkerPoint. Without a marker
/// point, longitude 0 passes through the farthest intersection of the surface with a ray from
/// Center. The direction of the ray is the x axis, projected to the plane perpendicular to the
/// rotation axis. If the angle between the rotation axis and the x axis is below 2.6 degrees, the y
/// axis is projected instead. Seen from above the north pole, longitude increases
/// counter-clockwise, even if the map to the sphere is mirrored.
///
/// @param[in] surface  body with its sphere map; all numbers must be finite
/// @throws std::invalid_argument if there are no triangles, or if numbers are not finite
/// @throws std::invalid_argument if the axis has length 0, or does not intersect the surface on
///   both sides of Center
/// @throws std::invalid_argument if both poles coincide on the sphere
/// @throws std::invalid_argument if the ray for longitude 0 does not intersect the surface, or if
///   the point of longitude 0 is a pole
BodyCoordinates findBodyCoordinates(
  const MappedMesh& surface, const BodyCoordinatesOptions& options = {}, const Run& run = {});

/// Return the direction of longitude 0 without a marker point, perpendicular to the axis.
/// @param[in] axis  unit vector
Vector3 towardsLongitudeZero(const Vector3& axis);

/// Convert a direction to longitude and latitude in degrees. Longitude is in [0, 360), latitude in
/// [-90, 90].
Vector2 toLongitudeLatitude(const Vector3& direction);

/// Convert longitude and latitude in degrees to a unit vector. The longitude may have any value.
Vector3 toDirection(const Vector2& longitudeLatitude);

/// Find the points of the body at given directions of the sphere. If a direction is in a hole of
/// the map, where there is no triangle, the coordinates of its point are infinite.
/// @param[in] directions  #P by 3 unit vectors
/// @return #P by 3 positions
Points placeOnBody(const MappedMesh& body, const Points& directions, const Run& run = {});

/// Meridian (line of constant longitude) or parallel (line of constant latitude) as a polyline on
/// the body.
struct GraticuleLine
{
  bool IsMeridian = false;
  double Degrees = 0.0; ///< longitude of a meridian, in [0, 360), or latitude of a parallel
  /// Points along the line, #L by 3. A parallel repeats its first point at the end.
  Points Positions;
};

/// Compute meridians and parallels on the body. The points of a line are on the surface.
/// Neighboring points are about a hundredth of the size of the body apart. At a hole of the map, a
/// line ends, and another one begins behind the hole.
/// @param[in] body  body with a sphere map whose north pole is (0, 0, 1)
/// @param[in] spacing  angle between neighboring lines, in [1, 90] [degrees]
/// @throws std::invalid_argument if the spacing is out of range or there are no triangles
std::vector<GraticuleLine> makeGraticule(
  const MappedMesh& body, double spacing, const Run& run = {});
}

#endif
