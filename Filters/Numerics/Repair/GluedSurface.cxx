#include "Repair/GluedSurface.h"

#include "Base/DisjointSets.h"
#include "Base/Steps.h"
#include "Mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace conformal
{
namespace
{
// Half-edge, identified by its edge and its opposite corner.
struct EdgeSide
{
  int Low, High, Apex, Side;
  bool Upwards; // whether the side runs from the lower to the higher id

  bool sameEdge(const EdgeSide& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const EdgeSide& other) const
  {
    return std::tie(this->Low, this->High, this->Apex, this->Side) <
      std::tie(other.Low, other.High, other.Apex, other.Side);
  }
};

using EdgeSides = std::vector<EdgeSide>;
using Group = EdgeSides::const_iterator;

// Sort sides by edge: first distribute them by the smaller id, then sort each group.
EdgeSides sidesByEdge(const int* corners, const std::vector<int>& triangles, Index numberOfVertices)
{
  std::vector<int> ends(numberOfVertices + 1, 0);
  const auto forEachSide = [&](const auto& body)
  {
    for (const int r : triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int* ids = corners + 3 * r;
        const int from = ids[k], to = ids[next(k)];
        body(EdgeSide{
          std::min(from, to), std::max(from, to), ids[previous(k)], 3 * r + k, from < to });
      }
    }
  };
  forEachSide([&](const EdgeSide& side) { ++ends[side.Low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  EdgeSides sides(ends.back());
  forEachSide([&](const EdgeSide& side) { sides[ends[side.Low]++] = side; });
  int begin = 0;
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    std::sort(sides.begin() + begin, sides.begin() + ends[v]);
    begin = ends[v];
  }
  return sides;
}

template <typename Body>
void forEachEdge(const EdgeSides& sides, const Body& body)
{
  for (Group first = sides.begin(); first != sides.end();)
  {
    const Group last = std::find_if(
      first, sides.end(), [&](const EdgeSide& side) { return !side.sameEdge(*first); });
    body(first, last);
    first = last;
  }
}

// Connected sets of triangles, with the relative orientation of each triangle. Triangle r is id r
// as given, and id r + Size if reversed.
class TurnedSets
{
public:
  explicit TurnedSets(Index size)
    : Size(static_cast<int>(size))
    , Sets(2 * size)
  {
  }

  // Return the smallest triangle in the set of a triangle.
  int first(int r) { return std::min(this->Sets.find(r), this->Sets.find(r + this->Size)); }

  bool isTurned(int r) { return this->Sets.find(r) > this->Sets.find(r + this->Size); }

  // Connect two triangles with equal or opposite orientation. Return false, without a change, if
  // they are already connected with the other orientation.
  bool join(int a, int b, bool turned)
  {
    const int same = turned ? b + this->Size : b, opposite = turned ? b : b + this->Size;
    if (this->Sets.find(a) == this->Sets.find(opposite))
    {
      return false;
    }
    this->Sets.unite(a, same);
    this->Sets.unite(a + this->Size, opposite);
    return true;
  }

private:
  int Size;
  DisjointSets Sets;
};

// Return the direction from the edge into a triangle.
Vector3 awayFromEdge(const PointView& points, const EdgeSide& side)
{
  const Vector3 a = points[side.Low];
  const Vector3 edge = (points[side.High] - a).normalized(), apex = points[side.Apex] - a;
  return (apex - apex.dot(edge) * edge).normalized();
}

// Two sides of one edge that may be glued, ordered by preference.
struct SidePair
{
  bool Disagree; // whether the known orientations are inconsistent
  double Bend;   // -1 for coplanar continuation, 1 for triangles folded onto each other
  bool Apart;    // whether the sides belong to two parts, such as touching bodies
  int First, Second;

  bool operator<(const SidePair& other) const
  {
    return std::tie(this->Disagree, this->Bend, this->Apart, this->First, this->Second) <
      std::tie(other.Disagree, other.Bend, other.Apart, other.First, other.Second);
  }
};

std::vector<SidePair> pairsOf(const PointView& points, Group first, Group last,
  const std::vector<char>& isTurned, TurnedSets& parts)
{
  constexpr int maximum = 16;    // more triangles on one edge are no surface
  constexpr double digits = 1e6; // bends are compared in steps of 1 / digits
  const auto size = static_cast<int>(last - first);
  std::vector<SidePair> pairs;
  for (int i = 0; size <= maximum && i < size; ++i)
  {
    for (int j = i + 1; j < size; ++j)
    {
      const int a = first[i].Side / 3, b = first[j].Side / 3;
      const double bend = awayFromEdge(points, first[i]).dot(awayFromEdge(points, first[j]));
      pairs.push_back(
        { (first[i].Upwards != (isTurned[a] != 0)) == (first[j].Upwards != (isTurned[b] != 0)),
          std::round(bend * digits), parts.first(a) != parts.first(b), i, j });
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Return for each triangle whether it is reversed to agree with the majority of its part.
std::vector<char> turnedTriangles(const std::vector<int>& used, Index size, TurnedSets& parts)
{
  std::vector<Index> majority(size, 0); // by first triangle: kept minus reversed ones
  for (const int r : used)
  {
    majority[parts.first(r)] += parts.isTurned(r) ? -1 : 1;
  }
  std::vector<char> isTurned(size, 0);
  for (const int r : used)
  {
    isTurned[r] = parts.isTurned(r) != (majority[parts.first(r)] < 0);
  }
  return isTurned;
}

// All glued triangles, before the selection of a part.
struct Gluing
{
  std::vector<int> Across;    // side glued to each side, numbered as in the input
  std::vector<int> Conflicts; // triangles at edges that no orientation makes consistent
};

Gluing glueSides(const PointView& points, const EdgeSides& sides, const std::vector<int>& used,
  Index numberOfTriangles, TurnedSets& parts)
{
  Gluing result;
  result.Across.assign(3 * numberOfTriangles, -1);
  const auto glue = [&](const EdgeSide& a, const EdgeSide& b)
  {
    const bool agree = parts.join(a.Side / 3, b.Side / 3, a.Upwards == b.Upwards);
    if (agree)
    {
      result.Across[a.Side] = b.Side;
      result.Across[b.Side] = a.Side;
    }
    return agree;
  };
  forEachEdge(sides,
    [&](Group first, Group last)
    {
      if (last - first == 2 && !glue(first[0], first[1]))
      {
        result.Conflicts.push_back(first->Side / 3);
      }
    });
  // The majority orientation is determined only after all edges are glued.
  const std::vector<char> isTurned = turnedTriangles(used, numberOfTriangles, parts);
  forEachEdge(sides,
    [&](Group first, Group last)
    {
      if (last - first <= 2)
      {
        return;
      }
      for (const SidePair& pair : pairsOf(points, first, last, isTurned, parts))
      {
        const EdgeSide &a = first[pair.First], &b = first[pair.Second];
        if (result.Across[a.Side] < 0 && result.Across[b.Side] < 0)
        {
          glue(a, b);
        }
      }
    });
  return result;
}

// Return the triangles without repeated points and duplicates.
std::vector<int> usableTriangles(
  const Triangles& triangles, Index numberOfPoints, EdgeSides& sides, GluingReport& report)
{
  std::vector<int> used;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const bool repeats = triangles(r, 0) == triangles(r, 1) || triangles(r, 1) == triangles(r, 2) ||
      triangles(r, 2) == triangles(r, 0);
    report.NumberOfRepeatedPoints += repeats;
    if (!repeats)
    {
      used.push_back(static_cast<int>(r));
    }
  }
  sides = sidesByEdge(triangles.data(), used, numberOfPoints);
  std::vector<char> isDuplicate(triangles.rows(), 0);
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    if (sides[i].sameEdge(sides[i - 1]) && sides[i].Apex == sides[i - 1].Apex)
    {
      isDuplicate[sides[i].Side / 3] = 1;
    }
  }
  report.NumberOfDuplicates = std::count(isDuplicate.begin(), isDuplicate.end(), 1);
  if (report.NumberOfDuplicates > 0)
  {
    used.erase(std::remove_if(used.begin(), used.end(), [&](int r) { return isDuplicate[r] != 0; }),
      used.end());
    sides = sidesByEdge(triangles.data(), used, numberOfPoints);
  }
  return used;
}

// Find the first triangle of the part of largest area.
int largestPart(const PointView& points, const Triangles& triangles, const std::vector<int>& used,
  TurnedSets& parts, GluingReport& report)
{
  std::vector<double> areas(triangles.rows(), 0.0);
  std::vector<Index> sizes(triangles.rows(), 0);
  double whole = 0.0;
  for (const int r : used)
  {
    const Vector3 a = points[triangles(r, 0)];
    const double area =
      0.5 * (points[triangles(r, 1)] - a).cross(points[triangles(r, 2)] - a).norm();
    areas[parts.first(r)] += area;
    ++sizes[parts.first(r)];
    whole += area;
  }
  int largest = used.front();
  for (const int r : used)
  {
    largest = areas[parts.first(r)] > areas[largest] ? parts.first(r) : largest;
  }
  report.NumberOfPartsRemoved =
    std::count_if(sizes.begin(), sizes.end(), [](Index size) { return size > 0; }) - 1;
  report.NumberOfTrianglesRemoved = static_cast<Index>(used.size()) - sizes[largest];
  for (std::size_t r = 0; r < areas.size() && whole > 0.0; ++r)
  {
    report.AreaRemoved += static_cast<int>(r) == largest ? 0.0 : areas[r] / whole;
  }
  return largest;
}

// Make one vertex for each fan of triangles, in the order of the points.
void makeVertices(GluedSurface& surface, const PointView& points)
{
  std::vector<int> vertices(surface.Corners.size(), -1), pointIds;
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    if (vertices[side] >= 0)
    {
      continue;
    }
    const auto vertex = static_cast<int>(pointIds.size());
    pointIds.push_back(surface.Corners[side]);
    int other = side;
    for (; other >= 0 && vertices[other] < 0; other = surface.clockwise(other))
    {
      vertices[other] = vertex;
    }
    for (other = other < 0 ? surface.counterClockwise(side) : -1; other >= 0;
         other = surface.counterClockwise(other))
    {
      vertices[other] = vertex;
    }
  }
  std::vector<int> order(pointIds.size()), ids(pointIds.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return pointIds[a] < pointIds[b]; });
  for (const int vertex : order)
  {
    ids[vertex] = surface.numberOfVertices();
    surface.PointIds.push_back(pointIds[vertex]);
    surface.Positions.push_back(points[pointIds[vertex]]);
  }
  surface.Parents.resize(surface.PointIds.size());
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    surface.Corners[side] = ids[vertices[side]];
  }
}

// Return the side of a reversed triangle, whose second and third corners are swapped, and so are
// sides 0 and 2.
int sideIfTurned(int side, bool turned)
{
  return turned ? side - side % 3 + 2 - side % 3 : side;
}

void glue(GluedSurface& surface, int a, int b)
{
  surface.Across[a] = b;
  surface.Across[b] = a;
}

int addTriangle(GluedSurface& surface, int a, int b, int c, int triangleId)
{
  surface.Corners.insert(surface.Corners.end(), { a, b, c });
  surface.Across.insert(surface.Across.end(), { -1, -1, -1 });
  surface.TriangleIds.push_back(triangleId);
  return 3 * (surface.numberOfTriangles() - 1);
}

// @param[in] parents  vertices whose mean is the position
int addVertex(GluedSurface& surface, const Vector3& position, const std::vector<int>& parents)
{
  std::vector<int> points;
  for (const int vertex : parents)
  {
    const int point = surface.PointIds[vertex];
    points.push_back(point >= 0 ? point : surface.Parents[vertex].front());
  }
  surface.Positions.push_back(position);
  surface.PointIds.push_back(GluedSurface::Added);
  surface.Parents.push_back(points);
  return surface.numberOfVertices() - 1;
}

int addCopy(GluedSurface& surface, int vertex)
{
  const Vector3 position = surface.Positions[vertex];
  const std::vector<int> parents = surface.Parents[vertex];
  surface.Positions.push_back(position);
  surface.PointIds.push_back(surface.PointIds[vertex]);
  surface.Parents.push_back(parents);
  return surface.numberOfVertices() - 1;
}

// Return whether an edge joins the start of a side to another vertex.
bool reaches(const GluedSurface& surface, int side, int vertex)
{
  int other = side;
  do
  {
    if (surface.to(other) == vertex || surface.from(GluedSurface::before(other)) == vertex)
    {
      return true;
    }
    other = surface.clockwise(other);
  } while (other >= 0 && other != side);
  for (other = other < 0 ? surface.counterClockwise(side) : -1; other >= 0;
       other = surface.counterClockwise(other))
  {
    if (surface.from(GluedSurface::before(other)) == vertex)
    {
      return true;
    }
  }
  return false;
}

// Return the side of a loop that begins at corner `corner` of its cap.
int placeInLoop(int corner, int size)
{
  return (size - corner) % size;
}

// Glue the triangles of the largest part, or of all parts.
GluedSurface glueParts(const PointView& points, const Triangles& triangles, bool isLargestOnly,
  GluingReport& report, const Run& run)
{
  constexpr int everyPart = -1;
  Steps steps(run, { 0.5, 0.25, 0.25 });
  steps.next();
  GluedSurface surface;
  EdgeSides sides;
  const std::vector<int> used = usableTriangles(triangles, points.size(), sides, report);
  if (used.empty())
  {
    return surface;
  }
  forEachEdge(
    sides, [&](Group first, Group last) { report.NumberOfNonManifoldEdges += last - first > 2; });

  steps.next();
  TurnedSets parts(triangles.rows());
  const Gluing gluing = glueSides(points, sides, used, triangles.rows(), parts);
  const int largest =
    isLargestOnly ? largestPart(points, triangles, used, parts, report) : everyPart;
  for (const int r : gluing.Conflicts)
  {
    if (parts.first(r) == largest)
    {
      throw std::invalid_argument(
        "the surface is not orientable: it has one side only, like a Moebius strip or a Klein "
        "bottle, and bounds no body; its sides join at point " +
        std::to_string(triangles(r, 0)));
    }
  }

  steps.next();
  const std::vector<char> isTurned = turnedTriangles(used, triangles.rows(), parts);
  std::vector<int> places(triangles.rows(), -1);
  for (const int r : used)
  {
    if (largest == everyPart || parts.first(r) == largest)
    {
      places[r] = surface.numberOfTriangles();
      surface.TriangleIds.push_back(r);
      report.NumberOfTurnedTriangles += isTurned[r];
    }
  }
  surface.Corners.resize(3 * surface.TriangleIds.size());
  surface.Across.assign(surface.Corners.size(), -1);
  for (const int r : surface.TriangleIds)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int corner = isTurned[r] ? (3 - k) % 3 : k;
      surface.Corners[3 * places[r] + corner] = triangles(r, k);
      const int other = gluing.Across[3 * r + k];
      if (other >= 0)
      {
        surface.Across[sideIfTurned(3 * places[r] + k, isTurned[r] != 0)] =
          sideIfTurned(3 * places[other / 3] + other % 3, isTurned[other / 3] != 0);
      }
    }
  }
  makeVertices(surface, points);
  report.NumberOfSeparatedPoints = numberOfSeparatedPoints(surface);
  return surface;
}
}

//------------------------------------------------------------------------------
GluedSurface glueTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run)
{
  return glueParts(points, triangles, true, report, run);
}

//------------------------------------------------------------------------------
GluedSurface glueAllTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run)
{
  return glueParts(points, triangles, false, report, run);
}

//------------------------------------------------------------------------------
Index numberOfSeparatedPoints(const GluedSurface& surface)
{
  const std::vector<int>& ids = surface.PointIds;
  Index count = 0;
  for (std::size_t v = 1; v < ids.size(); ++v)
  {
    const bool isFirstCopy = ids[v] == ids[v - 1] && (v == 1 || ids[v] != ids[v - 2]);
    count += ids[v] >= 0 && isFirstCopy;
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<std::vector<int>> openLoops(const GluedSurface& surface)
{
  std::vector<std::vector<int>> loops;
  std::vector<char> isSeen(surface.Corners.size(), 0);
  for (int first = 0; first < surface.numberOfSides(); ++first)
  {
    if (surface.Across[first] >= 0 || isSeen[first])
    {
      continue;
    }
    loops.emplace_back();
    for (int side = first; !isSeen[side];)
    {
      isSeen[side] = 1;
      loops.back().push_back(side);
      side = GluedSurface::after(side);
      while (surface.Across[side] >= 0)
      {
        side = surface.clockwise(side);
      }
    }
  }
  return loops;
}

//------------------------------------------------------------------------------
Points cornersOfCap(const GluedSurface& surface, const std::vector<int>& loop)
{
  const auto size = static_cast<int>(loop.size());
  Points corners(size, 3);
  for (int j = 0; j < size; ++j)
  {
    corners.row(j) = surface.Positions[surface.from(loop[placeInLoop(j, size)])];
  }
  return corners;
}

//------------------------------------------------------------------------------
LoopCap capFor(const GluedSurface& surface, const std::vector<int>& loop)
{
  const auto size = static_cast<int>(loop.size());
  const Points corners = cornersOfCap(surface, loop);
  const bool isOneTriangle = size == 3 && loop[0] / 3 == loop[1] / 3 && loop[1] / 3 == loop[2] / 3;
  if (size < 3 || isOneTriangle)
  {
    return fanOf(corners);
  }
  return capLoop(corners,
    [&](int i, int j) {
      return reaches(surface, loop[placeInLoop(i, size)], surface.from(loop[placeInLoop(j, size)]));
    });
}

//------------------------------------------------------------------------------
void closeLoop(
  GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap, int triangleId)
{
  const auto size = static_cast<int>(loop.size());
  if (size == 2)
  {
    glue(surface, loop[0], loop[1]);
    return;
  }
  std::vector<int> vertices;
  vertices.reserve(loop.size() + static_cast<std::size_t>(cap.Added.rows()));
  for (int j = 0; j < size; ++j)
  {
    vertices.push_back(surface.from(loop[placeInLoop(j, size)]));
  }
  for (Index i = 0; i < cap.Added.rows(); ++i)
  {
    const auto& [first, last] = cap.Parents[i];
    vertices.push_back(
      addVertex(surface, cap.Added.row(i), { vertices.begin() + first, vertices.begin() + last }));
  }
  std::vector<std::array<int, 3>> sides; // two vertices of the cap, smaller first, and the side
  for (Index r = 0; r < cap.Triangles.rows(); ++r)
  {
    const auto corners = cap.Triangles.row(r);
    const int first = addTriangle(
      surface, vertices[corners[0]], vertices[corners[1]], vertices[corners[2]], triangleId);
    for (int k = 0; k < 3; ++k)
    {
      const int from = corners[k], to = corners[next(k)];
      if (from < size && to == (from + 1) % size)
      {
        glue(surface, first + k, loop[size - 1 - from]);
      }
      else
      {
        sides.push_back({ std::min(from, to), std::max(from, to), first + k });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    glue(surface, sides[i][2], sides[i + 1][2]);
  }
}

//------------------------------------------------------------------------------
std::vector<int> cutAlong(GluedSurface& surface, const std::vector<int>& loop)
{
  std::vector<int> right(loop.rbegin(), loop.rend());
  for (int& side : right)
  {
    side = surface.Across[side];
  }
  for (const int side : loop)
  {
    surface.Across[surface.Across[side]] = -1;
    surface.Across[side] = -1;
  }
  // Each side on the right begins at a vertex whose right fan is now open and ends with that side.
  for (const int first : right)
  {
    const int vertex = addCopy(surface, surface.from(first));
    for (int side = first; side >= 0; side = surface.counterClockwise(side))
    {
      surface.Corners[side] = vertex;
    }
  }
  return right;
}

//------------------------------------------------------------------------------
Index splitDoubleEdges(GluedSurface& surface)
{
  std::vector<int> all(surface.TriangleIds.size());
  std::iota(all.begin(), all.end(), 0);
  const EdgeSides sides =
    sidesByEdge(surface.Corners.data(), all, static_cast<Index>(surface.Positions.size()));
  std::vector<int> doubles; // one side of each edge to be split
  forEachEdge(sides,
    [&](Group first, Group last)
    {
      int others = 0;
      for (Group side = first; side != last; ++side)
      {
        const int across = surface.Across[side->Side];
        if (side->Side < across && ++others > 1)
        {
          doubles.push_back(side->Side);
        }
      }
    });
  for (const int side : doubles)
  {
    const int across = surface.Across[side];
    const Vector3 middle =
      0.5 * surface.Positions[surface.from(side)] + 0.5 * surface.Positions[surface.to(side)];
    const int vertex = addVertex(surface, middle, { surface.from(side), surface.to(side) });
    // Each triangle keeps its side up to the new vertex; the rest becomes a new triangle.
    std::array<int, 2> rest = {};
    for (const int k : { 0, 1 })
    {
      const int kept = k == 0 ? side : across;
      const int after = GluedSurface::after(kept), before = GluedSurface::before(kept);
      int& id = surface.TriangleIds[kept / 3];
      id = std::min(id, GluedSurface::Added);
      const int added = addTriangle(surface, vertex, surface.from(after), surface.from(before), id);
      if (surface.Across[after] >= 0)
      {
        glue(surface, added + 1, surface.Across[after]);
      }
      surface.Corners[after] = vertex;
      glue(surface, after, added + 2);
      rest[k] = added;
    }
    glue(surface, side, rest[1]);
    glue(surface, across, rest[0]);
  }
  return static_cast<Index>(doubles.size());
}
}
