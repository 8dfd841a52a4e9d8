/// Find the foot point of a query point: the closest point of a triangle mesh, \cite Ericson2005.

#ifndef ConformalTriangleTree_h
#define ConformalTriangleTree_h

#include "Base/Lanes.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// Point of a mesh that is closest to a query point, and its square distance from the query point.
struct FootPoint
{
  int Triangle = -1;
  /// Barycentric coordinates in the triangle; >= 0, with the sum 1
  Vector3 Barycentric = Vector3::Zero();
  Vector3 Position = Vector3::Zero();
  double SquareDistance = std::numeric_limits<double>::infinity();
};

/// Compute the point of the triangle a, b, c that is closest to x. The triangle can be degenerate,
/// that is, a segment or a point. The member Triangle of the result is not set (-1).
FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Tree that finds exact closest points of a mesh. The vertices of the mesh can move, see refit().
///
/// The cost of a query is about logarithmic in the number of triangles. Several threads can query
/// concurrently.
class TriangleTree
{
public:
  TriangleTree() = default;

  /// @param[in] positions  #V by 3 coordinates, finite
  /// @param[in] triangles      #F by 3 ids
  /// @throws Aborted
  TriangleTree(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// After vertices moved, update the bounding boxes of the tree, in O(#F) operations. Pass the
  /// triangles from which the tree was built.
  void refit(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// Find the point of the mesh closest to x. If several triangles have the minimum distance, the
  /// one with the smallest id is returned. The distance is exact up to rounding.
  /// @param[in] x     query point
  /// @param[in] hint  id of a triangle that is probably close to x, or -1. A hint reduces the cost
  ///   and does not change the result.
  /// @return closest point. If the mesh has no triangles, its member Triangle is -1.
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 A, B, C;
  };
  // Four boxes, whose distances from a query point are computed together by SIMD instructions. The
  // boxes are the grandchildren of a node of the binary tree.
  struct Quad
  {
    Doubles Lower[3], Upper[3];
    /// Index in Quads of the child of each box; -1 for a leaf or an unused box
    int Next[DoubleLanes];
    int First[DoubleLanes]; ///< index in Items of a leaf's first triangle
    int Count[DoubleLanes]; ///< number of triangles of a leaf; 0 otherwise
  };
  int addQuad(const BoxTree& tree, int node, const Run& run);
  Box boxOf(const Quad& quad, int lane) const;
  void update(FootPoint& best, const Vector3& x, int place) const;
  static void measure(const Quad& quad, const double* x, double* distances);

  std::vector<int> Items;      ///< ids of triangles in the sequence of the tree
  std::vector<Quad> Quads;     ///< nodes of the tree; a parent precedes its children
  std::vector<Corners> Placed; ///< corners of the triangles in Items
  std::vector<int> PlaceOf;    ///< index in Items of each triangle
};
}

#endif
