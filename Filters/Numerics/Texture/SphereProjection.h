/// Images of the sphere: stereographic \cite Liou2008, longitude and latitude \cite Snyder1987,
/// octahedron \cite Praun2003, cube \cite Greene1986.

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
  Stereographic,     ///< plane tangent to the sphere at the pole, \cite Liou2008 section 4.2
  LongitudeLatitude, ///< whole sphere, 2 : 1; pole in the middle, Up along the top edge
  Octahedral,        ///< whole sphere, 1 : 1; pole in the middle, opposite pole in the four corners
  CubeMap            ///< whole sphere, 3 : 2; six faces, pole in the middle of the upper row
};

/// Position and projection of an image on the sphere.
struct SphereImage
{
  SphereProjection Projection = SphereProjection::Stereographic;
  SphereView View;
  double FieldOfView = 180.0; ///< stereographic: degrees across the inscribed circle
  Vector2 Scale = { 1, 1 };   ///< scale of the image about its middle, in s and t
  double Margin = 0.0; ///< octahedral, cube: share of a side left free along the seams, in [0, 1/4]
};

/// Project stereographically onto the plane tangent at the pole, in units of the diameter of the
/// sphere: |w| = tan(theta / 2). The opposite pole is mapped to a point far away.
Vector2 stereographicPlane(const Vector3& n, const SphereView& view);

/// Project a direction to texture coordinates.
/// @param[in] n  of any nonzero length
/// @return (s, t), with 0 and 1 at the borders of the image, and other values outside of it
Vector2 sphereToTexture(const Vector3& n, const SphereImage& image);

/// Compute the direction of texture coordinates: the inverse of sphereToTexture(). In the margin of
/// a seam, the sphere continues beyond the seam, so that pictures interpolate correctly at the
/// seam.
/// @return unit vector
Vector3 textureToSphere(const Vector2& st, const SphereImage& image);

/// Part of the sphere on which the projection is smooth and its image connected: all a.n + b >= 0.
/// Flat triangles cut at its borders have an image without a seam.
struct SpherePatch
{
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> Borders; ///< rows (a, b)
  bool InImage = true; ///< false around the opposite pole of the stereographic projection
};

/// List the parts of the sphere between the seams and folds of a projection.
std::vector<SpherePatch> spherePatches(const SphereImage& image);

/// Find the part that contains a direction, as an index into spherePatches().
int patchOf(const Vector3& n, const SphereImage& image);

/// Project a direction to texture coordinates, continued to the borders of one part. A direction on
/// a seam, or beyond it by rounding, is projected to the side of this part. The zero vector, center
/// of a triangle through the center of the sphere, is projected into the part.
Vector2 patchToTexture(const Vector3& n, const SphereImage& image, int patch);
}

#endif
