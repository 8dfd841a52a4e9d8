/// Choose the position and orientation of an image on the sphere for a given view of the surface.
/// The method is an own construction, not from a publication. In its middle, the image should be
/// upright for the viewer. The orientation is therefore computed from derivatives of the sphere map
/// in the middle of the image.

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
  /// Upward direction for the viewer, of any length. Must not be parallel to ViewDirection.
  Vector3 ViewUp = { 0, 1, 0 };
  /// Whether the middle of the image is at ViewPoint. ViewDirection is then replaced by the mean
  /// outward normal around ViewPoint.
  bool UseViewPoint = false;
  Vector3 ViewPoint = { 0, 0, 0 }; ///< point picked on the surface, or close to the surface
  /// Angle of the sphere across the inscribed circle of the image [degrees].
  double FieldOfView = 180.0;
  double Rotation = 0.0; ///< counter-clockwise rotation of the image for the viewer [degrees]
};

/// Choose the pole (middle) and the axes of an image for a view of the surface. The pole is the
/// sphere position of a point of the surface. By default, this is the visible point on the line of
/// sight through the centroid of the surface area. If this line does not intersect the surface, the
/// vertex nearest to the viewer is chosen. With UseViewPoint, the point of the surface closest to
/// ViewPoint is chosen. The view direction is then the mean normal around this point.
///
/// For the viewer, the image is not mirrored. Before the rotation by the angle Rotation, the image
/// is upright. Its axes are the right and up directions of the viewer, mapped from the surface to
/// the sphere. The axes are averaged over a cap around the pole, with a radius of an eighth of
/// FieldOfView.
///
/// @param[in] points  #V by 3 coordinates, finite
/// @param[in] triangles  #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if ViewDirection or ViewUp is zero or not finite, or if they are
///   parallel
/// @throws std::invalid_argument if ViewPoint, Rotation or a point is not finite
/// @throws std::invalid_argument if FieldOfView is out of range, or if there are no triangles
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphereViewOptions& options = {}, const Run& run = {});
}

#endif
