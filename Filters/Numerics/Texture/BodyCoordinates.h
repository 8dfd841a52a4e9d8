/// Longitude and latitude on a body that is mapped to the sphere.

#ifndef ConformalBodyCoordinates_h
#define ConformalBodyCoordinates_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Where a body turns, and where longitudes begin.
struct BodyCoordinatesOptions
{
  Vector3 Center = { 0, 0, 0 };       ///< a point of the rotation axis
  Vector3 RotationAxis = { 0, 0, 1 }; ///< towards the north pole, of any length
  bool UseMarkerPoint = false;        ///< longitude 0 goes through MarkerPoint
  Vector3 MarkerPoint = { 1, 0, 0 };  ///< on the surface, or close to it
};

struct BodyCoordinates
{
  Points SpherePositions; ///< #V by 3: north pole (0, 0, 1), longitude 0 towards (1, 0, 0)
  Vector3 NorthPole, SouthPole, Marker; ///< on the body
};

/// Turn and move a map to the sphere so that its longitudes and latitudes are those of the body.
///
/// The poles are the points of the surface that are farthest along the axis to both sides. A
/// transform of the sphere that keeps angles brings them to opposite places; of these transforms
/// it is the one with as much of the body's area, weighted by the sine of the latitude, to the
/// north as to the south. Longitude 0 goes through the point of the surface closest to the marker,
/// or else through the one farthest in the direction that is x, or if that is the axis y, made
/// perpendicular to the axis. East is counter-clockwise around the north pole seen from outside,
/// also if the map was mirrored.
///
/// @param[in] surface  triangles with their map; finite
/// @throws std::invalid_argument if there are no triangles, numbers are not finite, the axis has no
///   length or misses the surface, both poles have one place on the sphere, or the marker is a pole
BodyCoordinates findBodyCoordinates(
  const MappedMesh& surface, const BodyCoordinatesOptions& options = {}, const Run& run = {});

/// Longitude in [0, 360) and latitude in [-90, 90] of a direction, in degrees.
Vector2 toLongitudeLatitude(const Vector3& direction);

/// The unit vector of a longitude, of any range, and a latitude, in degrees.
Vector3 toDirection(const Vector2& longitudeLatitude);

/// The points of the body that have these directions on the sphere; infinite where the map has a
/// hole.
/// @param[in] directions  #P by 3 unit vectors
Points placeOnBody(const MappedMesh& body, const Points& directions, const Run& run = {});

/// A meridian, or a parallel, as a line on the body.
struct GraticuleLine
{
  bool IsMeridian = false;
  double Degrees = 0.0; ///< longitude in [0, 360), or latitude
  Points Positions;     ///< #L by 3, the first again at the end of parallels
};

/// Meridians and parallels on the body. Points of a line lie on the surface, and so close to each
/// other that it is followed: by a hundredth of the body's size, as long as that can be.
/// @param[in] spacing  in degrees, in [1, 90]
/// @throws std::invalid_argument if the spacing is out of range or there are no triangles
std::vector<GraticuleLine> makeGraticule(
  const MappedMesh& body, double spacing, const Run& run = {});
}

#endif
