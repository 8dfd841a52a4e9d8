/// Find the closest point of a triangle mesh, called foot point, \cite Ericson2005.

#ifndef ConformalTriangleTree_h
#define ConformalTriangleTree_h

#include "Base/Lanes.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Closest point of a mesh: its triangle, barycentric coordinates, position and square distance.
struct FootPoint
{
  int Triangle = -1;
  /// Coordinates of the closest point in its triangle; >= 0, with the sum 1
  Vector3 Barycentric = Vector3::Zero();
  Vector3 Position = Vector3::Zero();
  double SquareDistance = std::numeric_limits<double>::infinity();
};

/// Compute the point of the triangle a, b, c that is closest to x. Degenerate triangles count as
/// segments or points. The member Triangle of the result is -1.
FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Tree that finds exact closest points of a mesh whose vertices may move.
///
/// The cost of a query is about logarithmic in #F. Several threads may query concurrently.
class TriangleTree
{
public:
  TriangleTree() = default;

  /// @param[in] positions  #V by 3 coordinates, finite
  /// @param[in] triangles      #F by 3 ids
  /// @throws Aborted
  TriangleTree(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Update the boxes after vertices moved, in O(#F) operations. The triangles must be the same as
  /// before.
  void refit(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Find the point of the mesh closest to x. Of triangles at equal distance, the smallest id is
  /// returned. The distance is exact up to rounding.
  /// @param[in] x     query point
  /// @param[in] hint  id of a triangle that may be close, or -1; a hint reduces the cost and never
  ///   changes the result
  /// @return closest point; its member Triangle is -1 if the mesh has no triangles
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 A, B, C;
  };
  // Four boxes that are tested together with SIMD instructions: the grandchildren of a node of the
  // binary tree.
  struct Quad
  {
    Doubles Lower[3], Upper[3];
    int Next[DoubleLanes];  ///< index of the child quad; -1 for a leaf or an unused box
    int First[DoubleLanes]; ///< position of a leaf's first triangle in Items
    int Count[DoubleLanes]; ///< number of triangles of a leaf; 0 otherwise
  };
  int addQuad(const BoxTree& tree, int node, const Run& run);
  Box boxOf(const Quad& quad, int lane) const;
  void update(FootPoint& best, const Vector3& x, int place) const;
  static void measure(const Quad& quad, const double* x, double* distances);

  std::vector<int> Items;      ///< triangles in the order of the tree
  std::vector<Quad> Quads;     ///< quads; each comes before its children
  std::vector<Corners> Placed; ///< corners of the triangles in Items
  std::vector<int> PlaceOf;    ///< position of each triangle in Items
};
}

#endif
