/// Cut surfaces along the seams of an image of the sphere. Own construction: cuts on shared edges
/// are computed from the whole edge, so that the surface stays watertight.

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
  bool IsOutside; ///< whether the position is outside of the image (Clamp), or too far away to wrap
};

/// Wrap a position in the plane of the image. Repeat and Mirror wrap up to a distance beyond which
/// an image cannot be resolved.
WrappedPlace wrapped(const Vector2& st, TextureWrap wrap);

/// Cut the triangles at the borders of the patches of the projection and of the image. Duplicate
/// points on these borders as often as needed.
/// @param[in,out] texture  with Image, Coordinates and OutsideImage of the vertices; kept for
///   vertices without triangles
void splitAtSeams(SphericalTexture& texture, const Triangles& triangles,
  const Points& spherePositions, TextureWrap wrap, const Run& run);
}

#endif
