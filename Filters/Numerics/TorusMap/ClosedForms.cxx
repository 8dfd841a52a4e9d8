#include "TorusMap/ClosedForms.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <stdexcept>

namespace conformal
{
namespace
{
// Mark both sides of the edges of a tree that reaches all vertices.
std::vector<char> treeOfVertices(
  const Triangles& triangles, Index numberOfVertices, const std::vector<int>& across)
{
  const Adjacency around = vertexTriangles(triangles, numberOfVertices);
  std::vector<char> isTree(across.size(), 0), isReached(numberOfVertices, 0);
  std::vector<int> queue = { 0 };
  isReached[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const int v = queue[i];
    for (const int* t = around.begin(v); t != around.end(v); ++t)
    {
      const int k = triangles(*t, 0) == v ? 0 : triangles(*t, 1) == v ? 1 : 2;
      const int side = 3 * *t + k, other = triangles(*t, next(k));
      if (!isReached[other])
      {
        isReached[other] = 1;
        isTree[side] = isTree[across[side]] = 1;
        queue.push_back(other);
      }
    }
  }
  return isTree;
}

// Tree that joins all triangles across sides that are not marked. Mark these sides.
// @return for each triangle, its side toward the root of the tree; -1 for the root
std::vector<int> treeOfTriangles(const std::vector<int>& across, std::vector<char>& isMarked)
{
  std::vector<int> exits(across.size() / 3, -1);
  std::vector<int> queue = { 0 };
  std::vector<char> isReached(exits.size(), 0);
  isReached[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (int side = 3 * queue[i]; side < 3 * queue[i] + 3; ++side)
    {
      const int other = across[side] / 3;
      if (!isMarked[side] && !isReached[other])
      {
        isReached[other] = 1;
        exits[other] = across[side];
        isMarked[side] = isMarked[across[side]] = 1;
        queue.push_back(other);
      }
    }
  }
  return exits;
}
}

//------------------------------------------------------------------------------
std::vector<int> sidesAcross(const Triangles& triangles, Index numberOfVertices)
{
  const Triangles neighbors = triangleNeighbors(triangles, numberOfVertices);
  std::vector<int> across(triangles.size());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = neighbors(t, k), to = triangles(t, next(k));
      const int corner = triangles(other, 0) == to ? 0 : triangles(other, 1) == to ? 1 : 2;
      across[3 * t + k] = 3 * other + corner;
    }
  }
  return across;
}

//------------------------------------------------------------------------------
SideForms integerForms(
  const Triangles& triangles, Index numberOfVertices, const std::vector<int>& across)
{
  std::vector<char> isMarked = treeOfVertices(triangles, numberOfVertices, across);
  const std::vector<int> exits = treeOfTriangles(across, isMarked);
  SideForms forms = SideForms::Zero(static_cast<Index>(across.size()), 2);
  int count = 0;
  for (int side = 0; side < static_cast<int>(across.size()); ++side)
  {
    if (isMarked[side] || across[side] < side)
    {
      continue;
    }
    if (count == 2)
    {
      throw std::invalid_argument("the surface has more than one handle");
    }
    const auto add = [&](int from, int amount)
    {
      forms(from, count) += amount;
      forms(across[from], count) -= amount;
    };
    // The curve leaves a triangle by this side, and returns along the tree.
    add(side, 1);
    for (int exit = exits[across[side] / 3]; exit >= 0; exit = exits[across[exit] / 3])
    {
      add(exit, 1);
    }
    for (int exit = exits[side / 3]; exit >= 0; exit = exits[across[exit] / 3])
    {
      add(exit, -1);
    }
    ++count;
  }
  if (count != 2)
  {
    throw std::invalid_argument("the surface has no handle");
  }
  return forms;
}
}
