/// Compute texture coordinates of a surface with a sphere map, \cite Liou2008 section 4.2. The
/// texture is an image of the whole sphere or of a part of the sphere.

#ifndef ConformalSphericalTexture_h
#define ConformalSphericalTexture_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/SphereProjection.h"
#include "Texture/SphereViewChoice.h"
#include "Texture/TextureLayout.h"

namespace conformal
{
struct SphericalTextureOptions : SphereViewOptions
{
  SphereProjection Projection = SphereProjection::Stereographic;
  Vector2 Scale = { 1, 1 }; ///< scale of the image about its middle, along s and t; above 0
  TextureWrap Wrap = TextureWrap::Clamp;
  /// Whether to cut the surface along each seam, fold and border of the image; see
  /// makeSphericalTexture().
  bool SplitSeam = false;
  double Margin = 0.0; ///< width of the margin along the seams, see SphereImage::Margin
};

constexpr double MaximumMargin = 0.25;
constexpr double MinimumScale = 1e-3;
constexpr double MaximumScale = 1e3;

/// Compute texture coordinates of every point of a surface from its sphere map, \cite Liou2008
/// section 4.2. The position of the image on the sphere is chosen by chooseSphereView(), except for
/// Disk and Square, which do not use it.
///
/// With SplitSeam, the surface is cut along three kinds of lines: seams, where the projection is
/// discontinuous; folds, where it is not smooth; and borders of the image. The corners of a
/// triangle are then either all inside of the image or all outside. If the distance from a cut to
/// the end of an edge is below a thousandth of the edge's length, the cut is moved to this end. The
/// projection bends the sides of triangles. Even after the cut, the image of a thin triangle can
/// therefore be mirrored. A mirrored triangle is divided at its longest side, repeatedly if
/// necessary. In the result, no triangle shows the image mirrored or squeezed.
///
/// @param[in] points  #V by 3 coordinates, finite
/// @param[in] triangles  #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if Scale or Margin is out of range, or if chooseSphereView()
///   rejects its options
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options = {}, const Run& run = {});
}

#endif
