/// Find the triangle of a sphere map that contains a direction. Own construction: signs of edges
/// that both triangles evaluate identically leave no gaps, even between tiny triangles.

#ifndef ConformalSphereLocator_h
#define ConformalSphereLocator_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Intersection of a ray from the center of the sphere with the flat triangles.
struct SphereLocation
{
  int Triangle = -1;                     ///< -1 if no triangle is near
  Vector3 Barycentric = Vector3::Zero(); ///< p' of \cite Liou2008 Eq. 9; >= 0, sum 1
};

/// Point location on the sphere, exact up to the rounding of the positions for triangles of any
/// size. Conformal maps of long limbs shrink triangles to exp(-16) of their share of the area.
///
/// The orientation of a direction relative to an edge is computed from differences to the
/// direction. Both triangles of an edge use one order of its vertices, so their signs are
/// consistent. Of several triangles that contain the direction, the one of smallest id is returned.
/// If rounding at a vertex leaves none, the triangle missed by the smallest margin is returned.
///
/// A query costs about log(#R) and only reads, so several threads may query concurrently.
class SphereLocator
{
public:
  SphereLocator() = default;

  /// @param[in] positions  #N by 3 unit vectors
  /// @param[in] triangles  #R by 3 ids, counter-clockwise seen from outside
  SphereLocator(const Points& positions, const Triangles& triangles, const Run& run = {});
  /// Build a locator, given the neighbors of the triangles.
  /// @param[in] neighbors  triangleNeighbors() of the triangles
  SphereLocator(const Points& positions, const Triangles& triangles, const Triangles& neighbors,
    const Run& run = {});

  /// Find the triangle that contains a direction.
  /// @param[in] direction  p, a unit vector
  /// @param[in] hint       a triangle that may be near, or -1: reduces the cost, and does not
  ///   change the result unless triangles overlap
  SphereLocation locate(const Vector3& direction, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 Positions[3];
    // Edge k is opposite to corner k: position in Tree.Items of the triangle across.
    int Across[3] = { -1, -1, -1 };
    bool Ascending[3] = {}; // whether the edge runs from its lower to its higher id
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
