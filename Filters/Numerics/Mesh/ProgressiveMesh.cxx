#include "Mesh/ProgressiveMesh.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Find the neighbor with the fewest neighbors into which a vertex can collapse, or -1.
int targetOf(const VertexRings& rings, int v)
{
  int target = -1;
  for (const int u : rings[v])
  {
    if ((target < 0 || rings[u].size() < rings[target].size()) && rings.canCollapse(v, u))
    {
      target = u;
    }
  }
  return target;
}
}

//------------------------------------------------------------------------------
ProgressiveMesh makeProgressiveMesh(
  const Mesh& mesh, QuadricCollapse::Needles needles, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  ProgressiveMesh result = { VertexRings(triangles, points.rows()), {} };
  QuadricCollapse collapses(points, result.Rings, needles);
  const Index count = triangles.rows() / 2 - 2;
  result.Splits.reserve(count);
  constexpr Index stride = 1 << 10;
  for (Index i = 0; i < count; ++i)
  {
    result.Splits.push_back(collapses.next());
    if (i % stride == 0)
    {
      run.report(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  std::reverse(result.Splits.begin(), result.Splits.end());
  run.report(1.0);
  return result;
}

//------------------------------------------------------------------------------
ProgressiveMesh makeProgressiveMesh(
  const Triangles& triangles, Index numberOfVertices, const Run& run)
{
  VertexRings rings(triangles, numberOfVertices);
  std::vector<int> used;
  for (int v = 0; v < rings.size(); ++v)
  {
    if (!rings[v].empty())
    {
      used.push_back(v);
    }
  }
  const auto maximum = static_cast<Index>(used.size()) - 4;
  return takeOut(std::move(rings), std::move(used), maximum, run);
}

//------------------------------------------------------------------------------
ProgressiveMesh takeOut(VertexRings rings, std::vector<int> vertices, Index maximum, const Run& run)
{
  // In any closed mesh of genus zero, at least half of the vertices have at most this many
  // neighbors.
  constexpr std::size_t maximumNeighbors = 8;
  ProgressiveMesh result = { std::move(rings), {} };
  const auto count = static_cast<std::size_t>(maximum);
  result.Splits.reserve(std::min(count, vertices.size()));
  std::vector<char> held(result.Rings.size());
  for (;;)
  {
    std::fill(held.begin(), held.end(), 0);
    for (std::size_t neighbors = 3; neighbors <= maximumNeighbors; ++neighbors)
    {
      for (const int v : vertices)
      {
        if (held[v] || result.Rings[v].size() != neighbors || result.Splits.size() == count)
        {
          continue;
        }
        const int target = targetOf(result.Rings, v);
        if (target >= 0)
        {
          Ring ring = result.Rings.collapse(v, target);
          held[v] = 1;
          for (const int id : ring)
          {
            held[id] = 1;
          }
          result.Splits.push_back({ v, std::move(ring) });
        }
      }
    }
    const std::size_t before = vertices.size();
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                     [&](int v) { return result.Rings[v].empty(); }),
      vertices.end());
    if (result.Splits.size() == count || before == vertices.size())
    {
      break;
    }
    run.report(static_cast<double>(result.Splits.size()) / static_cast<double>(count));
  }
  std::reverse(result.Splits.begin(), result.Splits.end());
  run.report(1.0);
  return result;
}
}
