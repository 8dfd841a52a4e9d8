/// Closest point (foot point) of a triangle mesh, \cite Ericson2005.

#ifndef ConformalTriangleTree_h
#define ConformalTriangleTree_h

#include "Base/Lanes.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Closest point of a mesh: its triangle, barycentric coordinates, position and distance.
struct FootPoint
{
  int Triangle = -1;
  Vector3 Barycentric = Vector3::Zero(); ///< of the closest point in its triangle; >= 0, sum 1
  Vector3 Position = Vector3::Zero();
  double SquareDistance = std::numeric_limits<double>::infinity();
};

/// Compute the closest point of the triangle a, b, c. Degenerate triangles count as segments or
/// points. The field Triangle is -1.
FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Exact closest points of a mesh that may move.
///
/// A query costs about log(#F) and only reads, so several threads may query concurrently.
class TriangleTree
{
public:
  TriangleTree() = default;

  /// @param[in] positions  #V by 3, finite
  /// @param[in] triangles      #F by 3 ids
  /// @throws Aborted
  TriangleTree(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Update the boxes after vertices moved; the triangles must be the same. O(#F).
  void refit(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Find the closest point of the mesh; of triangles at equal distance, the smallest id.
  /// @param[in] x     a point; distances are exact up to rounding
  /// @param[in] hint  a triangle that may be close: reduces the cost, never changes the result
  /// @return Triangle -1 for a mesh without triangles
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 A, B, C;
  };
  // Four boxes, grandchildren of a node of the binary tree, tested with SIMD instructions.
  struct Quad
  {
    Doubles Lower[3], Upper[3];
    int Next[DoubleLanes];  ///< child quad; -1 for a leaf and without a box
    int First[DoubleLanes]; ///< leaf: position of its first triangle in Items
    int Count[DoubleLanes]; ///< leaf: number of triangles, else 0
  };
  int addQuad(const BoxTree& tree, int node, const Run& run);
  Box boxOf(const Quad& quad, int lane) const;
  void update(FootPoint& best, const Vector3& x, int place) const;
  static void measure(const Quad& quad, const double* x, double* distances);

  std::vector<int> Items;      ///< triangles in the order of the tree
  std::vector<Quad> Quads;     ///< each before its children
  std::vector<Corners> Placed; ///< corners of the triangles in Items
  std::vector<int> PlaceOf;    ///< position of each triangle in Items
};
}

#endif
