/// Convert between directions on the sphere and positions in images. The projections are
/// stereographic \cite Liou2008, longitude and latitude \cite Snyder1987, octahedron
/// \cite Praun2003, cube \cite Greene1986, and, for a hemisphere, disk and square
/// \cite Peirce1879.

#ifndef ConformalSphereProjection_h
#define ConformalSphereProjection_h

#include "Base/Types.h"
#include "Texture/SphereView.h"

#include <vector>

namespace conformal
{
using Vector2 = Eigen::Vector2d;

/// Projection of directions to an image. View is the member of SphereImage that stores the position
/// of the image.
enum class SphereProjection
{
  /// Projection onto the plane tangent to the sphere at View.Pole, \cite Liou2008 section 4.2.
  Stereographic,
  /// Whole sphere, twice as wide as high. View.Pole is in the middle of the image. All points of
  /// the top edge have the direction View.Up.
  LongitudeLatitude,
  /// Whole sphere, a square. View.Pole is in the middle of the image, and the opposite direction is
  /// in the four corners.
  Octahedral,
  /// Whole sphere, six faces of a cube in two rows of three. View.Pole is in the middle of the
  /// upper row.
  CubeMap,
  /// Hemisphere z >= 0, on which sheets are mapped, see mapSheet(): the disk inscribed in the
  /// image, by the stereographic projection. Directions do not depend on View.
  Disk,
  /// Hemisphere z >= 0: the whole image, by the conformal map of the disk onto the square. The
  /// corners of the image are the directions (1, 1, 0), (-1, 1, 0), (-1, -1, 0) and (1, -1, 0).
  Square
};

/// Position and projection of an image on the sphere.
struct SphereImage
{
  SphereProjection Projection = SphereProjection::Stereographic;
  SphereView View;
  /// Angle on the sphere that corresponds to the diameter of the image's inscribed circle
  /// [degrees]. Used by Stereographic.
  double FieldOfView = 180.0;
  Vector2 Scale = { 1, 1 }; ///< scale of the image about its middle, along s and t
  /// Width of the margin along the seams (lines where the image is discontinuous), in [0, 1/4]. The
  /// unit is the side of the square (Octahedral) or of a cube face (CubeMap).
  double Margin = 0.0;
};

/// Return whether an image shows the hemisphere z >= 0, independently of View: Disk and Square.
bool isHemisphere(SphereProjection projection);

/// Project a direction stereographically onto the plane tangent to the sphere at the pole of the
/// view. The unit is the diameter of the sphere. Let theta be the angle between the direction and
/// the pole. In the plane, the distance from the pole to the projected direction is tan(theta / 2).
/// The direction opposite to the pole is mapped to a point at a very large distance.
Vector2 stereographicPlane(const Vector3& n, const SphereView& view);

/// Project a direction to texture coordinates.
/// @param[in] n  direction, of any nonzero length
/// @return texture coordinates (s, t), in [0, 1] within the image
Vector2 sphereToTexture(const Vector3& n, const SphereImage& image);

/// Compute the direction at texture coordinates. This is the inverse of sphereToTexture(). The
/// margin along a seam (a line where the image is discontinuous) shows the part of the sphere
/// beyond the seam. Pixels at the seam can thus be interpolated with their neighbors beyond the
/// seam. Beyond the border of Disk and Square, the image shows the mirror image of the hemisphere.
/// @return unit vector
Vector3 textureToSphere(const Vector2& st, const SphereImage& image);

/// Part of the sphere on which the projection is smooth, and whose image is connected. The part
/// consists of the directions n with a . n + b >= 0 for all Borders (a, b), where a is a vector and
/// b is a number. If the triangles of a surface are cut along these borders, the image of each
/// triangle is connected.
struct SpherePatch
{
  /// Borders of the part, with one row (a, b) for each border.
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> Borders;
  /// Whether the image shows this part. False for the part opposite to the pole in the
  /// stereographic projection.
  bool InImage = true;
};

/// List the parts of the sphere that are separated by seams and folds of a projection. At a seam,
/// the projection is discontinuous. At a fold, it is continuous but not smooth.
std::vector<SpherePatch> spherePatches(const SphereImage& image);

/// Find the part of the sphere that contains a direction. The result is an index into
/// spherePatches().
int patchOf(const Vector3& n, const SphereImage& image);

/// Project a direction to texture coordinates by the projection of one part of the sphere. If a
/// direction is on a seam, or beyond the seam by rounding, its coordinates are thus on the side of
/// the given part. The zero vector is also accepted, and is projected into the given part. This
/// vector occurs if a flat triangle passes through the center of the sphere.
/// @param[in] patch  index into spherePatches()
Vector2 patchToTexture(const Vector3& n, const SphereImage& image, int patch);
}

#endif
