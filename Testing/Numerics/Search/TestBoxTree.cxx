#include "Runs.h"
#include "Search/BoxTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

using conformal::Box;
using conformal::BoxTree;
using conformal::buildBoxTree;
using conformal::Index;
using conformal::Vector3;

namespace
{
/// Small boxes in a cube, many with the same center.
std::vector<Box> boxes(int count)
{
  std::mt19937 random(count);
  std::uniform_int_distribution<int> place(0, 40), size(1, 3);
  std::vector<Box> result(count);
  for (Box& box : result)
  {
    const Vector3 center(place(random), place(random), place(random));
    box.extend(Vector3(center.array() - size(random)));
    box.extend(Vector3(center.array() + size(random)));
  }
  return result;
}

/// Follows a branch, of which it expects tight bounds.
/// @return the node after it
int follow(const BoxTree& tree, const std::vector<Box>& boxes, int index, std::vector<int>& items)
{
  const BoxTree::Node& node = tree.Nodes[index];
  Box bounds;
  int next = index + 1;
  if (node.Count > 0)
  {
    for (int place = node.First; place < node.First + node.Count; ++place)
    {
      items.push_back(tree.Items[place]);
      bounds.extend(boxes[tree.Items[place]]);
    }
  }
  else
  {
    next = follow(tree, boxes, next, items);
    EXPECT_EQ(node.Second, next);
    next = follow(tree, boxes, next, items);
    bounds.extend(tree.Nodes[index + 1].Bounds);
    bounds.extend(tree.Nodes[node.Second].Bounds);
  }
  EXPECT_EQ(bounds.Lower, node.Bounds.Lower);
  EXPECT_EQ(bounds.Upper, node.Bounds.Upper);
  return next;
}
}

// Sizes below and above that of the branches that threads take.
TEST(BoxTree, HoldsEveryItemOnceInTightBounds)
{
  for (const int count : { 1, 2, 3, 5, 100, 2048, 2049, 4097, 10007, 30000 })
  {
    const std::vector<Box> all = boxes(count);
    const BoxTree tree = buildBoxTree(all);
    std::vector<int> items;
    EXPECT_EQ(follow(tree, all, 0, items), static_cast<int>(tree.Nodes.size())) << count;
    EXPECT_EQ(items, tree.Items) << count;
    std::sort(items.begin(), items.end());
    std::vector<int> expected(count);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(items, expected) << count;
  }
}

TEST(BoxTree, DoesNotDependOnTheOrderOfThreads)
{
  const std::vector<Box> all = boxes(20000);
  const BoxTree tree = buildBoxTree(all), again = buildBoxTree(all, runs::backwards());
  EXPECT_EQ(again.Items, tree.Items);
  ASSERT_EQ(again.Nodes.size(), tree.Nodes.size());
  for (std::size_t i = 0; i < tree.Nodes.size(); ++i)
  {
    EXPECT_EQ(again.Nodes[i].Second, tree.Nodes[i].Second);
    EXPECT_EQ(again.Nodes[i].First, tree.Nodes[i].First);
  }
}

TEST(BoxTree, OfNothingIsEmpty)
{
  EXPECT_TRUE(buildBoxTree({}).Nodes.empty());
}

TEST(BoxTree, ReportsForwardsAndStopsWhenAsked)
{
  const std::vector<Box> all = boxes(30000);
  runs::Watch watch;
  buildBoxTree(all, watch.run());
  EXPECT_NEAR(watch.last(), 1.0, 1e-12);
  EXPECT_THROW(buildBoxTree(all, runs::stoppingAt(0.0)), conformal::Aborted);
}
