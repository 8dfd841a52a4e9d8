/// Chooses the position and orientation of an image on the sphere for a given view of the surface.

#ifndef ConformalSphereViewChoice_h
#define ConformalSphereViewChoice_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/SphereView.h"

namespace conformal
{
struct SphereViewOptions
{
  Vector3 ViewDirection = { 0, 0, 1 }; ///< from the model to the viewer, of any length
  Vector3 ViewUp = { 0, 1, 0 };        ///< of any length, not parallel to ViewDirection
  bool UseViewPoint = false;           ///< put the pole where ViewPoint is, seen from outside
  Vector3 ViewPoint = { 0, 0, 0 };     ///< a point picked on the surface, or close to it
  double FieldOfView = 180.0; ///< degrees of the sphere across the image's inscribed circle
  double Rotation = 0.0;      ///< degrees by which the viewer sees it turned counter-clockwise
};

/// Choose the pole by a view of the model: the point of the surface that a viewer in ViewDirection
/// meets first on the line through the centroid of its area (if that line misses the surface, its
/// farthest vertex that way). With UseViewPoint it is the point of the surface closest to
/// ViewPoint, and the viewer stands in the direction of the surface's mean normal around it.
///
/// The image is turned so that it stands upright for the viewer, but for Rotation, and is not
/// mirrored: its axes are the model's directions right and up carried to the sphere, in the mean
/// over a cap of an eighth of FieldOfView around the pole.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument on directions that are zero, not finite or parallel, a view point
///   or rotation that is not finite, a field of view out of range, points that are not finite, or
///   no triangles
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphereViewOptions& options = {}, const Run& run = {});
}

#endif
