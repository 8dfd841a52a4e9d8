#include "Geodesics/GeodesicPath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;
constexpr double AngleTolerance = 1e-9; // of angles

// Angle between two directions, in [0, pi].
double angleBetween(const Vector2& a, const Vector2& b)
{
  return std::atan2(std::abs(cross(a, b)), a.dot(b));
}
}

// Sleeve: successive neighboring triangles, here unfolded in the plane. Portal i is between
// triangles i and i + 1.
struct PathStraightener::Unfolded
{
  // Edge between two successive triangles, as seen along the path.
  struct Portal
  {
    int Left, Right;
    Vector2 LeftPlace, RightPlace;
  };

  Vector2 Start, End;
  std::vector<Portal> Portals;
  std::vector<std::array<Vector2, 3>> Corners; // of each triangle
};

// Vertex that the shortest path through a sleeve touches.
struct PathStraightener::Touched
{
  int Vertex = -1;
  Vector2 Place;
  std::size_t First = 0, Last = 0; // portals that end at the vertex
  bool IsLeft = false;             // side of the path
};

//------------------------------------------------------------------------------
void requireSimpleEdges(const Mesh& mesh)
{
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * mesh.Triangles.rows());
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(mesh.Triangles(t, k), mesh.Triangles(t, next(k)));
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end())
  {
    throw std::invalid_argument("the edge of points " + std::to_string(twice->first) + " and " +
      std::to_string(twice->second) +
      " belongs to more than two triangles, or to triangles of opposite orientation; paths cannot "
      "be computed");
  }
}

//------------------------------------------------------------------------------
Vector3 positionOf(const PathPoint& point, const Points& positions)
{
  return (1.0 - point.Fraction) * positions.row(point.First) +
    point.Fraction * positions.row(point.Second);
}

//------------------------------------------------------------------------------
double lengthOf(const std::vector<PathPoint>& path, const Points& positions)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    length += (positionOf(path[i], positions) - positionOf(path[i - 1], positions)).norm();
  }
  return length;
}

//------------------------------------------------------------------------------
std::vector<int> waysDownhill(const Mesh& mesh, const Eigen::VectorXd& distances)
{
  const Index size = mesh.Positions.rows();
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, size);
  std::vector<int> ways(size, -1);
  for (int v = 0; v < static_cast<int>(size); ++v)
  {
    ways[v] = distances[v] == 0.0 ? v : -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int* u = neighbors.begin(v); u != neighbors.end(v) && ways[v] != v; ++u)
    {
      const double length = distances[*u] + (mesh.Positions.row(*u) - mesh.Positions.row(v)).norm();
      if (distances[*u] < distances[v] && length < least)
      {
        least = length;
        ways[v] = *u;
      }
    }
  }
  return ways;
}

//------------------------------------------------------------------------------
PathStraightener::PathStraightener(const Mesh& mesh)
  : Surface(mesh)
  , Angles(mesh.Triangles.rows(), 3)
{
  requireSimpleEdges(mesh);
  this->Around = vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  this->Neighbors = triangleNeighbors(mesh.Triangles, this->Around);
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 here = mesh.Positions.row(mesh.Triangles(t, k)),
                    a = Vector3(mesh.Positions.row(mesh.Triangles(t, next(k)))) - here,
                    b = Vector3(mesh.Positions.row(mesh.Triangles(t, previous(k)))) - here;
      this->Angles(t, k) = angleBetween(a, b);
    }
  }
}

std::vector<PathPoint> PathStraightener::straighten(
  const std::vector<int>& vertices, const Run& run) const
{
  std::vector<PathPoint> result;
  const auto addVertex = [&](int v) { result.push_back({ v, v, 0.0 }); };
  std::vector<int> sleeve = this->sleeveOf(vertices);
  if (sleeve.empty())
  {
    std::for_each(vertices.begin(), vertices.end(), addVertex);
    return result;
  }
  Unfolded unfolded = this->unfold(sleeve, vertices.front(), vertices.back());
  std::vector<Touched> touched = shortestPath(unfolded);
  const std::size_t usual = sleeve.size() + 10,
                    maximum = 100 * usual; // ends loops caused by rounding errors
  for (std::size_t i = 0; i < maximum && this->bypass(sleeve, unfolded, touched); ++i)
  {
    unfolded = this->unfold(sleeve, vertices.front(), vertices.back());
    touched = shortestPath(unfolded);
    run.report(static_cast<double>(i) / static_cast<double>(i + usual));
  }
  // Cut the portals between touched vertices.
  addVertex(vertices.front());
  Vector2 from = unfolded.Start;
  std::size_t portal = 0;
  for (std::size_t i = 0; i <= touched.size(); ++i)
  {
    const bool isEnd = i == touched.size();
    const Vector2 to = isEnd ? unfolded.End : touched[i].Place;
    const std::size_t end = isEnd ? unfolded.Portals.size() : touched[i].First;
    for (; portal < end; ++portal)
    {
      const Unfolded::Portal& edge = unfolded.Portals[portal];
      const PathPoint& before = result.back();
      const bool isAtEnd =
        before.First == before.Second && (edge.Left == before.First || edge.Right == before.First);
      if (!isAtEnd)
      {
        const Vector2 along = edge.RightPlace - edge.LeftPlace;
        const double whole = cross(along, to - from);
        const double fraction =
          whole != 0.0 ? cross(from - edge.LeftPlace, to - from) / whole : 0.5;
        result.push_back({ edge.Left, edge.Right, std::clamp(fraction, 0.0, 1.0) });
      }
    }
    addVertex(isEnd ? vertices.back() : touched[i].Vertex);
    portal = isEnd ? portal : std::max(portal, touched[i].Last + 1);
    from = to;
  }
  return result;
}

// List the triangles around a vertex counter-clockwise, between its edges to two neighbors. The
// list is empty if there is a border between them.
std::vector<int> PathStraightener::fan(int center, int from, int to) const
{
  const Triangles& triangles = this->Surface.Triangles;
  for (const int* t = this->Around.begin(center); t != this->Around.end(center); ++t)
  {
    if (triangles(*t, next(cornerOf(this->Surface.Triangles, *t, center))) != from)
    {
      continue;
    }
    std::vector<int> result;
    const auto count = static_cast<std::size_t>(this->Around.size(center));
    for (int triangle = *t; triangle >= 0 && result.size() < count;)
    {
      const int corner = cornerOf(this->Surface.Triangles, triangle, center);
      result.push_back(triangle);
      if (triangles(triangle, previous(corner)) == to)
      {
        return result;
      }
      triangle = this->Neighbors(triangle, previous(corner));
    }
  }
  return {};
}

double PathStraightener::angleOf(const std::vector<int>& fan, int center) const
{
  double angle = 0.0;
  for (const int triangle : fan)
  {
    angle += this->Angles(triangle, cornerOf(this->Surface.Triangles, triangle, center));
  }
  return angle;
}

// List the triangles on the side of the smaller angle at each inner vertex of a path along edges.
// The list is empty if there are none, or if some of them are not neighbors.
std::vector<int> PathStraightener::sleeveOf(const std::vector<int>& vertices) const
{
  std::vector<int> sleeve;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
  {
    const int before = vertices[i - 1], center = vertices[i], after = vertices[i + 1];
    std::vector<int> best = this->fan(center, before, after),
                     other = this->fan(center, after, before);
    std::reverse(other.begin(), other.end());
    if (best.empty() ||
      (!other.empty() && this->angleOf(other, center) < this->angleOf(best, center)))
    {
      best = other;
    }
    if (best.empty())
    {
      return {};
    }
    const bool isRepeated = !sleeve.empty() && sleeve.back() == best.front();
    sleeve.insert(sleeve.end(), best.begin() + (isRepeated ? 1 : 0), best.end());
  }
  return sleeve;
}

PathStraightener::Unfolded PathStraightener::unfold(
  const std::vector<int>& sleeve, int start, int end) const
{
  const auto distance = [&](int a, int b)
  { return (this->Surface.Positions.row(a) - this->Surface.Positions.row(b)).norm(); };
  // Place the third corner of a triangle to the left of an edge.
  const auto third = [&](int a, int b, int c, const Vector2& placeOfA, const Vector2& placeOfB)
  {
    const double ab = distance(a, b), ac = distance(a, c), bc = distance(b, c);
    if (!(ab > 0.0)) // the edge has no length
    {
      return Vector2(placeOfA + Vector2(ac, 0.0));
    }
    const Vector2 along = (placeOfB - placeOfA) / ab, left(-along.y(), along.x());
    const double x = (ab * ab + ac * ac - bc * bc) / (2.0 * ab);
    return Vector2(placeOfA + x * along + std::sqrt(std::max(0.0, ac * ac - x * x)) * left);
  };
  Unfolded result;
  const auto first = this->Surface.Triangles.row(sleeve.front());
  const Vector2 origin = Vector2::Zero(), second(distance(first[0], first[1]), 0.0);
  result.Corners.push_back({ origin, second, third(first[0], first[1], first[2], origin, second) });
  for (std::size_t i = 0; i + 1 < sleeve.size(); ++i)
  {
    int side = 0; // of triangle i, through which the path leaves it
    while (side < 2 && this->Neighbors(sleeve[i], side) != sleeve[i + 1])
    {
      ++side;
    }
    const auto ids = this->Surface.Triangles.row(sleeve[i]);
    const std::array<Vector2, 3>& here = result.Corners.back();
    const Unfolded::Portal portal = { ids[next(side)], ids[side], here[next(side)], here[side] };
    const int corner = cornerOf(this->Surface.Triangles, sleeve[i + 1], portal.Left);
    const int opposite = this->Surface.Triangles(sleeve[i + 1], previous(corner));
    std::array<Vector2, 3> there;
    there[corner] = portal.LeftPlace;
    there[next(corner)] = portal.RightPlace;
    there[previous(corner)] =
      third(portal.Left, portal.Right, opposite, portal.LeftPlace, portal.RightPlace);
    result.Portals.push_back(portal);
    result.Corners.push_back(there);
  }
  result.Start = result.Corners.front()[cornerOf(this->Surface.Triangles, sleeve.front(), start)];
  result.End = result.Corners.back()[cornerOf(this->Surface.Triangles, sleeve.back(), end)];
  return result;
}

// Find the vertices that the shortest path through a sleeve touches, by the funnel method.
std::vector<PathStraightener::Touched> PathStraightener::shortestPath(const Unfolded& unfolded)
{
  const std::vector<Unfolded::Portal>& portals = unfolded.Portals;
  std::vector<Touched> path;
  Vector2 apex = unfolded.Start;
  for (std::size_t start = 0; start < portals.size();)
  {
    // Narrow the funnel until it is closed at a vertex, or reaches the end.
    std::size_t left = start, right = start;
    Vector2 leftRay = Vector2::Zero(), rightRay = Vector2::Zero();
    bool isClosed = false;
    const auto close = [&](std::size_t at, bool isLeft)
    {
      const Unfolded::Portal& portal = portals[at];
      path.push_back({ isLeft ? portal.Left : portal.Right,
        isLeft ? portal.LeftPlace : portal.RightPlace, at, at, isLeft });
      isClosed = true;
    };
    for (std::size_t i = start; i <= portals.size() && !isClosed; ++i)
    {
      const bool isEnd = i == portals.size();
      const Vector2 newRight = (isEnd ? unfolded.End : portals[i].RightPlace) - apex,
                    newLeft = (isEnd ? unfolded.End : portals[i].LeftPlace) - apex;
      if (cross(rightRay, newRight) >= 0.0)
      {
        if (cross(leftRay, newRight) > 0.0)
        {
          close(left, true);
          break;
        }
        rightRay = newRight;
        right = i;
      }
      if (cross(leftRay, newLeft) <= 0.0)
      {
        if (cross(rightRay, newLeft) < 0.0)
        {
          close(right, false);
          break;
        }
        leftRay = newLeft;
        left = i;
      }
    }
    if (!isClosed)
    {
      break;
    }
    Touched& touched = path.back();
    const auto ends = [&](std::size_t i)
    { return (touched.IsLeft ? portals[i].Left : portals[i].Right) == touched.Vertex; };
    while (touched.First > 0 && ends(touched.First - 1))
    {
      --touched.First;
    }
    while (touched.Last + 1 < portals.size() && ends(touched.Last + 1))
    {
      ++touched.Last;
    }
    apex = touched.Place;
    start = touched.Last + 1;
  }
  return path;
}

// If the angle on the other side of a touched vertex is below pi, replace the triangles around this
// vertex by those on its other side. Choose the vertex with the smallest angle. Return whether
// there is one.
bool PathStraightener::bypass(
  std::vector<int>& sleeve, const Unfolded& unfolded, const std::vector<Touched>& touched) const
{
  double smallest = Pi - AngleTolerance;
  std::vector<int> way;
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    const Touched& at = touched[i];
    const int first = sleeve[at.First], final = sleeve[at.Last + 1];
    const int cornerOfFirst = cornerOf(this->Surface.Triangles, first, at.Vertex),
              cornerOfFinal = cornerOf(this->Surface.Triangles, final, at.Vertex);
    // Sides of the sleeve's triangles that point to the other side of the vertex: clockwise if the
    // vertex is on the left.
    const auto side = [&](int corner, bool clockwise)
    { return clockwise ? next(corner) : previous(corner); };
    const Vector2 in = (i == 0 ? unfolded.Start : touched[i - 1].Place) - at.Place,
                  out = (i + 1 == touched.size() ? unfolded.End : touched[i + 1].Place) - at.Place;
    double angle =
      angleBetween(in, unfolded.Corners[at.First][side(cornerOfFirst, at.IsLeft)] - at.Place) +
      angleBetween(out, unfolded.Corners[at.Last + 1][side(cornerOfFinal, !at.IsLeft)] - at.Place);
    std::vector<int> other;
    int triangle = first, corner = cornerOfFirst;
    const auto count = static_cast<std::size_t>(this->Around.size(at.Vertex));
    while (triangle >= 0 && triangle != final && other.size() <= count && angle < smallest)
    {
      triangle = this->Neighbors(triangle, at.IsLeft ? corner : previous(corner));
      if (triangle >= 0 && triangle != final)
      {
        corner = cornerOf(this->Surface.Triangles, triangle, at.Vertex);
        angle += this->Angles(triangle, corner);
        other.push_back(triangle);
      }
    }
    if (triangle == final && angle < smallest)
    {
      smallest = angle;
      way = other;
      begin = at.First + 1;
      end = at.Last + 1;
    }
  }
  if (end == 0)
  {
    return false;
  }
  sleeve.erase(sleeve.begin() + static_cast<std::ptrdiff_t>(begin),
    sleeve.begin() + static_cast<std::ptrdiff_t>(end));
  sleeve.insert(sleeve.begin() + static_cast<std::ptrdiff_t>(begin), way.begin(), way.end());
  return true;
}
}
