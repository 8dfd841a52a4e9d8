#include "BoxTree.h"

#include <algorithm>
#include <numeric>

namespace conformal
{
namespace
{
constexpr int LeafSize = 2;

void split(
  BoxTree& tree, const std::vector<Box>& boxes, int first, int last, const Progress& progress)
{
  const int self = static_cast<int>(tree.Nodes.size());
  tree.Nodes.emplace_back();
  Box bounds, centers;
  for (int i = first; i < last; ++i)
  {
    const Box& box = boxes[tree.Items[i]];
    bounds.extend(box);
    centers.extend(Vector3(0.5 * (box.Lower + box.Upper)));
  }
  tree.Nodes[self].Bounds = bounds;
  if (last - first <= LeafSize)
  {
    tree.Nodes[self].First = first;
    tree.Nodes[self].Count = last - first;
    constexpr int Often = 16384; // items between reports
    if (first / Often != last / Often)
    {
      report(progress, static_cast<double>(last) / static_cast<double>(boxes.size()));
    }
    return;
  }
  int axis = 0;
  (centers.Upper - centers.Lower).maxCoeff(&axis);
  const int middle = first + (last - first) / 2;
  const auto center = [&](int item) { return boxes[item].Lower[axis] + boxes[item].Upper[axis]; };
  std::nth_element(tree.Items.begin() + first, tree.Items.begin() + middle,
    tree.Items.begin() + last,
    [&](int a, int b)
    {
      const double ca = center(a), cb = center(b);
      return ca < cb || (ca == cb && a < b);
    });
  split(tree, boxes, first, middle, progress);
  tree.Nodes[self].Second = static_cast<int>(tree.Nodes.size());
  split(tree, boxes, middle, last, progress);
}
}

BoxTree buildBoxTree(const std::vector<Box>& boxes, const Progress& progress)
{
  BoxTree tree;
  tree.Items.resize(boxes.size());
  std::iota(tree.Items.begin(), tree.Items.end(), 0);
  if (!boxes.empty())
  {
    tree.Nodes.reserve(boxes.size());
    split(tree, boxes, 0, static_cast<int>(boxes.size()), progress);
  }
  return tree;
}
}
