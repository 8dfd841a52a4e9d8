/// Choose the position and orientation of an image on the sphere for a given view of the surface.
/// Own construction: derivatives of the map at the pole orient the image.

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
  bool UseViewPoint = false;           ///< put the pole at ViewPoint, seen from outside
  Vector3 ViewPoint = { 0, 0, 0 };     ///< point picked on the surface, or close to it
  double FieldOfView = 180.0; ///< degrees of the sphere across the inscribed circle of the image
  double Rotation = 0.0;      ///< counter-clockwise rotation of the image for the viewer [degrees]
};

/// Choose the pole of an image by a view of the model. The line of sight passes through the
/// centroid of the area of the surface. The pole is its first intersection for a viewer in
/// ViewDirection. If it misses the surface, the pole is the vertex farthest towards the viewer.
/// With UseViewPoint the pole is the point of the surface closest to ViewPoint. The viewer is then
/// in the direction of the mean normal around it.
///
/// The image is upright for the viewer, except for Rotation, and not mirrored. Its axes are the
/// right and up directions of the model mapped to the sphere. They are averaged over a cap of an
/// eighth of FieldOfView around the pole.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if directions are zero, not finite or parallel, or if a view point
///   or rotation is not finite. Also if the field of view is out of range, points are not finite,
///   or there are no triangles.
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphereViewOptions& options = {}, const Run& run = {});
}

#endif
