/// Binary tree of bounding boxes, for closest-point and ray queries.

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
  /// 0 inside; infinite for an empty box.
  double squareDistance(const Vector3& x) const
  {
    return (this->Lower - x).cwiseMax(x - this->Upper).cwiseMax(0.0).squaredNorm();
  }
};

/// Nodes in depth-first order: the children of an inner node i are i + 1 and Nodes[i].Second;
/// the leaves' items lie side by side in Items.
struct BoxTree
{
  struct Node
  {
    Box Bounds;
    int Second = 0; ///< second child; unused in a leaf
    int First = 0;  ///< a leaf's first place in Items
    int Count = 0;  ///< a leaf's number of items; 0 in an inner node
  };

  std::vector<Node> Nodes;
  std::vector<int> Items;
};

/// Build by median splits of the items' box centers along the longest side. Depends on the boxes
/// only, so every run gives the same tree. O(n log n).
/// @throws Aborted
BoxTree buildBoxTree(const std::vector<Box>& boxes, const Run& run = {});
}

#endif
