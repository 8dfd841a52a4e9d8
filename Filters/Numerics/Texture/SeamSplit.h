/// Cut surfaces along the seams of an image of the sphere. Own construction: a cut point is
/// computed from the two ends of the original edge, because both its triangles then get the same
/// point. The surface thus has no gaps.

#ifndef ConformalSeamSplit_h
#define ConformalSeamSplit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/TextureLayout.h"

namespace conformal
{
struct WrappedPlace
{
  Vector2 Coordinates;
  /// For Clamp: whether the position is outside of the image; otherwise: whether it is too far away
  /// to wrap
  bool IsOutside;
};

/// Wrap a position in the plane of the image. Repeat and Mirror wrap positions only up to a maximum
/// distance. Beyond it, texture coordinates in single precision are too coarse for the pixels of an
/// image.
WrappedPlace wrapped(const Vector2& st, TextureWrap wrap);

/// Cut the triangles along the border of the image, and along the borders between the patches of
/// its projection (SpherePatch). Points on these borders are duplicated if they need several
/// texture coordinates.
/// @param[in,out] texture  texture of the uncut surface: Image, and Coordinates and OutsideImage of
///   all vertices. The cut surface is added. Vertices without triangles keep their values.
void splitAtSeams(SphericalTexture& texture, const Triangles& triangles,
  const Points& spherePositions, TextureWrap wrap, const Run& run);
}

#endif
