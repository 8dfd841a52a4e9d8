/// Projections between the sphere and images: stereographic \cite Liou2008, longitude and latitude
/// \cite Snyder1987, octahedron \cite Praun2003, cube \cite Greene1986.

#ifndef ConformalSphereProjection_h
#define ConformalSphereProjection_h

#include "Base/Types.h"
#include "Texture/SphereView.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;

enum class SphereProjection
{
  Stereographic, ///< plane tangent to the sphere at the pole, \cite Liou2008 section 4.2
  /// Whole sphere, 2 : 1; the pole is in the middle, the direction Up along the top edge
  LongitudeLatitude,
  /// Whole sphere, 1 : 1; the pole is in the middle, the opposite pole in the four corners
  Octahedral,
  CubeMap ///< whole sphere, 3 : 2; six faces, with the pole in the middle of the upper row
};

/// Position and projection of an image on the sphere.
struct SphereImage
{
  SphereProjection Projection = SphereProjection::Stereographic;
  SphereView View;
  /// For Stereographic: degrees of the sphere across the inscribed circle of the image
  double FieldOfView = 180.0;
  Vector2 Scale = { 1, 1 }; ///< scale of the image about its middle, in s and t
  /// For Octahedral and CubeMap: width of the margin along the seams, as a fraction of a side, in
  /// [0, 1/4]
  double Margin = 0.0;
};

/// Project a direction stereographically onto the plane tangent to the sphere at the pole. The unit
/// is the diameter of the sphere: a direction at an angle theta from the pole is mapped to the
/// distance tan(theta / 2). The opposite pole is mapped to a point far away.
Vector2 stereographicPlane(const Vector3& n, const SphereView& view);

/// Project a direction to texture coordinates.
/// @param[in] n  direction, of any nonzero length
/// @return texture coordinates (s, t): 0 and 1 at the borders of the image, below 0 or above 1
///   outside
Vector2 sphereToTexture(const Vector3& n, const SphereImage& image);

/// Compute the direction at texture coordinates. This is the inverse of sphereToTexture(). The
/// margin along a seam shows the part of the sphere beyond the seam, so that pixels can be
/// interpolated at the seam.
/// @return unit vector
Vector3 textureToSphere(const Vector2& st, const SphereImage& image);

/// Part of the sphere on which the projection is smooth and its image connected. It consists of the
/// directions n with a.n + b >= 0 for all Borders (a, b). Flat triangles cut along these borders
/// have an image without a seam.
struct SpherePatch
{
  /// One row (a, b) for each border
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> Borders;
  /// Whether the image shows this part; false around the opposite pole of the stereographic
  /// projection
  bool InImage = true;
};

/// List the parts of the sphere that are separated by the seams and folds of a projection.
std::vector<SpherePatch> spherePatches(const SphereImage& image);

/// Find the part of the sphere that contains a direction. The result is an index into
/// spherePatches().
int patchOf(const Vector3& n, const SphereImage& image);

/// Project a direction to texture coordinates by the projection of one part of the sphere. A
/// direction on a seam, or beyond it by rounding, thus gets coordinates on the side of this part.
/// The zero vector is projected into the part, too: it can be the center of a flat triangle.
Vector2 patchToTexture(const Vector3& n, const SphereImage& image, int patch);
}

#endif
