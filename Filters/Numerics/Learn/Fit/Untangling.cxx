#include "Learn/Fit/Untangling.h"

#include "Mesh/MeshTopology.h"
#include "Search/SelfIntersections.h"

#include <algorithm>
#include <array>
#include <vector>

namespace conformal
{
namespace
{
using Pairs = std::vector<std::array<int, 2>>;

/// Vertices of crossing triangles, and their neighbors, in ascending order.
std::vector<int> verticesAround(
  const Pairs& pairs, const Triangles& triangles, const Adjacency& neighbors)
{
  std::vector<int> vertices;
  for (const auto& pair : pairs)
  {
    for (const int triangle : pair)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int v = triangles(triangle, k);
        vertices.push_back(v);
        vertices.insert(vertices.end(), neighbors.begin(v), neighbors.end(v));
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Triangles with one of the vertices, in ascending order.
std::vector<int> trianglesAround(
  const std::vector<int>& vertices, const Triangles& triangles, Index numberOfVertices)
{
  std::vector<char> isChosen(numberOfVertices, 0);
  for (const int v : vertices)
  {
    isChosen[v] = 1;
  }
  std::vector<int> chosen;
  for (Index f = 0; f < triangles.rows(); ++f)
  {
    if (isChosen[triangles(f, 0)] || isChosen[triangles(f, 1)] || isChosen[triangles(f, 2)])
    {
      chosen.push_back(static_cast<int>(f));
    }
  }
  return chosen;
}

void smooth(Points& positions, const std::vector<int>& vertices, const Adjacency& neighbors)
{
  const Points old = positions;
  for (const int v : vertices)
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int* j = neighbors.begin(v); j != neighbors.end(v); ++j)
    {
      sum += old.row(*j);
    }
    positions.row(v) = sum / neighbors.size(v);
  }
}
}

Index untangle(Points& positions, const Triangles& triangles, const Run& run)
{
  constexpr int rounds = 30;
  Pairs pairs = selfIntersections(positions, triangles, run.part(0.0, 0.5));
  if (pairs.empty())
  {
    return 0;
  }
  const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
  Points best = positions;
  std::size_t fewest = pairs.size();
  for (int round = 0; round < rounds && !pairs.empty(); ++round)
  {
    const std::vector<int> moved = verticesAround(pairs, triangles, neighbors);
    smooth(positions, moved, neighbors);
    // Other triangles neither crossed before nor have moved.
    pairs = selfIntersections(
      positions, triangles, trianglesAround(moved, triangles, positions.rows()), run.unwatched());
    if (pairs.size() < fewest)
    {
      fewest = pairs.size();
      best = positions;
    }
    run.report(0.5 + 0.5 * (round + 1) / rounds);
  }
  positions = best;
  return static_cast<Index>(fewest);
}
}
