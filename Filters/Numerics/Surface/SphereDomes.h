/// Domes over the flat triangles of a model, proportional to the domes of the unit sphere over the
/// triangles of the network, \cite Liou2008 section 3.

#ifndef ConformalSphereDomes_h
#define ConformalSphereDomes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/FlatMap.h"

namespace conformal
{
/// Directions and heights of the domes, \cite Liou2008 Eqs. 6 to 8, 11 and 12.
///
/// Implementation note: the equations are completed in these cases. At a corner, where the quotient
/// of Eq. 11 is 0/0, the quotient is 1 and the height 0. If the center's image lies beyond an end
/// of the edge, a_q' is the point where the perpendicular leaves the subtriangle opposite to the
/// edge. Neighbors with exactly opposite normals have no mean normal (Eq. 8); each uses its own
/// normal. A triangle of zero area has no normal; at its edges, it uses the normals of its
/// neighbors.
class SphereDomes
{
public:
  SphereDomes() = default;

  /// Store pointers to the arguments. All arguments but the map must outlive this object.
  /// @param[in] sphere     #N by 3, unit vectors n_i
  /// @param[in] model      #N by 3, positions w_i
  /// @param[in] triangles  #R by 3
  /// @param[in] neighbors  triangleNeighbors() of the triangles
  /// @param[in] map        map p' -> q' between the flat triangles
  /// @param[in] insideOut  whether the model's triangles are clockwise seen from outside
  SphereDomes(const Points& sphere, const Points& model, const conformal::Triangles& triangles,
    const conformal::Triangles& neighbors, const FlatMap& map, bool insideOut, const Run& run = {});

  /// Return the height |p - p'| of the sphere over a point p', given in barycentric coordinates.
  double height(Index triangle, const Vector3& barycentric) const;

  /// Return the direction n_q' of the dome at a point q', given in barycentric coordinates.
  Vector3 direction(Index triangle, const Vector3& barycentric) const;

  /// Return the unit normal of a flat triangle of the model, Eq. 7; zero for zero area.
  Vector3 normal(Index triangle) const { return this->Normals.row(triangle); }

  /// Return whether a triangle and its edges have normals.
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
