/// Binary tree of bounding boxes for closest-point and ray queries, \cite Ericson2005.

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
  /// Compute the square distance of a point from the box: 0 inside, infinite for an empty box.
  double squareDistance(const Vector3& x) const
  {
    return (this->Lower - x).cwiseMax(x - this->Upper).cwiseMax(0.0).squaredNorm();
  }
};

/// Nodes in depth-first order: the children of an inner node i are i + 1 and Nodes[i].Second. The
/// items of a leaf are consecutive in Items.
struct BoxTree
{
  struct Node
  {
    Box Bounds;
    int Second = 0; ///< second child; unused in a leaf
    int First = 0;  ///< leaf: position of its first item in Items
    int Count = 0;  ///< leaf: number of items; 0 in an inner node
  };

  std::vector<Node> Nodes;
  std::vector<int> Items;
};

/// Build a tree by median splits of the centers of the boxes along the longest side. The tree
/// depends only on the boxes, so every run gives the same one. O(n log n).
/// @throws Aborted
BoxTree buildBoxTree(const std::vector<Box>& boxes, const Run& run = {});
}

#endif
