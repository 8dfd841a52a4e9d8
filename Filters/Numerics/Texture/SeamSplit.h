/// Cut surfaces along the seams of an image of the sphere, the lines where the image is
/// discontinuous. The method is an own construction, not from a publication. A point where an edge
/// is cut is computed from the two ends of the original edge. Both triangles at the edge thus get
/// the same point, so that the surface has no gaps.

#ifndef ConformalSeamSplit_h
#define ConformalSeamSplit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/TextureLayout.h"

namespace conformal
{
/// Result of wrapped(): texture coordinates after wrapping.
struct WrappedPlace
{
  Vector2 Coordinates;
  /// With TextureWrap::Clamp, true if the position is outside of the image. Otherwise, true if the
  /// position is too far from the image to be wrapped.
  bool IsOutside;
};

/// Wrap a position in the plane of the image. A position outside of the image is replaced as
/// TextureWrap specifies: the border of the image is extended, or the image is repeated or
/// mirrored. TextureWrap::Repeat and Mirror wrap positions only up to a maximum distance. Beyond
/// this distance, texture coordinates in single precision would be too coarse to distinguish the
/// pixels of an image.
WrappedPlace wrapped(const Vector2& st, TextureWrap wrap);

/// Cut the triangles along the border of the image, and along the borders between the parts of its
/// projection (SpherePatch). If a point on a border has different texture coordinates on both
/// sides, the point is duplicated.
/// @param[in,out] texture  texture of the uncut surface: Image, and the Coordinates and
///   OutsideImage of all vertices. The function adds SplitTriangles, TriangleIds and AddedPlaces.
///   It appends the values of added points to Coordinates and OutsideImage. Vertices without
///   triangles keep their values.
void splitAtSeams(SphericalTexture& texture, const Triangles& triangles,
  const Points& spherePositions, TextureWrap wrap, const Run& run);
}

#endif
