/// Longitude and latitude on a body with a sphere map. Own construction: a Moebius transform brings
/// the poles of the rotation axis to the poles of the sphere.

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
  Vector3 Center = { 0, 0, 0 };       ///< point of the rotation axis
  Vector3 RotationAxis = { 0, 0, 1 }; ///< direction of the north pole, of any length
  bool UseMarkerPoint = false;        ///< whether longitude 0 passes through MarkerPoint
  Vector3 MarkerPoint = { 1, 0, 0 };  ///< point on the surface, or close to it
};

struct BodyCoordinates
{
  Points SpherePositions; ///< #V by 3: north pole (0, 0, 1), longitude 0 towards (1, 0, 0)
  Vector3 NorthPole, SouthPole, Marker; ///< points of the surface
};

/// Transform a sphere map so that its longitudes and latitudes are those of the body.
///
/// The poles are the points of the surface farthest along the axis in both directions. A conformal
/// transform of the sphere makes them antipodal. Among these transforms, the chosen one balances
/// the area of the body, weighted by the sine of the latitude, between north and south.
///
/// Longitude 0 passes through the point of the surface closest to the marker. Without a marker it
/// passes through the point farthest in direction x made perpendicular to the axis, or y for the
/// axis x. East is counter-clockwise around the north pole seen from outside, also for a mirrored
/// map.
///
/// @param[in] surface  triangles with their map; finite
/// @throws std::invalid_argument if there are no triangles or numbers are not finite. Also if the
///   axis has no length or misses the surface, if both poles coincide on the sphere, or if the
///   marker is a pole.
BodyCoordinates findBodyCoordinates(
  const MappedMesh& surface, const BodyCoordinatesOptions& options = {}, const Run& run = {});

/// Convert a direction to longitude in [0, 360) and latitude in [-90, 90], in degrees.
Vector2 toLongitudeLatitude(const Vector3& direction);

/// Convert a longitude, of any range, and a latitude, in degrees, to a unit vector.
Vector3 toDirection(const Vector2& longitudeLatitude);

/// Find the points of the body at directions of the sphere; infinite in a hole of the map.
/// @param[in] directions  #P by 3 unit vectors
Points placeOnBody(const MappedMesh& body, const Points& directions, const Run& run = {});

/// Meridian or parallel as a polyline on the body.
struct GraticuleLine
{
  bool IsMeridian = false;
  double Degrees = 0.0; ///< longitude in [0, 360), or latitude
  Points Positions;     ///< #L by 3; parallels repeat the first point at the end
};

/// Compute meridians and parallels on the body. The points of a line lie on the surface, at
/// distances of about a hundredth of the size of the body.
/// @param[in] spacing  degrees, in [1, 90]
/// @throws std::invalid_argument if the spacing is out of range or there are no triangles
std::vector<GraticuleLine> makeGraticule(
  const MappedMesh& body, double spacing, const Run& run = {});
}

#endif
