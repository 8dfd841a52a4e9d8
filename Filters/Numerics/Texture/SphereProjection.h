/// Images of the sphere: stereographic, longitude and latitude, octahedron, cube.

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
  Stereographic,     ///< a plane that touches the sphere at the pole, \cite Liou2008 section 4.2
  LongitudeLatitude, ///< all of the sphere, 2 : 1; the pole in the middle, Up along the top edge
  Octahedral,        ///< all of it, 1 : 1; the pole in the middle, its opposite in the four corners
  CubeMap            ///< all of it, 3 : 2; six faces, the pole in the middle of the upper row
};

/// How an image lies on the sphere.
struct SphereImage
{
  SphereProjection Projection = SphereProjection::Stereographic;
  SphereView View;
  double FieldOfView = 180.0; ///< stereographic: degrees across the inscribed circle
  Vector2 Scale = { 1, 1 };   ///< size of the image, about its middle, in s and t
  double Margin = 0.0; ///< octahedral, cube: share of a side left free along the seams, in [0, 1/4]
};

/// Stereographic projection onto the plane that touches the sphere at the pole, in units of its
/// diameter: |w| = tan(theta / 2). The opposite pole goes to a point far away.
Vector2 stereographicPlane(const Vector3& n, const SphereView& view);

/// The place of a direction in the image.
/// @param[in] n  of any length but zero
/// @return (s, t), 0 and 1 being the image's borders; beyond them where the image does not reach
Vector2 sphereToTexture(const Vector3& n, const SphereImage& image);

/// The inverse of sphereToTexture. Beyond a seam, in its margin, the sphere goes on: what lies
/// there is what a picture must show so that interpolation at the seam is right.
/// @return unit vector
Vector3 textureToSphere(const Vector2& st, const SphereImage& image);

/// A part of the sphere on which the projection is smooth and its image in one piece: where all of
/// a.n + b >= 0. Flat triangles cut at its borders can be laid in the image without a seam.
struct SpherePatch
{
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> Borders; ///< (a, b) each
  bool InImage = true; ///< false around the opposite pole of the stereographic projection
};

/// The parts into which a projection's seams and folds cut the sphere.
std::vector<SpherePatch> spherePatches(const SphereImage& image);

/// The part that holds a direction, by its index in spherePatches.
int patchOf(const Vector3& n, const SphereImage& image);

/// sphereToTexture, continued to the borders of one part: what lies on a seam, or beyond it by
/// rounding, goes to this part's side of the seam. The zero vector, the middle of a triangle that
/// goes through the sphere's center, goes to some place of the part.
Vector2 patchToTexture(const Vector3& n, const SphereImage& image, int patch);
}

#endif
