/// An image laid on the sphere by stereographic projection, and from there on a surface.

#ifndef ConformalSphericalTexture_h
#define ConformalSphericalTexture_h

#include "Parallel.h"
#include "Types.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;
using TextureCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< (s, t)

/// Where and how an image touches the sphere: its middle at Pole, its top towards Up, its right
/// edge towards Right. Orthonormal, and right-handed in the order Right, Up, Pole, unless the
/// surface's map to the sphere is mirrored.
struct SphereView
{
  Vector3 Pole = { 0, 0, 1 };
  Vector3 Up = { 0, 1, 0 };
  Vector3 Right = { 1, 0, 0 };
};

constexpr double MinimumFieldOfView = 0.001; ///< degrees
constexpr double MaximumFieldOfView = 340.0; ///< degrees

struct SphericalTextureOptions
{
  Vector3 ViewDirection = { 0, 0, 1 }; ///< from the model to the viewer, of any length
  Vector3 ViewUp = { 0, 1, 0 };        ///< of any length, not parallel to ViewDirection
  double FieldOfView = 180.0; ///< degrees of the sphere across the image's inscribed circle
};

struct SphericalTexture
{
  TextureCoordinates Coordinates;          ///< #V by 2, clamped to [0, 1]
  std::vector<unsigned char> OutsideImage; ///< #V: 1 where Coordinates had to be clamped
  SphereView View;
};

/// Stereographic projection from the point opposite to the pole, \cite Liou2008 section 4.2: the
/// angle theta from the pole goes to the distance tan(theta / 2) / tan(FieldOfView / 4) from the
/// middle (1/2, 1/2) of the image, in units of half its side.
/// @param[in] n  unit vector; the opposite pole goes to a point far away
/// @return (s, t), not clamped
Vector2 sphereToTexture(const Vector3& n, const SphereView& view, double fieldOfView = 180.0);

/// The inverse of sphereToTexture.
/// @return unit vector
Vector3 textureToSphere(const Vector2& st, const SphereView& view, double fieldOfView = 180.0);

/// Choose the pole by a view of the model: the point of the surface that a viewer in ViewDirection
/// meets first on the line through the centroid of its area (if that line misses the surface, its
/// farthest vertex that way). The image is turned so that it stands upright for the viewer and is
/// not mirrored: its axes are the model's directions right and up carried to the sphere, in the
/// mean over a cap of an eighth of FieldOfView around the pole.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument on directions that are zero, not finite or parallel, a field of
///   view out of range, points that are not finite, or no triangles
SphereView chooseSphereView(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options = {},
  const Progress& progress = {});

/// Texture coordinates of every point of a mapped surface, \cite Liou2008 section 4.2.
/// Same arguments and exceptions as chooseSphereView.
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options = {},
  const ParallelFor& parallelFor = {}, const Progress& progress = {});
}

#endif
