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
/// Implementation note: Eq. 11 is completed in these cases. At a corner, where it is 0/0, the
/// quotient is 1 and the height 0. If the center's image lies beyond an end of the edge, a_q' is
/// the point where the perpendicular leaves the subtriangle opposite to the edge. Neighbors with
/// exactly opposite normals have no mean normal (Eq. 8), and each uses its own. A triangle of zero
/// area has no normal, and uses those of its neighbors at its edges.
class SphereDomes
{
public:
  SphereDomes() = default;

  /// Store pointers; all arguments but the map must outlive this.
  /// @param[in] sphere     #N by 3, n_i, unit vectors
  /// @param[in] model      #N by 3, w_i
  /// @param[in] triangles  #R by 3
  /// @param[in] neighbors  triangleNeighbors() of the triangles
  /// @param[in] map        p' -> q'
  /// @param[in] insideOut  whether the model's triangles are clockwise seen from outside
  SphereDomes(const Points& sphere, const Points& model, const conformal::Triangles& triangles,
    const conformal::Triangles& neighbors, const FlatMap& map, bool insideOut, const Run& run = {});

  /// Return |p - p'|, with p' in barycentric coordinates.
  double height(Index triangle, const Vector3& barycentric) const;

  /// Return n_q', with q' in barycentric coordinates.
  Vector3 direction(Index triangle, const Vector3& barycentric) const;

  /// Return the unit normal of a flat triangle, Eq. 7; zero if it has zero area.
  Vector3 normal(Index triangle) const { return this->Normals.row(triangle); }

  /// Return whether the triangle and its edges have normals.
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
