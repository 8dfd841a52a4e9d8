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
  /// Whether to cut the surface along each seam, fold and border of the image
  bool SplitSeam = false;
  double Margin = 0.0; ///< see SphereImage::Margin
};

constexpr double MaximumMargin = 0.25;
constexpr double MinimumScale = 1e-3;
constexpr double MaximumScale = 1e3;

/// Compute texture coordinates of every point of a surface from its sphere map, \cite Liou2008
/// section 4.2. The position of the image on the sphere is chosen by chooseSphereView().
///
/// With SplitSeam, the surface is cut along each seam and fold of the projection, and along each
/// border of the image. No triangle then shows the image mirrored or squeezed, and OutsideImage is
/// equal at the three corners of each triangle. An edge is not cut within a thousandth of its
/// length from an end. Thin triangles that would be mirrored because the projection bends them are
/// cut across.
///
/// @param[in] points           #V by 3 coordinates, finite
/// @param[in] triangles        #F by 3 ids in [0, #V), at least one
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if Scale or Margin is out of range, or for a reason given at
///   chooseSphereView()
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options = {}, const Run& run = {});
}

#endif
