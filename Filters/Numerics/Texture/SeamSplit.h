/// Cuts surfaces along the seams of an image of the sphere.

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
  bool IsOutside; ///< of the image, so that it shows something in its stead
};

/// A place in the plane of the image, as it is wrapped. Repeat and Mirror have copies of the image
/// up to a distance at which no picture could be seen.
WrappedPlace wrapped(const Vector2& st, TextureWrap wrap);

/// Cut the triangles at the borders of the projection's patches and of the image, and give points
/// on these as many copies as they need.
/// @param[in,out] texture  has Image, Coordinates and OutsideImage of the vertices; these are kept
///   for vertices that no triangle uses
void splitAtSeams(SphericalTexture& texture, const Triangles& triangles,
  const Points& spherePositions, TextureWrap wrap, const Run& run);
}

#endif
