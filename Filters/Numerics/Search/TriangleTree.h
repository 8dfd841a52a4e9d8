/// Find the foot point of a query point: the closest point of a triangle mesh, \cite Ericson2005.

#ifndef ConformalTriangleTree_h
#define ConformalTriangleTree_h

#include "Base/Lanes.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <limits>
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

  /// After vertices moved, update the bounding boxes of the tree, in O(#F) operations.
  void refit(const Points& positions, const Run& run = {});

  /// Find the point of the mesh closest to x. If several triangles have the minimum distance, the
  /// one with the smallest id is returned. The distance is exact up to rounding.
  /// @param[in] x     query point
  /// @param[in] hint  id of a triangle that is probably close to x, or -1. A hint reduces the cost
  ///   and does not change the result.
  /// @return closest point. If the mesh has no triangles, its member Triangle is -1.
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  // Eight boxes, whose distances from a query point are computed together by SIMD instructions. The
  // boxes are descendants of a node of the binary tree. Bounds are floats in the tree's frame.
  struct Node
  {
    Floats Lower[3], Upper[3];
    int Code[FloatLanes]; ///< of each box: index in Nodes, or negative for a leaf
  };
  struct Branch;

  static Branch branchAt(const BoxTree& tree, int node);
  int addNode(const BoxTree& tree, int node, const Run& run);
  void refitLeaves(Node& node) const;
  void joinBoxes(Node& node) const;
  Vector3 inFrame(const Vector3& x) const { return (x - this->Center) * this->Scale; }
  void update(FootPoint& best, const Vector3& x, int place) const;

  std::vector<int> Items;   ///< ids of triangles in the sequence of the tree
  std::vector<Node> Nodes;  ///< nodes of the tree; a parent precedes its children
  Points Positions;         ///< copy of the vertices, which is kept in the cache during queries
  Triangles Corners;        ///< of the triangles in Items
  std::vector<int> PlaceOf; ///< index in Items of each triangle
  Vector3 Center = Vector3::Zero(); ///< origin of the frame
  double Scale = 1.0;               ///< factor from coordinates to the frame, the cube [-1, 1]^3
};
}

#endif
