#include "Mesh/GenusZeroCheck.h"

#include "Base/DisjointSets.h"
#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace conformal
{
namespace
{
bool repeatsVertex(const Triangles& triangles, Index r)
{
  return triangles(r, 0) == triangles(r, 1) || triangles(r, 1) == triangles(r, 2) ||
    triangles(r, 2) == triangles(r, 0);
}

// Half-edge: a directed edge of a triangle.
struct Side
{
  int Low;
  int High;
  int Triangle;
  bool Upwards; // runs from the smaller to the larger id

  bool sameEdge(const Side& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const Side& other) const
  {
    return std::array<int, 3>{ this->Low, this->High, this->Triangle } <
      std::array<int, 3>{ other.Low, other.High, other.Triangle };
  }
};

using Sides = std::vector<Side>;

// Sort the half-edges by their smaller id, then by their larger id. The half-edges of an edge are
// then adjacent.
Sides sortedSides(const Triangles& triangles, const Run& run = {})
{
  Steps steps(run, { 0.16, 0.52, 0.32 });
  steps.next();
  const int size = triangles.rows() > 0 ? triangles.maxCoeff() + 1 : 0;
  std::vector<int> ends(size + 1, 0);
  const auto forEachSide = [&](const auto& body)
  {
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      for (int k = 0; k < 3 && !repeatsVertex(triangles, r); ++k)
      {
        const int from = triangles(r, k), to = triangles(r, next(k));
        body(Side{ std::min(from, to), std::max(from, to), static_cast<int>(r), from < to });
      }
    }
  };
  forEachSide([&](const Side& side) { ++ends[side.Low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  steps.next();
  Sides sides(ends.back());
  forEachSide([&](const Side& side) { sides[ends[side.Low]++] = side; });
  int begin = 0;
  forBlocksReporting(steps.next().inOrder(), size, 1 << 8,
    [&](Index first, Index last)
    {
      for (Index v = first; v < last; ++v)
      {
        std::sort(sides.begin() + begin, sides.begin() + ends[v]);
        begin = ends[v];
      }
    });
  return sides;
}

template <typename Body>
void forEachEdge(const Sides& sides, const Body& body)
{
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto last =
      std::find_if(first, sides.end(), [&](const Side& side) { return !side.sameEdge(*first); });
    body(first, static_cast<int>(last - first));
    first = last;
  }
}

// Count the sets that contain members. Each id that is not a member must be a set of its own.
Index countSets(DisjointSets& sets, const std::vector<char>& isMember)
{
  Index count = 0;
  for (std::size_t v = 0; v < isMember.size(); ++v)
  {
    count += isMember[v] && sets.find(static_cast<int>(v)) == static_cast<int>(v);
  }
  return count;
}

// Test whether several fans of triangles meet at a vertex. Within one fan, triangles connect all
// neighbors of the vertex.
bool hasSeveralFans(const Triangles& triangles, const Adjacency& around, int v)
{
  std::vector<int> ring;
  for (const int* r = around.begin(v); r != around.end(v); ++r)
  {
    for (int k = 0; k < 3 && !repeatsVertex(triangles, *r); ++k)
    {
      if (triangles(*r, k) != v)
      {
        ring.push_back(triangles(*r, k));
      }
    }
  }
  std::vector<int> neighbors = ring; // the two other vertices of each triangle are consecutive
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  const auto place = [&](int id)
  {
    return static_cast<int>(
      std::lower_bound(neighbors.begin(), neighbors.end(), id) - neighbors.begin());
  };
  DisjointSets sets(static_cast<Index>(neighbors.size()));
  for (std::size_t i = 0; i + 1 < ring.size(); i += 2)
  {
    sets.unite(place(ring[i]), place(ring[i + 1]));
  }
  return countSets(sets, std::vector<char>(neighbors.size(), 1)) > 1;
}

struct Orientation
{
  // Whether to reverse each triangle to agree with the first triangle of its connected set
  std::vector<char> Turned;
  std::vector<int> FirstOfSet; // id of the first triangle of the set
  // Whether reversing the marked triangles makes all neighbors consistent
  bool Consistent = true;
};

// Propagate the orientation of the first triangle of each set across edges of two triangles.
Orientation spreadOrientation(const Triangles& triangles, const Sides& sides)
{
  Triangles across = Triangles::Constant(triangles.rows(), 3, -1);
  Triangles sameWay = Triangles::Zero(triangles.rows(), 3);
  std::vector<int> filled(triangles.rows(), 0);
  forEachEdge(sides,
    [&](Sides::const_iterator side, int count)
    {
      if (count == 2)
      {
        const int a = side[0].Triangle, b = side[1].Triangle;
        const int same = side[0].Upwards == side[1].Upwards;
        across(a, filled[a]) = b;
        sameWay(a, filled[a]++) = same;
        across(b, filled[b]) = a;
        sameWay(b, filled[b]++) = same;
      }
    });

  Orientation result;
  result.Turned.assign(triangles.rows(), 0);
  result.FirstOfSet.assign(triangles.rows(), -1);
  std::vector<int> stack;
  for (int first = 0; first < triangles.rows(); ++first)
  {
    if (result.FirstOfSet[first] >= 0)
    {
      continue;
    }
    result.FirstOfSet[first] = first;
    stack.push_back(first);
    while (!stack.empty())
    {
      const int r = stack.back();
      stack.pop_back();
      for (int k = 0; k < filled[r]; ++k)
      {
        const int other = across(r, k);
        const char turned = static_cast<char>(result.Turned[r] ^ sameWay(r, k));
        if (result.FirstOfSet[other] < 0)
        {
          result.FirstOfSet[other] = first;
          result.Turned[other] = turned;
          stack.push_back(other);
        }
        else if (result.Turned[other] != turned)
        {
          result.Consistent = false;
        }
      }
    }
  }
  return result;
}

void requireIds(const Triangles& triangles, Index numberOfVertices)
{
  if (triangles.size() > 0 &&
    (triangles.minCoeff() < 0 || triangles.maxCoeff() >= numberOfVertices))
  {
    throw std::invalid_argument(
      "a triangle refers to a vertex outside [0, " + std::to_string(numberOfVertices) + ")");
  }
}

bool hasNoArea(const PointView& points, const Triangles& triangles, Index r)
{
  const Vector3 a = points[triangles(r, 0)];
  const Vector3 u = points[triangles(r, 1)] - a, v = points[triangles(r, 2)] - a;
  // A cross product below this bound is rounding error. Lengths are scaled so that squares neither
  // overflow nor underflow.
  const double scale = std::max(u.lpNorm<Eigen::Infinity>(), v.lpNorm<Eigen::Infinity>());
  return !(scale > 0.0) ||
    !((u / scale).cross(v / scale).norm() > 4.0 * std::numeric_limits<double>::epsilon());
}

std::string counted(Index count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string firstOf(const std::vector<Edge>& edges)
{
  return " (first: " + std::to_string(edges.front()[0]) + "-" + std::to_string(edges.front()[1]) +
    ")";
}

std::string firstOf(const std::vector<int>& ids)
{
  return " (first: " + std::to_string(ids.front()) + ")";
}
}

//------------------------------------------------------------------------------
GenusZeroReport checkGenusZero(
  const Triangles& triangles, Index numberOfVertices, const PointView& points, const Run& run)
{
  requireIds(triangles, numberOfVertices);
  Steps steps(run, { 0.04, 0.23, 0.05, 0.05, 0.49, 0.14 });
  steps.next();
  GenusZeroReport result;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const bool repeats = repeatsVertex(triangles, r);
    result.NumberOfTriangles += !repeats;
    if (repeats || (points.size() > 0 && hasNoArea(points, triangles, r)))
    {
      result.DegenerateTriangles.push_back(static_cast<int>(r));
    }
  }
  for (Index v = 0; v < points.size(); ++v)
  {
    if (!points[v].allFinite())
    {
      result.NonFinitePoints.push_back(static_cast<int>(v));
    }
  }

  const Sides sides = sortedSides(triangles, steps.next());
  steps.next();
  DisjointSets connected(numberOfVertices), loops(numberOfVertices);
  std::vector<char> used(numberOfVertices, 0), onBoundary(numberOfVertices, 0);
  forEachEdge(sides,
    [&](Sides::const_iterator side, int count)
    {
      const Edge edge = { side->Low, side->High };
      ++result.NumberOfEdges;
      used[edge[0]] = used[edge[1]] = 1;
      connected.unite(edge[0], edge[1]);
      if (count == 1)
      {
        onBoundary[edge[0]] = onBoundary[edge[1]] = 1;
        loops.unite(edge[0], edge[1]);
        result.BoundaryEdges.push_back(side->Upwards ? edge : Edge{ edge[1], edge[0] });
      }
      else if (count > 2)
      {
        result.NonManifoldEdges.push_back(edge);
      }
      else if (side[0].Upwards == side[1].Upwards)
      {
        result.InconsistentEdges.push_back(edge);
      }
    });
  result.NumberOfComponents = countSets(connected, used);
  result.NumberOfBoundaryLoops = countSets(loops, onBoundary);

  steps.next();
  const Adjacency around = vertexTriangles(triangles, numberOfVertices);
  forBlocksReporting(steps.next().inOrder(), numberOfVertices, 1 << 8,
    [&](Index begin, Index end)
    {
      for (int v = static_cast<int>(begin); v < end; ++v)
      {
        if (!used[v])
        {
          result.IsolatedPoints.push_back(v);
        }
        else if (hasSeveralFans(triangles, around, v))
        {
          result.NonManifoldVertices.push_back(v);
        }
      }
    });
  result.NumberOfVertices = numberOfVertices - static_cast<Index>(result.IsolatedPoints.size());
  result.EulerNumber = result.NumberOfVertices - result.NumberOfEdges + result.NumberOfTriangles;

  steps.next();
  result.Orientable = spreadOrientation(triangles, sides).Consistent;
  result.InsideOut = points.size() > 0 && result.closed() && result.InconsistentEdges.empty() &&
    signedVolume(points, triangles) < 0.0;
  run.report(1.0);
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> describe(const GenusZeroReport& mesh)
{
  if (mesh.NumberOfTriangles == 0)
  {
    return { "no triangles" };
  }
  const std::string pieces = mesh.NumberOfComponents == 1
    ? "one component"
    : std::to_string(mesh.NumberOfComponents) + " components";
  std::vector<std::string> lines;
  lines.push_back(std::string(mesh.isGenusZero() ? "a closed surface of genus zero: " : "") +
    (mesh.closed() ? "closed, " : "open, ") + (mesh.manifold() ? "manifold, " : "not manifold, ") +
    pieces + ", Euler number " + std::to_string(mesh.EulerNumber) +
    (mesh.Orientable ? "" : ", not orientable"));
  const auto add = [&](const auto& ids, const std::string& one, const std::string& many)
  {
    if (!ids.empty())
    {
      lines.push_back(counted(static_cast<Index>(ids.size()), one, many) + firstOf(ids));
    }
  };
  if (!mesh.BoundaryEdges.empty())
  {
    lines.push_back(
      counted(static_cast<Index>(mesh.BoundaryEdges.size()), "boundary edge", "boundary edges") +
      " in " + counted(mesh.NumberOfBoundaryLoops, "loop", "loops") + firstOf(mesh.BoundaryEdges));
  }
  add(mesh.NonManifoldEdges, "edge of more than two triangles", "edges of more than two triangles");
  add(mesh.NonManifoldVertices, "vertex with several fans of triangles",
    "vertices with several fans of triangles");
  add(mesh.InconsistentEdges, "edge between triangles of opposite orientation",
    "edges between triangles of opposite orientation");
  add(mesh.DegenerateTriangles, "triangle without area", "triangles without area");
  add(mesh.IsolatedPoints, "point of no triangle", "points of no triangle");
  add(mesh.NonFinitePoints, "point that is not finite", "points that are not finite");
  if (mesh.InsideOut)
  {
    lines.push_back("inside out: the triangles are clockwise seen from outside");
  }
  return lines;
}

//------------------------------------------------------------------------------
void requireGenusZero(const Triangles& triangles, Index numberOfVertices, const Run& run)
{
  const GenusZeroReport mesh = checkGenusZero(triangles, numberOfVertices, {}, run);
  if (!mesh.isGenusZero() || !mesh.InconsistentEdges.empty() || !mesh.DegenerateTriangles.empty())
  {
    std::string message = "not a closed, oriented surface of genus zero: ";
    const char* separator = "";
    for (const std::string& line : describe(mesh))
    {
      message += separator + line;
      separator = "; ";
    }
    throw std::invalid_argument(message);
  }
}

//------------------------------------------------------------------------------
double signedVolume(const PointView& points, const Triangles& triangles)
{
  if (triangles.rows() == 0)
  {
    return 0.0;
  }
  const Vector3 origin = points[triangles(0, 0)]; // near the mesh, to avoid cancellation
  double volume = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = points[triangles(r, 0)] - origin, b = points[triangles(r, 1)] - origin,
                  c = points[triangles(r, 2)] - origin;
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

//------------------------------------------------------------------------------
void requireFiniteTriangles(const Points& points, const Triangles& triangles)
{
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (const int id : triangles.row(r))
    {
      if (!points.row(id).allFinite())
      {
        throw std::invalid_argument("a triangle of the surface has a point whose coordinates are "
                                    "not finite; remove such triangles");
      }
    }
  }
}

//------------------------------------------------------------------------------
double surfaceArea(const PointView& points, const Triangles& triangles)
{
  double area = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = points[triangles(r, 0)];
    area += 0.5 * (points[triangles(r, 1)] - a).cross(points[triangles(r, 2)] - a).norm();
  }
  return area;
}

//------------------------------------------------------------------------------
double equalEdgeLength(double area, Index numberOfVertices)
{
  // There are two triangles for each vertex.
  return std::sqrt(2.0 / std::sqrt(3.0) * area / static_cast<double>(numberOfVertices));
}

//------------------------------------------------------------------------------
Index mergeCoincidentBoundaryPoints(
  Triangles& triangles, const PointView& points, const GenusZeroReport& mesh)
{
  std::vector<int> ids;
  for (const Edge& edge : mesh.BoundaryEdges)
  {
    ids.insert(ids.end(), edge.begin(), edge.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto coordinates = [&](int id)
  {
    const Vector3 p = points[id];
    return std::array<double, 3>{ p[0], p[1], p[2] };
  };
  std::stable_sort(
    ids.begin(), ids.end(), [&](int a, int b) { return coordinates(a) < coordinates(b); });

  std::vector<int> mergedInto(points.size());
  std::iota(mergedInto.begin(), mergedInto.end(), 0);
  Index count = 0;
  for (std::size_t i = 1; i < ids.size(); ++i)
  {
    if (coordinates(ids[i]) == coordinates(ids[i - 1]))
    {
      mergedInto[ids[i]] = mergedInto[ids[i - 1]];
      ++count;
    }
  }
  std::for_each(
    triangles.data(), triangles.data() + triangles.size(), [&](int& id) { id = mergedInto[id]; });
  return count;
}

//------------------------------------------------------------------------------
Index dropRepeatedVertices(Triangles& triangles)
{
  Index kept = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    if (!repeatsVertex(triangles, r))
    {
      triangles.row(kept++) = triangles.row(r);
    }
  }
  const Index dropped = triangles.rows() - kept;
  triangles.conservativeResize(kept, 3);
  return dropped;
}

//------------------------------------------------------------------------------
Index orientConsistently(Triangles& triangles)
{
  const Orientation orientation = spreadOrientation(triangles, sortedSides(triangles));
  // At the first triangle of each set: number of triangles to keep minus number of triangles to
  // reverse
  std::vector<Index> majority(triangles.rows(), 0);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    majority[orientation.FirstOfSet[r]] += orientation.Turned[r] ? -1 : 1;
  }
  Index count = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const bool turnOthers = majority[orientation.FirstOfSet[r]] < 0;
    if ((orientation.Turned[r] != 0) != turnOthers)
    {
      std::swap(triangles(r, 1), triangles(r, 2));
      ++count;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<int> dropIsolatedPoints(Triangles& triangles, Index numberOfVertices)
{
  std::vector<int> newIds(numberOfVertices, -1), oldIds;
  for (Index i = 0; i < triangles.size(); ++i)
  {
    newIds[triangles.data()[i]] = 0;
  }
  for (int v = 0; v < numberOfVertices; ++v)
  {
    if (newIds[v] == 0)
    {
      newIds[v] = static_cast<int>(oldIds.size());
      oldIds.push_back(v);
    }
  }
  std::for_each(
    triangles.data(), triangles.data() + triangles.size(), [&](int& id) { id = newIds[id]; });
  return oldIds;
}
}
