/// Choose the position and orientation of an image on the sphere for a given view of the surface.
/// Own construction: the orientation is computed from derivatives of the map around the pole,
/// because the image should be upright there for the viewer.

#ifndef ConformalSphereViewChoice_h
#define ConformalSphereViewChoice_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/SphereView.h"

namespace conformal
{
struct SphereViewOptions
{
  Vector3 ViewDirection = { 0, 0, 1 }; ///< direction from the surface to the viewer, of any length
  /// Upward direction for the viewer, of any length, not parallel to ViewDirection
  Vector3 ViewUp = { 0, 1, 0 };
  bool UseViewPoint = false;       ///< whether the pole is at ViewPoint, viewed from outside
  Vector3 ViewPoint = { 0, 0, 0 }; ///< point picked on the surface, or close to it
  double FieldOfView = 180.0; ///< degrees of the sphere across the inscribed circle of the image
  double Rotation = 0.0;      ///< counter-clockwise rotation of the image for the viewer [degrees]
};

/// Choose the pole and the axes of an image for a view of the surface. The pole is the point of the
/// sphere that corresponds to a point of the surface. By default, this is the point that the viewer
/// sees on the line of sight through the centroid of the surface's area. If this line does not
/// intersect the surface, it is the vertex nearest to the viewer. With UseViewPoint, it is the
/// point of the surface closest to ViewPoint, and the view direction is the mean normal around this
/// point.
///
/// For the viewer, the image is not mirrored, and upright before it is rotated by Rotation. Its
/// axes are the viewer's right and up directions, mapped from the surface to the sphere. They are
/// averaged over a cap around the pole, with a radius of an eighth of FieldOfView.
///
/// @param[in] points           #V by 3 coordinates, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if ViewDirection or ViewUp is zero or not finite, or if they are
///   parallel. Also if ViewPoint, Rotation or a point is not finite, FieldOfView is out of range,
///   or there are no triangles.
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphereViewOptions& options = {}, const Run& run = {});
}

#endif
