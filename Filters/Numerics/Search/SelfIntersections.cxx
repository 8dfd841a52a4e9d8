#include "Search/SelfIntersections.h"

#include "Search/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace conformal
{
namespace
{
bool overlap(const Box& a, const Box& b)
{
  return (a.Lower.array() <= b.Upper.array()).all() && (b.Lower.array() <= a.Upper.array()).all();
}

/// Six times the volume of the tetrahedron a, b, c, d.
double volume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

using Corners = std::array<Vector3, 3>;

/// Test whether the segment p, q passes through the interior of a triangle.
bool pierces(const Vector3& p, const Vector3& q, const Corners& t)
{
  if (volume(t[0], t[1], t[2], p) * volume(t[0], t[1], t[2], q) >= 0.0)
  {
    return false;
  }
  const double a = volume(p, q, t[0], t[1]), b = volume(p, q, t[1], t[2]),
               c = volume(p, q, t[2], t[0]);
  return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
}

bool cross(const Corners& a, const Corners& b)
{
  for (int k = 0; k < 3; ++k)
  {
    if (pierces(a[k], a[next(k)], b) || pierces(b[k], b[next(k)], a))
    {
      return true;
    }
  }
  return false;
}

/// Pairs that include a triangle of a tree.
class Search
{
public:
  Search(const Points& positions, const Triangles& triangles, const std::vector<int>& inTree,
    const Run& run)
    : Positions(positions)
    , Ids(triangles)
    , InTree(inTree)
    , IsInTree(triangles.rows(), 0)
  {
    std::vector<Box> boxes(inTree.size());
    for (const int triangle : inTree)
    {
      this->IsInTree[triangle] = 1;
    }
    forBlocks(run, static_cast<Index>(inTree.size()), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          boxes[i] = this->boxOf(inTree[i]);
        }
      });
    this->Tree = buildBoxTree(boxes, run.unwatched());
  }

  /// Append the pairs of a triangle with triangles of the tree. A pair whose triangles are both in
  /// the tree is appended for the triangle of smaller id.
  void find(int triangle, std::vector<std::array<int, 2>>& pairs, std::vector<int>& open) const
  {
    const Box box = this->boxOf(triangle);
    open.assign(1, 0);
    while (!open.empty())
    {
      const int at = open.back();
      open.pop_back();
      const BoxTree::Node& node = this->Tree.Nodes[at];
      if (!overlap(node.Bounds, box))
      {
        continue;
      }
      if (node.Count == 0)
      {
        open.push_back(at + 1);
        open.push_back(node.Second);
        continue;
      }
      for (int i = node.First; i < node.First + node.Count; ++i)
      {
        const int other = this->InTree[this->Tree.Items[i]];
        const bool isCounted = other > triangle || !this->IsInTree[triangle];
        if (isCounted && overlap(this->boxOf(other), box) && !this->touch(triangle, other) &&
          cross(this->cornersOf(triangle), this->cornersOf(other)))
        {
          pairs.push_back({ std::min(triangle, other), std::max(triangle, other) });
        }
      }
    }
  }

private:
  bool touch(int a, int b) const
  {
    for (int k = 0; k < 3; ++k)
    {
      for (int m = 0; m < 3; ++m)
      {
        if (this->Ids(a, k) == this->Ids(b, m))
        {
          return true;
        }
      }
    }
    return false;
  }

  Box boxOf(int triangle) const
  {
    Box box;
    for (int k = 0; k < 3; ++k)
    {
      box.extend(Vector3(this->Positions.row(this->Ids(triangle, k))));
    }
    return box;
  }

  Corners cornersOf(int triangle) const
  {
    return { this->Positions.row(this->Ids(triangle, 0)),
      this->Positions.row(this->Ids(triangle, 1)), this->Positions.row(this->Ids(triangle, 2)) };
  }

  const Points& Positions;
  const Triangles& Ids;
  const std::vector<int>& InTree;
  std::vector<char> IsInTree;
  BoxTree Tree;
};
}

//------------------------------------------------------------------------------
std::vector<std::array<int, 2>> selfIntersections(const Points& positions,
  const Triangles& triangles, const std::vector<int>& chosen, const Run& run)
{
  std::vector<std::array<int, 2>> all;
  if (chosen.empty())
  {
    return all;
  }
  const Search search(positions, triangles, chosen, run);
  std::vector<std::vector<std::array<int, 2>>> blocks(
    (triangles.rows() + HeavyBlock - 1) / HeavyBlock);
  forBlocksReporting(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<int> open;
      for (Index f = begin; f < end; ++f)
      {
        search.find(static_cast<int>(f), blocks[begin / HeavyBlock], open);
      }
    });
  for (const auto& block : blocks)
  {
    all.insert(all.end(), block.begin(), block.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::array<int, 2>> selfIntersections(
  const Points& positions, const Triangles& triangles, const Run& run)
{
  std::vector<int> all(triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  return selfIntersections(positions, triangles, all, run);
}
}
