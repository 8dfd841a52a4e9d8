/// Find the triangle of a sphere map that contains a direction. Own construction: tests by signs
/// that both triangles of an edge compute identically, because they leave no gaps even between tiny
/// triangles.

#ifndef ConformalSphereLocator_h
#define ConformalSphereLocator_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Intersection of a ray from the center of the sphere with a flat triangle.
struct SphereLocation
{
  int Triangle = -1; ///< id of the triangle, or -1 if no triangle is near
  /// Coordinates of p' in \cite Liou2008 Eq. 9; >= 0, with the sum 1
  Vector3 Barycentric = Vector3::Zero();
};

/// Point location on the sphere. For triangles of any size, it is exact up to the rounding of the
/// positions. Small triangles occur: conformal maps of long limbs can shrink areas by a factor of
/// exp(-16).
///
/// A sign states on which side of an edge a direction lies. It is computed from differences between
/// the vertices and the direction. Both triangles of an edge use the same order of its two
/// vertices, so their signs are consistent. If several triangles contain the direction, the one
/// with the smallest id is returned. If rounding at a vertex leaves no triangle, the triangle that
/// misses the direction by the smallest margin is returned.
///
/// The cost of a query is about logarithmic in #R. Several threads may query concurrently.
class SphereLocator
{
public:
  SphereLocator() = default;

  /// @param[in] positions  #N by 3 unit vectors
  /// @param[in] triangles  #R by 3 ids, counter-clockwise seen from outside
  SphereLocator(const Points& positions, const Triangles& triangles, const Run& run = {});
  /// Build a locator, given the neighbors of the triangles.
  /// @param[in] neighbors  result of triangleNeighbors() for these triangles
  SphereLocator(const Points& positions, const Triangles& triangles, const Triangles& neighbors,
    const Run& run = {});

  /// Find the triangle that contains a direction.
  /// @param[in] direction  direction p, a unit vector
  /// @param[in] hint       id of a triangle that may be near, or -1. A hint reduces the cost. It
  ///   changes the result only if triangles overlap.
  SphereLocation locate(const Vector3& direction, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 Positions[3];
    // Position in Tree.Items of the triangle across edge k, which is opposite to corner k
    int Across[3] = { -1, -1, -1 };
    bool Ascending[3] = {}; // whether edge k starts at its vertex with the lower id
  };
  static double side(const Corners& corners, int opposite, const Vector3& direction);
  static Vector3 sidesOf(const Corners& corners, const Vector3& direction);
  int walk(int place, const Vector3& direction, Vector3& sides) const;
  int search(const Vector3& direction, Vector3& sides) const;
  template <typename Visit>
  void visitNear(const Vector3& direction, Visit visit) const;

  BoxTree Tree;
  std::vector<Corners> Placed; // corners of the triangles in Tree.Items
  std::vector<int> PlaceOf;    // position of each triangle in Tree.Items
};
}

#endif
