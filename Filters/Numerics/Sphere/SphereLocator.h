/// Find the triangle of a sphere map (triangle mesh on the unit sphere) that contains a direction.
/// The test on which side of an edge a direction is, is our own construction. The test computes the
/// same number for both triangles of the edge. A direction near the edge is therefore never outside
/// of both triangles, even if the triangles are tiny.

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
  int Triangle = -1; ///< id of the triangle, or -1 if no triangle is near the direction
  /// Barycentric coordinates of the intersection, called p' in \cite Liou2008 Eq. 9; >= 0, with the
  /// sum 1
  Vector3 Barycentric = Vector3::Zero();
};

/// Search structure for the triangle that contains a direction. For triangles of any size, results
/// are exact up to the rounding of the positions. Very small triangles are common. For example, a
/// conformal map of a long limb, such as a leg, can multiply areas by exp(-16).
///
/// The sign of a determinant determines on which side of an edge a direction is. The determinant is
/// computed from the differences of the edge's two vertices from the direction. For both triangles
/// of an edge, the vertices are used in the same sequence. The two signs are therefore consistent.
/// If several triangles contain the direction, the one with the smallest id is returned. Near a
/// vertex, the test may fail for all triangles, because of rounding. In this case, the triangle
/// that misses the direction by the smallest amount is returned.
///
/// The cost of a query is about logarithmic in the number of triangles, also among the long and
/// narrow triangles around a vertex that many triangles share: boxes of such triangles overlap, but
/// slabs between two planes through them do not. Several threads may query concurrently.
class SphereLocator
{
public:
  SphereLocator() = default;

  /// @param[in] positions  #N by 3 unit vectors
  /// @param[in] triangles  #R by 3 ids, counter-clockwise seen from outside
  SphereLocator(const Points& positions, const Triangles& triangles, const Run& run = {});
  /// Build a locator, if the neighbors of the triangles are already computed.
  /// @param[in] neighbors  result of triangleNeighbors() for these triangles
  SphereLocator(const Points& positions, const Triangles& triangles, const Triangles& neighbors,
    const Run& run = {});

  /// Find the triangle that contains a direction.
  /// @param[in] direction  direction p, a unit vector
  /// @param[in] hint       id of a triangle that may be near, or -1. A hint reduces the cost. If no
  ///   triangles overlap, a hint does not change the result.
  SphereLocation locate(const Vector3& direction, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 Positions[3];
    // place in Tree.Items of the triangle across each edge k; edge k is opposite corner k
    int Across[3] = { -1, -1, -1 };
    bool Ascending[3] = {}; // whether each edge k starts at its vertex with the lower id
  };
  // Space between two parallel planes that contains a node's directions.
  struct Slab
  {
    Vector3 Normal = Vector3::Zero();
    double Lower = 0.0, Upper = 0.0;
  };
  static double side(const Corners& corners, int opposite, const Vector3& direction);
  static Vector3 sidesOf(const Corners& corners, const Vector3& direction);
  int walk(int place, const Vector3& direction, Vector3& sides) const;
  int search(const Vector3& direction, Vector3& sides) const;
  template <typename Wanted, typename Visit>
  void visitNear(const Vector3& direction, Wanted wanted, Visit visit) const;
  void orderNodes();
  void addSlab(int node, int first, int end, const Vector3& normal);
  bool isInSlab(int node, const Vector3& direction) const;

  BoxTree Tree;                // search tree; Tree.Items are triangle ids, sorted by position
  std::vector<Corners> Placed; // corners of the triangles in Tree.Items
  std::vector<int> PlaceOf;    // index in Tree.Items of each triangle
  std::vector<int> LowestOf;   // lowest id of a triangle in each node
  std::vector<int> SlabOf;     // index in Slabs for each node, or -1: few nodes are narrow
  std::vector<Slab> Slabs;
};
}

#endif
