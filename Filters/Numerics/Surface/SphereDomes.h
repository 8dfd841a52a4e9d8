/// Domes over a flat model, \cite Liou2008 section 3, proportional to those of the unit sphere.

#ifndef ConformalSphereDomes_h
#define ConformalSphereDomes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/FlatMap.h"

namespace conformal
{
/// Directions and heights of domes, \cite Liou2008 Eqs. 6 to 8, 11 and 12.
///
/// Implementation note: where Eq. 11 leaves a choice. At a corner, 0/0, the quotient is 1; the
/// height is 0 there. If the center's image lies beyond an end of the edge, a_q' is the point
/// where the perpendicular leaves the subtriangle on the side away from the edge. Neighbors that
/// face exactly opposite ways have no mean normal (Eq. 8): each uses its own. A triangle without
/// area has no normal: it takes its neighbors' at its edges.
class SphereDomes
{
public:
  SphereDomes() = default;

  /// @param[in] sphere     #N by 3, n_i, unit vectors
  /// @param[in] model      #N by 3, w_i
  /// @param[in] triangles      #R by 3
  /// @param[in] neighbors  triangleNeighbors of the triangles
  /// @param[in] map        p' -> q'
  /// @param[in] insideOut  whether the model's triangles run clockwise seen from outside
  /// All but the map must outlive this.
  SphereDomes(const Points& sphere, const Points& model, const conformal::Triangles& triangles,
    const conformal::Triangles& neighbors, const FlatMap& map, bool insideOut, const Run& run = {});

  /// |p - p'|, with p' in barycentric coordinates.
  double height(Index triangle, const Vector3& barycentric) const;

  /// n_q', with q' in barycentric coordinates.
  Vector3 direction(Index triangle, const Vector3& barycentric) const;

  /// Unit normal of a flat triangle, Eq. 7; zero if it has no area.
  Vector3 normal(Index triangle) const { return this->Normals.row(triangle); }

  /// Whether the triangle and all mean normals of its edges have a direction.
  bool defined(Index triangle) const;

private:
  bool edgeDirection(Index triangle, int opposite, Vector3& direction) const;

  const Points* Sphere = nullptr;
  const Points* Model = nullptr;
  const conformal::Triangles* Triangles = nullptr;
  const conformal::Triangles* Neighbors = nullptr;
  Points Centers; // #R by 3, barycentric coordinates of c_w
  Points Normals; // #R by 3
};
}

#endif
