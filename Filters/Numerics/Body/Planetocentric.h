/// Compute planetocentric coordinates of a body, such as an asteroid: longitude, latitude and
/// radius seen from its center, as catalogs and archives use them, \cite Archinal2018.

#ifndef ConformalPlanetocentric_h
#define ConformalPlanetocentric_h

#include "Base/Run.h"
#include "Body/BodyCoordinates.h"
#include "Body/MapImage.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Center of a body, and the directions of its longitudes and latitudes.
struct PlanetocentricFrame
{
  Vector3 Center = Vector3::Zero();
  /// Orthonormal columns: longitude 0 and longitude 90 degrees on the equator, and north.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
};

/// Return the frame of a rotation axis and prime meridian. Longitude 0 is towards the marker point
/// or, without it, towards the x axis (y axis), see findBodyCoordinates(). Longitude increases
/// counter-clockwise, seen from the north.
/// @throws std::invalid_argument if the marker point is on the axis
PlanetocentricFrame planetocentricFrame(const BodyCoordinatesOptions& options);

/// Compute longitude, latitude and radius of each point. The center has longitude and latitude 0.
/// @return #V by 3: degrees in [0, 360), degrees in [-90, 90], and a length
Points planetocentricCoordinates(
  const Points& points, const PlanetocentricFrame& frame, const Run& run = {});

/// Find the point of the body that each pixel shows, and pass the points to `sink`, a function of
/// the caller. A pixel shows the point of the body that is farthest from the center in the
/// direction of the pixel. If a ray from the center intersects the body several times, all other
/// points are not shown.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintPlanetocentricMap(const Mesh& body, const PlanetocentricFrame& frame,
  const MapImage& image, const PixelSink& sink, const Run& run = {});
}

#endif
