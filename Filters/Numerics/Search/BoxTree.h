/// Binary tree of bounding boxes, for closest-point and ray queries, \cite Ericson2005.

#ifndef ConformalBoxTree_h
#define ConformalBoxTree_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <limits>
#include <vector>

namespace conformal
{
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
  /// Compute the square distance of a point from the box. It is 0 inside the box, and infinite for
  /// an empty box.
  double squareDistance(const Vector3& x) const
  {
    return (this->Lower - x).cwiseMax(x - this->Upper).cwiseMax(0.0).squaredNorm();
  }
};

/// Binary tree with nodes in depth-first order. The children of an inner node i are i + 1 and
/// Nodes[i].Second. The items of a leaf are consecutive in Items.
struct BoxTree
{
  struct Node
  {
    Box Bounds;
    int Second = 0; ///< index of the second child; unused in a leaf
    int First = 0;  ///< position of a leaf's first item in Items
    int Count = 0;  ///< number of items of a leaf; 0 for an inner node
  };

  std::vector<Node> Nodes;
  std::vector<int> Items;
};

/// Build a tree of n boxes in O(n log n) operations. Each node is split at the median of the boxes'
/// centers along its longest side. The tree depends only on the boxes, so every run builds the same
/// tree.
/// @throws Aborted
BoxTree buildBoxTree(const std::vector<Box>& boxes, const Run& run = {});
}

#endif
