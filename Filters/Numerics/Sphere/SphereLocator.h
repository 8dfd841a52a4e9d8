/// Finds the triangle of a map to the sphere that contains a direction.

#ifndef ConformalSphereLocator_h
#define ConformalSphereLocator_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Where the line from the sphere's center along a direction meets the flat triangles.
struct SphereLocation
{
  int Triangle = -1;                     ///< -1 if no triangle is near
  Vector3 Barycentric = Vector3::Zero(); ///< of p', \cite Liou2008 Eq. 9; >= 0, sum 1
};

/// Point location on the sphere, exact to the rounding of the positions, however small the
/// triangles are: conformal maps of long limbs shrink them to exp(-16) of their fair area.
///
/// The side of an edge on which a direction lies is computed from differences to the direction
/// and in one order of the edge's vertices, so the two triangles of an edge never disagree. Of
/// triangles that share the direction the lowest id is taken; where rounding at a vertex leaves
/// none, the one that misses it least.
///
/// A query costs about log(#R) and only reads, so many threads may ask at once.
class SphereLocator
{
public:
  SphereLocator() = default;

  /// @param[in] positions  #N by 3 unit vectors
  /// @param[in] triangles      #R by 3 ids, counter-clockwise seen from outside
  SphereLocator(const Points& positions, const Triangles& triangles, const Run& run = {});
  /// @param[in] neighbors  triangleNeighbors of the triangles, where they are at hand
  SphereLocator(const Points& positions, const Triangles& triangles, const Triangles& neighbors,
    const Run& run = {});

  /// @param[in] direction  p, a unit vector
  /// @param[in] hint       a triangle that may be near, or -1: saves time, and changes nothing
  ///                       where triangles do not overlap
  SphereLocation locate(const Vector3& direction, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 Positions[3];
    int Across[3] = { -1, -1, -1 }; // edge k, opposite to corner k: the place behind it,
    bool Ascending[3] = {};         // and whether it runs from its lower to its higher id
  };
  static double side(const Corners& corners, int opposite, const Vector3& direction);
  static Vector3 sidesOf(const Corners& corners, const Vector3& direction);
  int walk(int place, const Vector3& direction, Vector3& sides) const;
  int search(const Vector3& direction, Vector3& sides) const;
  template <typename Visit>
  void visitNear(const Vector3& direction, Visit visit) const;

  BoxTree Tree;
  std::vector<Corners> Placed; // of the triangle at each place of Tree.Items
  std::vector<int> PlaceOf;    // of each triangle
};
}

#endif
