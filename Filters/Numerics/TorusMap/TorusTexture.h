/// Compute texture coordinates from a map to a flat torus. Own construction: the surface is divided
/// along edges only, since an image that is repeated has no border at which triangles must be cut.

#ifndef ConformalTorusTexture_h
#define ConformalTorusTexture_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TorusMap/FlatTorus.h"

#include <array>
#include <vector>

namespace conformal
{
/// Texture coordinates of a surface that was divided along edges.
struct TorusTexture
{
  conformal::Triangles Triangles; ///< #F by 3 ids of points of the divided surface
  /// For each point of the divided surface, its vertex. The vertices come first, in their sequence;
  /// copies follow.
  std::vector<int> VertexIds;
  /// Texture coordinates of the points, with one copy of the image for each unit. The coordinates
  /// of a triangle are continuous.
  TorusPositions Coordinates;
};

/// Compute texture coordinates. The image is repeated along both periods of the torus. A vertex is
/// duplicated if its triangles are on different sides of a border of [0, 1)^2.
///
/// Only the positions of the vertices are known, not those of the edges. The corners of a triangle
/// are assumed to be less than half a period apart. The result is checked: the triangles must cover
/// the torus once.
/// @param[in] positions  #V by 2 finite fractions of the periods
/// @param[in] triangles  closed surface
/// @param[in] repeats  numbers of copies of the image along both periods, at least 1
/// @throws std::invalid_argument if the triangles do not cover the torus once, or a number is out
///   of range or not finite
TorusTexture makeTorusTexture(const TorusPositions& positions, const Triangles& triangles,
  const std::array<int, 2>& repeats, const Run& run = {});
}

#endif
