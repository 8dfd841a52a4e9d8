#include "SphereMap/Sheet.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace conformal
{
namespace
{
using Ends = std::pair<int, int>;

Ends endsOf(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

// Numbers of triangles at the edges whose two ends are on the border.
std::map<Ends, int> trianglesAtEdges(const Triangles& triangles, const std::vector<char>& border)
{
  std::map<Ends, int> counts;
  for (Index f = 0; f < triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangles(f, k), b = triangles(f, next(k));
      if (border[a] && border[b])
      {
        ++counts[endsOf(a, b)];
      }
    }
  }
  return counts;
}

// Triangles into which one is cut whose edges have the middles m[k], on the edge from corner k to
// the next corner, or -1.
void cut(const std::array<int, 3>& corners, const std::array<int, 3>& m,
  std::vector<std::array<int, 3>>& triangles)
{
  const auto number = std::count_if(m.begin(), m.end(), [](int id) { return id >= 0; });
  if (number == 0)
  {
    triangles.push_back(corners);
    return;
  }
  if (number == 3)
  {
    triangles.insert(triangles.end(),
      { { corners[0], m[0], m[2] }, { corners[1], m[1], m[0] }, { corners[2], m[2], m[1] },
        { m[0], m[1], m[2] } });
    return;
  }
  // Cut at one middle, and the two halves at the other.
  const int k =
    static_cast<int>(std::find_if(m.begin(), m.end(), [](int id) { return id >= 0; }) - m.begin());
  const int a = corners[k], b = corners[next(k)], c = corners[previous(k)];
  cut({ a, m[k], c }, { -1, -1, m[previous(k)] }, triangles);
  cut({ m[k], b, c }, { -1, m[next(k)], -1 }, triangles);
}
}

//------------------------------------------------------------------------------
std::vector<char> borderVertices(const Triangles& triangles, Index numberOfVertices)
{
  std::vector<Ends> edges;
  edges.reserve(static_cast<std::size_t>(triangles.size()));
  for (Index f = 0; f < triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.push_back(endsOf(triangles(f, k), triangles(f, next(k))));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> marks(numberOfVertices, 0);
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end] == edges[i])
    {
      ++end;
    }
    if (end == i + 1)
    {
      marks[edges[i].first] = marks[edges[i].second] = 1;
    }
    i = end;
  }
  return marks;
}

//------------------------------------------------------------------------------
Mesh withFilledHoles(const Mesh& mesh)
{
  const std::vector<BorderLoop> loops = borderLoops(mesh);
  Mesh filled = mesh;
  for (std::size_t i = 1; i < loops.size(); ++i)
  {
    const auto size = static_cast<Index>(loops[i].size());
    const Index first = filled.Triangles.rows();
    const auto center = static_cast<int>(filled.Positions.rows());
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    filled.Triangles.conservativeResize(first + size, 3);
    for (Index k = 0; k < size; ++k)
    {
      sum += mesh.Positions.row(loops[i][k]);
      filled.Triangles.row(first + k) << loops[i][(k + 1) % size], loops[i][k], center;
    }
    filled.Positions.conservativeResize(center + 1, 3);
    filled.Positions.row(center) = sum / static_cast<double>(size);
  }
  return filled;
}

//------------------------------------------------------------------------------
SplitSheet withSplitChords(const Mesh& mesh, const std::vector<char>& border)
{
  std::map<Ends, int> middles; // of chords; an edge of the border has one triangle
  int count = static_cast<int>(mesh.Positions.rows());
  for (const auto& [ends, number] : trianglesAtEdges(mesh.Triangles, border))
  {
    if (number > 1)
    {
      middles[ends] = count++;
    }
  }
  SplitSheet result;
  result.Positions.resize(count, 3);
  result.Positions.topRows(mesh.Positions.rows()) = mesh.Positions;
  for (const auto& [ends, id] : middles)
  {
    result.Ends.push_back(ends);
    result.Positions.row(id) =
      0.5 * (mesh.Positions.row(ends.first) + mesh.Positions.row(ends.second));
  }
  std::vector<std::array<int, 3>> triangles;
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    std::array<int, 3> corners, m;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = mesh.Triangles(f, k);
      const auto found = middles.find(endsOf(corners[k], mesh.Triangles(f, next(k))));
      m[k] = found == middles.end() ? -1 : found->second;
    }
    cut(corners, m, triangles);
  }
  result.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (Index f = 0; f < result.Triangles.rows(); ++f)
  {
    result.Triangles.row(f) << triangles[f][0], triangles[f][1], triangles[f][2];
  }
  return result;
}

//------------------------------------------------------------------------------
DoubledSheet doubled(const Mesh& sheet, const std::vector<char>& border)
{
  const Index size = sheet.Positions.rows(), faces = sheet.Triangles.rows();
  DoubledSheet result;
  result.MirrorIds.resize(size);
  int count = static_cast<int>(size);
  for (int v = 0; v < size; ++v)
  {
    result.MirrorIds[v] = border[v] ? v : count++;
  }
  result.MirrorIds.resize(count);
  result.Positions.resize(count, 3);
  result.Positions.topRows(size) = sheet.Positions;
  for (int v = 0; v < size; ++v)
  {
    result.Positions.row(result.MirrorIds[v]) = sheet.Positions.row(v);
    result.MirrorIds[result.MirrorIds[v]] = v;
  }
  result.Triangles.resize(2 * faces, 3);
  result.Triangles.topRows(faces) = sheet.Triangles;
  for (Index f = 0; f < faces; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles(faces + f, k) = result.MirrorIds[sheet.Triangles(f, 2 - k)];
    }
  }
  return result;
}
}
