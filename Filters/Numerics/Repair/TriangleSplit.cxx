#include "Repair/TriangleSplit.h"

#include "Base/NumericalFailure.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace conformal
{
namespace
{
using Corners = std::array<int, 3>;
using Edge = std::array<int, 2>;

// Triangulation that grows by points and changes by flips.
class Split
{
public:
  explicit Split(const TriangleSplitInput& input)
    : Positions(input.Positions)
  {
    this->set(0, { 0, 1, 2 });
  }

  void addOnEdge(int point, int from, int to)
  {
    const Place place = this->find(from, to);
    const Corners part = this->Parts[place.Part];
    const int apex = part[previous(place.Corner)];
    this->Places.erase({ from, to });
    this->set(place.Part, { from, point, apex });
    this->set(this->size(), { point, to, apex });
  }

  void addInside(int point)
  {
    Place best;
    double largest = 0.0; // smallest barycentric coordinate in the best triangle
    for (int i = 0; i < this->size(); ++i)
    {
      const Corners& part = this->Parts[i];
      const double whole = this->area(part[0], part[1], part[2]);
      Place place{ i, 0 };
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k)
      {
        const double coordinate = this->area(point, part[k], part[next(k)]) / whole;
        if (coordinate < least)
        {
          least = coordinate;
          place.Corner = k;
        }
      }
      if (whole > 0.0 && (best.Part < 0 || least > largest))
      {
        largest = least;
        best = place;
      }
    }
    const Corners part = this->Parts[best.Part];
    const int a = part[best.Corner], b = part[next(best.Corner)], c = part[previous(best.Corner)];
    const Place across = this->find(b, a);
    if (largest < NearEdge && across.Part >= 0)
    {
      const int d = this->Parts[across.Part][previous(across.Corner)];
      this->Places.erase({ a, b });
      this->Places.erase({ b, a });
      this->set(best.Part, { a, point, c });
      this->set(across.Part, { point, a, d });
      this->set(this->size(), { point, b, c });
      this->set(this->size(), { b, point, d });
      this->makeDelaunay({ sortedIds(b, c), sortedIds(c, a), sortedIds(a, d), sortedIds(d, b) });
      return;
    }
    if (!(largest > Smallest))
    {
      throw NumericalFailure("a point is on an edge of the triangle");
    }
    this->set(best.Part, { a, b, point });
    this->set(this->size(), { b, c, point });
    this->set(this->size(), { c, a, point });
    this->makeDelaunay({ sortedIds(a, b), sortedIds(b, c), sortedIds(c, a) });
  }

  void connect(int a, int b)
  {
    this->Fixed.insert(sortedIds(a, b));
    std::deque<Edge> crossing;
    for (const Corners& part : this->Parts)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int p = part[k], q = part[next(k)];
        if (p < q && this->cross(a, b, p, q))
        {
          crossing.push_back({ p, q });
        }
      }
    }
    for (std::size_t left = 64 + 8 * crossing.size() * crossing.size(); !crossing.empty(); --left)
    {
      const Edge edge = crossing.front();
      crossing.pop_front();
      if (left == 0 || this->Fixed.count(edge) > 0)
      {
        throw NumericalFailure("two segments cross each other");
      }
      const Edge flipped = this->flip(edge);
      if (flipped == edge || this->cross(a, b, flipped[0], flipped[1]))
      {
        crossing.push_back(flipped);
      }
    }
    if (this->find(a, b).Part < 0 && this->find(b, a).Part < 0)
    {
      throw NumericalFailure("a segment passes through a point");
    }
  }

  void makeDelaunay()
  {
    std::vector<Edge> edges;
    for (const auto& entry : this->Places)
    {
      edges.push_back(sortedIds(entry.first[0], entry.first[1]));
    }
    this->makeDelaunay(std::move(edges));
  }

  const std::vector<Corners>& parts() const { return this->Parts; }

private:
  static constexpr double Smallest = 1e-12; // least fraction of an area that is above rounding
  // A point whose smallest barycentric coordinate is below this value splits the edge.
  static constexpr double NearEdge = 1e-6;

  struct Place
  {
    int Part = -1, Corner = 0;
  };

  double area(int a, int b, int c) const
  {
    const Eigen::Vector2d u = this->Positions[b] - this->Positions[a],
                          v = this->Positions[c] - this->Positions[a];
    return u.x() * v.y() - u.y() * v.x();
  }

  // Flip edges, and then the edges around them, until all are locally Delaunay.
  void makeDelaunay(std::vector<Edge> edges)
  {
    for (std::size_t left = 64 * (edges.size() + this->Parts.size()); left > 0 && !edges.empty();
         --left)
    {
      const Edge edge = edges.back();
      edges.pop_back();
      if (this->Fixed.count(edge) > 0 || !this->isPoor(edge))
      {
        continue;
      }
      const Edge other = this->flip(edge);
      if (other != edge)
      {
        for (const int end : edge)
        {
          edges.push_back(sortedIds(end, other[0]));
          edges.push_back(sortedIds(end, other[1]));
        }
      }
    }
  }

  int size() const { return static_cast<int>(this->Parts.size()); }

  void set(int part, const Corners& corners)
  {
    this->Parts.resize(std::max(this->Parts.size(), static_cast<std::size_t>(part) + 1));
    this->Parts[part] = corners;
    for (int k = 0; k < 3; ++k)
    {
      this->Places[{ corners[k], corners[next(k)] }] = { part, k };
    }
  }

  // Find the triangle in which an edge runs from a to b.
  Place find(int a, int b) const
  {
    const auto found = this->Places.find({ a, b });
    return found == this->Places.end() ? Place() : found->second;
  }

  bool cross(int a, int b, int p, int q) const
  {
    if (a == p || a == q || b == p || b == q)
    {
      return false;
    }
    return this->area(a, b, p) * this->area(a, b, q) < 0.0 &&
      this->area(p, q, a) * this->area(p, q, b) < 0.0;
  }

  // Return whether the sum of the angles opposite to an edge is above 180 degrees.
  bool isPoor(const Edge& edge) const
  {
    const Place left = this->find(edge[0], edge[1]), right = this->find(edge[1], edge[0]);
    if (left.Part < 0 || right.Part < 0)
    {
      return false;
    }
    const auto cotangent = [&](const Place& place)
    {
      const Corners& part = this->Parts[place.Part];
      const int apex = part[previous(place.Corner)];
      const Eigen::Vector2d u = this->Positions[edge[0]] - this->Positions[apex],
                            v = this->Positions[edge[1]] - this->Positions[apex];
      const double twice = this->area(part[0], part[1], part[2]);
      return twice > 0.0 ? u.dot(v) / twice : 0.0;
    };
    return cotangent(left) + cotangent(right) < -1e-9;
  }

  // Replace the edge between two triangles by the other diagonal of their quadrilateral, if it is
  // convex. Return the edge that is then there.
  Edge flip(const Edge& edge)
  {
    const Place left = this->find(edge[0], edge[1]), right = this->find(edge[1], edge[0]);
    if (left.Part < 0 || right.Part < 0)
    {
      return edge;
    }
    const int c = this->Parts[left.Part][previous(left.Corner)],
              d = this->Parts[right.Part][previous(right.Corner)];
    const double whole = this->area(edge[0], edge[1], c) + this->area(edge[1], edge[0], d);
    if (!(this->area(edge[0], d, c) > Smallest * whole) ||
      !(this->area(d, edge[1], c) > Smallest * whole))
    {
      return edge;
    }
    this->Places.erase({ edge[0], edge[1] });
    this->Places.erase({ edge[1], edge[0] });
    this->set(left.Part, { edge[0], d, c });
    this->set(right.Part, { d, edge[1], c });
    return sortedIds(c, d);
  }

  const std::vector<Eigen::Vector2d>& Positions;
  std::vector<Corners> Parts;
  std::map<Edge, Place> Places; // of the directed edges of all triangles
  std::set<Edge> Fixed;
};
}

//------------------------------------------------------------------------------
std::vector<std::array<int, 3>> splitTriangle(const TriangleSplitInput& input, const Run& run)
{
  Split split(input);
  std::vector<char> isOnEdge(input.Positions.size(), 0);
  for (int k = 0; k < 3; ++k)
  {
    isOnEdge[k] = 1;
    int from = k;
    for (const int point : input.OnEdges[k])
    {
      split.addOnEdge(point, from, next(k));
      isOnEdge[point] = 1;
      from = point;
    }
  }
  const auto steps = static_cast<double>(input.Positions.size() + input.Segments.size());
  double done = 0.0;
  for (std::size_t point = 0; point < input.Positions.size(); ++point)
  {
    run.report(done++ / steps);
    if (!isOnEdge[point])
    {
      split.addInside(static_cast<int>(point));
    }
  }
  for (const std::array<int, 2>& segment : input.Segments)
  {
    run.report(done++ / steps);
    split.connect(segment[0], segment[1]);
  }
  split.makeDelaunay();
  return split.parts();
}
}
