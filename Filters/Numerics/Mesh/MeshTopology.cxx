#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace conformal
{
namespace
{
/// Find the triangle that contains a directed edge, or -1. The search is around the vertex with
/// fewer triangles: a vertex of n triangles has n edges, and would need n^2 steps.
int triangleWithEdge(const Triangles& triangles, const Adjacency& around, int from, int to)
{
  const auto valence = [&](int v) { return around.end(v) - around.begin(v); };
  const int center = valence(to) < valence(from) ? to : from;
  for (const int* r = around.begin(center); r != around.end(center); ++r)
  {
    const auto ids = triangles.row(*r);
    if ((ids[0] == from && ids[1] == to) || (ids[1] == from && ids[2] == to) ||
      (ids[2] == from && ids[0] == to))
    {
      return *r;
    }
  }
  return -1;
}
}

Adjacency vertexTriangles(const Triangles& triangles, Index numberOfVertices)
{
  Adjacency around;
  around.Offsets.assign(numberOfVertices + 1, 0);
  for (Index i = 0; i < triangles.size(); ++i)
  {
    ++around.Offsets[triangles.data()[i] + 1];
  }
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    around.Offsets[v + 1] += around.Offsets[v];
  }
  around.Ids.resize(triangles.size());
  std::vector<int> next(around.Offsets.begin(), around.Offsets.end() - 1);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      around.Ids[next[triangles(r, k)]++] = static_cast<int>(r);
    }
  }
  return around;
}

Adjacency vertexNeighbors(const Triangles& triangles, Index numberOfVertices)
{
  const Adjacency around = vertexTriangles(triangles, numberOfVertices);
  Adjacency neighbors;
  neighbors.Offsets.assign(1, 0);
  neighbors.Offsets.reserve(numberOfVertices + 1);
  neighbors.Ids.reserve(triangles.size());
  std::vector<int> ring;
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    ring.clear();
    for (const int* r = around.begin(v); r != around.end(v); ++r)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (triangles(*r, k) != v)
        {
          ring.push_back(triangles(*r, k));
        }
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    neighbors.Ids.insert(neighbors.Ids.end(), ring.begin(), ring.end());
    neighbors.Offsets.push_back(static_cast<int>(neighbors.Ids.size()));
  }
  return neighbors;
}

std::vector<int> usedVertices(const Triangles& triangles, Index numberOfVertices)
{
  std::vector<char> used(numberOfVertices, 0);
  for (Index i = 0; i < triangles.size(); ++i)
  {
    used[triangles.data()[i]] = 1;
  }
  std::vector<int> vertices;
  for (int v = 0; v < numberOfVertices; ++v)
  {
    if (used[v])
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

EdgePaths pathsAlongEdges(const Mesh& mesh, const std::vector<int>& sources)
{
  const Index size = mesh.Positions.rows();
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, size);
  EdgePaths paths{ std::vector<double>(size, -1.0), std::vector<int>(size, -1) };
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const int source : sources)
  {
    paths.Lengths[source] = 0.0;
    paths.Ways[source] = source;
    queue.emplace(0.0, source);
  }
  while (!queue.empty())
  {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > paths.Lengths[v])
    {
      continue;
    }
    for (const int* u = neighbors.begin(v); u != neighbors.end(v); ++u)
    {
      const double longer = length + (mesh.Positions.row(*u) - mesh.Positions.row(v)).norm();
      if (paths.Lengths[*u] < 0.0 || longer < paths.Lengths[*u])
      {
        paths.Lengths[*u] = longer;
        paths.Ways[*u] = v;
        queue.emplace(longer, *u);
      }
    }
  }
  return paths;
}

Triangles triangleNeighbors(const Triangles& triangles, Index numberOfVertices, const Run& run)
{
  return triangleNeighbors(triangles, vertexTriangles(triangles, numberOfVertices), run);
}

Triangles triangleNeighbors(const Triangles& triangles, const Adjacency& around, const Run& run)
{
  Triangles across(triangles.rows(), 3);
  const Index blockSize = 1024;
  forBlocks(run, triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        for (int k = 0; k < 3; ++k)
        {
          across(r, k) =
            triangleWithEdge(triangles, around, triangles(r, next(k)), triangles(r, k));
        }
      }
    });
  return across;
}

//------------------------------------------------------------------------------
Index countOpenEdges(const Triangles& triangles, Index numberOfVertices, const Run& run)
{
  return (triangleNeighbors(triangles, numberOfVertices, run).array() < 0).count();
}

//------------------------------------------------------------------------------
std::vector<BorderLoop> borderLoops(const Mesh& mesh)
{
  std::map<int, int> nextOnBorder;
  const Triangles across = triangleNeighbors(mesh.Triangles, mesh.Positions.rows());
  for (Index r = 0; r < across.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (across(r, k) < 0)
      {
        nextOnBorder[mesh.Triangles(r, k)] = mesh.Triangles(r, next(k));
      }
    }
  }
  std::vector<BorderLoop> loops;
  std::size_t longest = 0;
  double maximum = -1.0;
  while (!nextOnBorder.empty())
  {
    BorderLoop loop;
    double length = 0.0;
    for (auto at = nextOnBorder.begin(); at != nextOnBorder.end();)
    {
      const auto [from, to] = *at;
      loop.push_back(from);
      length += (mesh.Positions.row(to) - mesh.Positions.row(from)).norm();
      nextOnBorder.erase(at);
      at = nextOnBorder.find(to);
    }
    if (length > maximum)
    {
      maximum = length;
      longest = loops.size();
    }
    loops.push_back(loop);
  }
  if (!loops.empty())
  {
    std::rotate(loops.begin(), loops.begin() + longest, loops.begin() + longest + 1);
  }
  return loops;
}

std::vector<std::vector<int>> independentSets(
  const std::vector<int>& vertices, int numberOfVertices, const VisitNeighbors& visitNeighbors)
{
  std::vector<int> setOf(numberOfVertices, -1);
  std::vector<std::vector<int>> sets;
  std::vector<int> takenBy; // for each set, the last vertex with a neighbor in it
  for (const int v : vertices)
  {
    visitNeighbors(v,
      [&](int neighbor)
      {
        if (setOf[neighbor] >= 0)
        {
          takenBy[setOf[neighbor]] = v;
        }
      });
    const auto free =
      std::find_if(takenBy.begin(), takenBy.end(), [&](int taken) { return taken != v; });
    setOf[v] = static_cast<int>(free - takenBy.begin());
    if (free == takenBy.end())
    {
      takenBy.push_back(-1);
      sets.emplace_back();
    }
    sets[setOf[v]].push_back(v);
  }
  return sets;
}
}
