/// Build a binary tree of bounding boxes, for closest-point and ray queries, \cite Ericson2005.

#ifndef ConformalBoxTree_h
#define ConformalBoxTree_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <limits>
#include <vector>

namespace conformal
{
/// Axis-aligned box, initially empty.
struct Box
{
  Vector3 Lower = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 Upper = Vector3::Constant(-std::numeric_limits<double>::infinity());

  void extend(const Vector3& x)
  {
    this->Lower = this->Lower.cwiseMin(x);
    this->Upper = this->Upper.cwiseMax(x);
  }
  void extend(const Box& box)
  {
    this->Lower = this->Lower.cwiseMin(box.Lower);
    this->Upper = this->Upper.cwiseMax(box.Upper);
  }
  /// Compute the square distance between a point and the box. The result is 0 inside the box, and
  /// infinite if the box is empty.
  double squareDistance(const Vector3& x) const
  {
    return (this->Lower - x).cwiseMax(x - this->Upper).cwiseMax(0.0).squaredNorm();
  }
};

/// Binary tree of boxes. Nodes are stored in depth-first order. The children of an inner node i are
/// i + 1 and Nodes[i].Second. An item is the index of a box from which the tree was built. The
/// items of a leaf are consecutive in Items.
struct BoxTree
{
  struct Node
  {
    Box Bounds;
    int Second = 0; ///< index of an inner node's second child; unused in a leaf
    int First = 0;  ///< index in Items of a leaf's first item
    int Count = 0;  ///< number of items of a leaf; 0 for an inner node
  };

  std::vector<Node> Nodes;
  std::vector<int> Items;
};

/// Build a tree of n boxes in O(n log n) operations. Each node is split along its longest side, at
/// the median of the centers of its boxes. The result depends only on the boxes, not on the number
/// of threads.
/// @throws Aborted
BoxTree buildBoxTree(const std::vector<Box>& boxes, const Run& run = {});
}

#endif
