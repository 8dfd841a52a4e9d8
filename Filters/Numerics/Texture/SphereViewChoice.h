/// Choose the position and orientation of an image on the sphere for a given view of the surface.
/// The method is an own construction, not from a publication. The middle of the image should be
/// upright for the viewer. The orientation of the image is therefore computed from derivatives of
/// the sphere map (map of the surface to the unit sphere) at the middle.

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
  /// Angle on the sphere that corresponds to the diameter of the image's inscribed circle
  /// [degrees].
  double FieldOfView = 180.0;
  /// Rotation of the image, counter-clockwise as seen by the viewer [degrees].
  double Rotation = 0.0;
};

/// Require that a surface has triangles, and a position on the sphere for each point.
/// @throws std::invalid_argument
void requireMap(const PointView& points, const Triangles& triangles, const Points& spherePositions);

/// Choose the pole (middle) and the axes of an image for a view of the surface. The pole is the
/// sphere position of a point of the surface. By default, this point is the visible intersection of
/// the surface with a line: the line of sight through the centroid of the surface area. If this
/// line does not intersect the surface, the vertex nearest to the viewer is chosen. With
/// UseViewPoint, the point of the surface closest to ViewPoint is chosen. The view direction is
/// then the mean normal around this point.
///
/// For the viewer, the image is not mirrored. Before the rotation by the angle Rotation, the image
/// is upright. The axes of the image are the right and up directions of the viewer, mapped from the
/// surface to the sphere. The axes are averaged over a cap around the pole, with a radius of an
/// eighth of FieldOfView.
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
