#include "Search/BoxTree.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace conformal
{
namespace
{
constexpr int LeafSize = 2;
constexpr int RangeSize = 2048; // maximum number of items of a branch that is built by one thread

/// Sort key of an item, stored with its id.
struct Center
{
  Vector3 At; // twice the center of the box, which sorts like the center
  int Item;
};

/// Range of consecutive items, and its node.
struct Range
{
  int First, Last, Node;

  int size() const { return this->Last - this->First; }
};

/// Numbers of nodes over n and n + 1 items. Halves differ by at most one item.
std::pair<int, int> numbersOfNodes(int n)
{
  if (n <= 1)
  {
    return { 1, 1 };
  }
  const auto [half, more] = numbersOfNodes(n / 2);
  const int even = 1 + 2 * half, odd = 1 + half + more;
  return n % 2 == 0 ? std::make_pair(n <= LeafSize ? 1 : even, odd)
                    : std::make_pair(odd, 1 + 2 * more);
}

/// Find the first item of the upper half by the position along the longest side, and partition the
/// items.
int halve(std::vector<Center>& centers, const Range& range)
{
  Vector3 lower = centers[range.First].At, upper = lower;
  for (int i = range.First + 1; i < range.Last; ++i)
  {
    lower = lower.cwiseMin(centers[i].At);
    upper = upper.cwiseMax(centers[i].At);
  }
  int axis = 0;
  (upper - lower).maxCoeff(&axis);
  const int middle = range.First + range.size() / 2;
  std::nth_element(centers.begin() + range.First, centers.begin() + middle,
    centers.begin() + range.Last,
    [axis](const Center& a, const Center& b)
    { return a.At[axis] < b.At[axis] || (a.At[axis] == b.At[axis] && a.Item < b.Item); });
  return middle;
}

/// Return the two halves of a range.
std::pair<Range, Range> split(BoxTree& tree, std::vector<Center>& centers, const Range& range)
{
  const int middle = halve(centers, range);
  const int first = range.Node + 1, second = first + numbersOfNodes(middle - range.First).first;
  tree.Nodes[range.Node].Second = second;
  return { { range.First, middle, first }, { middle, range.Last, second } };
}

void joinBounds(BoxTree& tree, int node)
{
  Box& bounds = tree.Nodes[node].Bounds;
  bounds = tree.Nodes[node + 1].Bounds;
  bounds.extend(tree.Nodes[tree.Nodes[node].Second].Bounds);
}

/// @return the node after all nodes of the range
int build(
  BoxTree& tree, std::vector<Center>& centers, const std::vector<Box>& boxes, const Range& range)
{
  BoxTree::Node& node = tree.Nodes[range.Node];
  if (range.size() <= LeafSize)
  {
    node.First = range.First;
    node.Count = range.size();
    for (int i = range.First; i < range.Last; ++i)
    {
      tree.Items[i] = centers[i].Item;
      node.Bounds.extend(boxes[centers[i].Item]);
    }
    return range.Node + 1;
  }
  const int middle = halve(centers, range);
  node.Second = build(tree, centers, boxes, { range.First, middle, range.Node + 1 });
  const int next = build(tree, centers, boxes, { middle, range.Last, node.Second });
  joinBounds(tree, range.Node);
  return next;
}
}

BoxTree buildBoxTree(const std::vector<Box>& boxes, const Run& run)
{
  BoxTree tree;
  const int size = static_cast<int>(boxes.size());
  if (size == 0)
  {
    return tree;
  }
  tree.Items.resize(size);
  tree.Nodes.resize(numbersOfNodes(size).first);
  std::vector<Center> centers(size);
  for (int i = 0; i < size; ++i)
  {
    centers[i] = { boxes[i].Lower + boxes[i].Upper, i };
  }

  // Split level by level while ranges are large. Ranges of one level differ by at most one item.
  const double numberOfLevels = std::log2(size) + 1.0;
  double level = 0.0;
  std::vector<Range> ranges{ { 0, size, 0 } };
  std::vector<int> nodes;
  while (ranges.front().size() > RangeSize)
  {
    std::vector<Range> halves(2 * ranges.size());
    forBlocksReporting(run.part(level / numberOfLevels, (level + 1.0) / numberOfLevels),
      static_cast<Index>(ranges.size()), 1,
      [&](Index i, Index)
      { std::tie(halves[2 * i], halves[2 * i + 1]) = split(tree, centers, ranges[i]); });
    for (const Range& range : ranges)
    {
      nodes.push_back(range.Node);
    }
    ranges.swap(halves);
    ++level;
  }
  forBlocksReporting(run.part(level / numberOfLevels, 1.0), static_cast<Index>(ranges.size()), 1,
    [&](Index i, Index) { build(tree, centers, boxes, ranges[i]); });
  std::for_each(nodes.rbegin(), nodes.rend(), [&](int node) { joinBounds(tree, node); });
  return tree;
}
}
