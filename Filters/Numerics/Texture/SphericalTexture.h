/// Texture coordinates of a mapped surface for an image of the sphere, \cite Liou2008 section 4.2.

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
  Vector2 Scale = { 1, 1 }; ///< scale of the image about its middle, in s and t; > 0
  TextureWrap Wrap = TextureWrap::Clamp;
  bool SplitSeam = false; ///< cut the surface at each seam, fold or border of the image
  double Margin = 0.0;    ///< see SphereImage
};

constexpr double MaximumMargin = 0.25;
constexpr double MinimumScale = 1e-3;
constexpr double MaximumScale = 1e3;

/// Compute texture coordinates of every point of a mapped surface, \cite Liou2008 section 4.2. The
/// view is chosen by chooseSphereView().
///
/// With SplitSeam every triangle lies on one side of every seam and fold of the projection and of
/// every border of the image. No triangle then shows the image mirrored or squeezed, and
/// OutsideImage is equal at its three corners. Edges are cut at such a line, unless it is within a
/// thousandth of their length from an end. Thin triangles that would flip in the image by bending
/// are cut across.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument as chooseSphereView(), and if Scale or Margin is out of range
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options = {}, const Run& run = {});
}

#endif
