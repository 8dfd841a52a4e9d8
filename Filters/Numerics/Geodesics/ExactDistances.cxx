#include "Geodesics/ExactDistances.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace conformal
{
namespace
{
using Vector2 = Eigen::Vector2d;
constexpr double TinyFraction = 1e-12; // of the largest distance, and of edges

// Return the position on the line from (0, 0) along a unit vector where a ray from a point crosses
// the line.
double crossingOf(const Vector2& along, const Vector2& from, const Vector2& ray)
{
  return along.dot(from - cross(along, from) / cross(along, ray) * ray);
}

// Return 1 for each vertex where shortest paths can bend: on borders, and where the sum of angles
// is greater than 2 pi.
std::vector<char> verticesOfBends(const Mesh& mesh, const Triangles& neighbors)
{
  constexpr double tolerance = 1e-9;
  std::vector<double> angles(mesh.Positions.rows(), 0.0);
  std::vector<char> bends(mesh.Positions.rows(), 0);
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Triangles(t, k), b = mesh.Triangles(t, next(k)),
                c = mesh.Triangles(t, previous(k));
      const Vector3 here = mesh.Positions.row(a);
      angles[a] +=
        angleBetween(Vector3(mesh.Positions.row(b)) - here, Vector3(mesh.Positions.row(c)) - here);
      if (neighbors(t, k) < 0)
      {
        bends[a] = bends[b] = 1;
      }
    }
  }
  for (std::size_t v = 0; v < bends.size(); ++v)
  {
    bends[v] |= angles[v] > 2.0 * EIGEN_PI + tolerance ? 1 : 0;
  }
  return bends;
}
}

//------------------------------------------------------------------------------
bool ExactDistances::Event::operator>(const Event& other) const
{
  return this->Distance != other.Distance ? this->Distance > other.Distance
    : this->Vertex != other.Vertex        ? this->Vertex > other.Vertex
                                          : this->Window > other.Window;
}

//------------------------------------------------------------------------------
ExactDistances::ExactDistances(const Mesh& mesh, const std::vector<int>& sources, const Run& run)
  : Surface(mesh)
  , Sources(sources)
{
  requireSimpleEdges(mesh);
  this->Around = vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  this->Neighbors = triangleNeighbors(mesh.Triangles, this->Around);
  this->Bends = verticesOfBends(mesh, this->Neighbors);
  this->Planes.resize(mesh.Triangles.size());
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 start = mesh.Positions.row(mesh.Triangles(t, next(k))),
                    edge = Vector3(mesh.Positions.row(mesh.Triangles(t, previous(k)))) - start,
                    side = Vector3(mesh.Positions.row(mesh.Triangles(t, k))) - start;
      Plane& plane = this->Planes[3 * t + k];
      plane.Length = edge.norm();
      plane.Apex = plane.Length > 0.0
        ? Vector2(edge.dot(side) / plane.Length, edge.cross(side).norm() / plane.Length)
        : Vector2(0.0, side.norm());
    }
  }
  this->Occupants.assign(this->Planes.size(), { std::numeric_limits<double>::infinity(), 0.0 });
  this->startFromEdges();
  this->propagate(run);
  this->Queue = {};
  this->Windows = {};
  this->Free = {};
  this->Occupants = {};
  run.report(1.0);
}

// Bound distances by paths along edges. Windows start at sources, and where paths can bend.
void ExactDistances::startFromEdges()
{
  EdgePaths paths = pathsAlongEdges(this->Surface, this->Sources);
  const int size = static_cast<int>(paths.Lengths.size());
  this->Arrivals.resize(size);
  for (int v = 0; v < size; ++v)
  {
    this->Arrivals[v].Origin = paths.Ways[v];
    this->Tolerance = std::max(this->Tolerance, TinyFraction * paths.Lengths[v]);
    if (paths.Ways[v] == v || (paths.Ways[v] >= 0 && this->Bends[v]))
    {
      this->push({ paths.Lengths[v], v, -1 });
    }
  }
  this->Distances = std::move(paths.Lengths);
}

void ExactDistances::push(const Event& event)
{
  this->Queue.push_back(event);
  std::push_heap(this->Queue.begin(), this->Queue.end(), std::greater<>());
}

void ExactDistances::propagate(const Run& run)
{
  constexpr int chunk = 1 << 14;
  const double farthest = *std::max_element(this->Distances.begin(), this->Distances.end());
  for (int i = 1; !this->Queue.empty(); ++i)
  {
    std::pop_heap(this->Queue.begin(), this->Queue.end(), std::greater<>());
    const Event event = this->Queue.back();
    this->Queue.pop_back();
    if (event.Window >= 0)
    {
      const Window window = this->Windows[event.Window];
      this->Free.push_back(event.Window);
      this->continueWindow(window);
    }
    else if (event.Distance == this->Distances[event.Vertex])
    {
      this->startWindows(event.Vertex);
    }
    if (i % chunk == 0)
    {
      run.report(std::min(1.0, event.Distance / farthest));
      i = 0;
    }
  }
}

// Follow the edges of a vertex, and start windows at the opposite edges.
void ExactDistances::startWindows(int vertex)
{
  const double distance = this->Distances[vertex];
  Arrival along;
  along.Origin = vertex;
  for (const int* t = this->Around.begin(vertex); t != this->Around.end(vertex); ++t)
  {
    const auto ids = this->Surface.Triangles.row(*t);
    const int corner = cornerOf(this->Surface.Triangles, *t, vertex);
    const Plane& plane = this->Planes[3 * *t + corner];
    const int start = ids[next(corner)], end = ids[previous(corner)];
    this->reach(start, distance + plane.Apex.norm(), along);
    this->reach(end, distance + (plane.Apex - Vector2(plane.Length, 0.0)).norm(), along);
    // In the plane of the neighbor, the edge starts at `end`.
    Window window;
    window.Triangle = this->Neighbors(*t, next(corner));
    window.Origin = vertex;
    window.End = plane.Length;
    window.Before = distance;
    window.Place = Vector2(plane.Length - plane.Apex.x(), -plane.Apex.y());
    if (this->isUseful(window, plane.Length, end, start))
    {
      this->add(window, end);
    }
  }
}

// Continue a window to the apex of its triangle, and to the two edges at the apex.
void ExactDistances::continueWindow(const Window& window)
{
  const int triangle = window.Triangle, corner = window.Corner;
  const auto ids = this->Surface.Triangles.row(triangle);
  const int start = ids[next(corner)], end = ids[previous(corner)], apex = ids[corner];
  const Plane& plane = this->Planes[3 * triangle + corner];
  const Vector2 toApex = plane.Apex - window.Place,
                first = Vector2(window.Begin, 0.0) - window.Place,
                last = Vector2(window.End, 0.0) - window.Place;
  // Paths cross the edge from start to apex if the apex is right of the first ray, and the edge
  // from apex to end if the apex is left of the last ray.
  constexpr double closeness = 1e-9;
  const double tolerance = TinyFraction * plane.Length * toApex.norm();
  bool goesLeft = cross(first, toApex) <= tolerance, goesRight = cross(last, toApex) >= -tolerance;
  const bool seesApex = goesLeft && goesRight;
  if (seesApex)
  {
    const double distance = window.Before + toApex.norm(),
                 crossing = toApex.y() > 0.0
      ? window.Place.x() - toApex.x() * window.Place.y() / toApex.y()
      : 0.5 * (window.Begin + window.End);
    Occupant& occupant = this->Occupants[3 * triangle + corner];
    if (distance < occupant.Distance)
    {
      occupant = { distance, crossing };
      this->reach(apex, distance, { window.Origin, triangle, corner, window.Place });
    }
    else // shortest paths do not cross those of the occupant, but can end with the same part
    {
      const double margin = closeness * plane.Length;
      goesRight = occupant.Crossing < crossing + margin;
      goesLeft = occupant.Crossing > crossing - margin;
    }
  }
  Window child = window;
  const double lengthOfLeft = this->Planes[3 * triangle + previous(corner)].Length,
               lengthOfRight = this->Planes[3 * triangle + next(corner)].Length;
  if (goesLeft && lengthOfLeft > 0.0)
  {
    const Vector2 along = plane.Apex / lengthOfLeft;
    child.Triangle = this->Neighbors(triangle, corner);
    child.Begin = std::max(0.0, crossingOf(along, window.Place, first));
    child.End =
      seesApex ? lengthOfLeft : std::min(lengthOfLeft, crossingOf(along, window.Place, last));
    child.Place = Vector2(along.dot(window.Place), cross(along, window.Place));
    const Vector2 begin = child.Begin * along;
    // Paths that cross the line from `end` to the begin of the child.
    if (this->isShorter(window.Before + (begin - window.Place).norm(), end,
          (begin - Vector2(plane.Length, 0.0)).norm()) &&
      this->isUseful(child, lengthOfLeft, start, apex))
    {
      this->add(child, start);
    }
  }
  if (goesRight && lengthOfRight > 0.0)
  {
    const Vector2 along = (Vector2(plane.Length, 0.0) - plane.Apex) / lengthOfRight,
                  from = window.Place - plane.Apex;
    child.Triangle = this->Neighbors(triangle, previous(corner));
    child.Begin = seesApex ? 0.0 : std::max(0.0, crossingOf(along, from, first));
    child.End = std::min(lengthOfRight, crossingOf(along, from, last));
    child.Place = Vector2(along.dot(from), cross(along, from));
    const Vector2 finish = plane.Apex + child.End * along;
    if (this->isShorter(window.Before + (finish - window.Place).norm(), start, finish.norm()) &&
      this->isUseful(child, lengthOfRight, apex, end))
    {
      this->add(child, apex);
    }
  }
}

// Return whether a path is shorter than one over a vertex, whose rest has a given length. If both
// are equally long, paths continue from the vertex, since no window contains them.
bool ExactDistances::isShorter(double length, int vertex, double rest)
{
  const double difference = length - this->Distances[vertex] - rest;
  if (std::abs(difference) <= this->Tolerance && !this->Bends[vertex])
  {
    this->Bends[vertex] = 1;
    this->push({ this->Distances[vertex], vertex, -1 });
  }
  return difference < -this->Tolerance;
}

// Return whether paths through a window can be shortest: those over the start of the edge to the
// end of the window, or over the end of the edge to its begin, are longer.
bool ExactDistances::isUseful(const Window& window, double length, int start, int end)
{
  const double toBegin = (Vector2(window.Begin, 0.0) - window.Place).norm(),
               toEnd = (Vector2(window.End, 0.0) - window.Place).norm();
  return window.Triangle >= 0 && window.End - window.Begin > TinyFraction * length &&
    this->isShorter(window.Before + toEnd, start, window.End) &&
    this->isShorter(window.Before + toBegin, end, length - window.Begin);
}

// Store a window of the edge that starts at a vertex.
void ExactDistances::add(Window window, int start)
{
  window.Corner = previous(cornerOf(this->Surface.Triangles, window.Triangle, start));
  const double nearest = std::clamp(window.Place.x(), window.Begin, window.End);
  const double distance = window.Before + (Vector2(nearest, 0.0) - window.Place).norm();
  int place = static_cast<int>(this->Windows.size());
  if (this->Free.empty())
  {
    this->Windows.push_back(window);
  }
  else
  {
    place = this->Free.back();
    this->Free.pop_back();
    this->Windows[place] = window;
  }
  this->push({ distance, -1, place });
}

void ExactDistances::reach(int vertex, double distance, const Arrival& arrival)
{
  if (distance < this->Distances[vertex] - this->Tolerance)
  {
    this->Distances[vertex] = distance;
    this->Arrivals[vertex] = arrival;
    if (this->Bends[vertex])
    {
      this->push({ distance, vertex, -1 });
    }
  }
}

//------------------------------------------------------------------------------
NearestSources ExactDistances::nearestSources() const
{
  const int size = static_cast<int>(this->Distances.size());
  NearestSources result;
  result.Distances = Eigen::Map<const Eigen::VectorXd>(this->Distances.data(), size);
  result.Positions.assign(size, -1);
  for (std::size_t s = this->Sources.size(); s-- > 0;)
  {
    result.Positions[this->Sources[s]] = static_cast<int>(s);
  }
  std::vector<int> way;
  for (int v = 0; v < size; ++v)
  {
    int at = v;
    for (; at >= 0 && result.Positions[at] < 0; at = this->Arrivals[at].Origin)
    {
      way.push_back(at);
    }
    for (; !way.empty(); way.pop_back())
    {
      result.Positions[way.back()] = at >= 0 ? result.Positions[at] : -1;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<PathPoint> ExactDistances::pathFrom(int vertex) const
{
  std::vector<PathPoint> path = { { vertex, vertex, 0.0 } };
  for (int v = vertex; this->Arrivals[v].Origin != v; v = this->Arrivals[v].Origin)
  {
    if (this->Arrivals[v].Triangle >= 0)
    {
      this->followStraight(v, path);
    }
    path.push_back({ this->Arrivals[v].Origin, this->Arrivals[v].Origin, 0.0 });
  }
  return path;
}

// Add the points where the last straight part of the path to a vertex crosses edges, from the
// vertex to the origin.
void ExactDistances::followStraight(int vertex, std::vector<PathPoint>& path) const
{
  constexpr double closeness = 1e-6;
  const Triangles& triangles = this->Surface.Triangles;
  const Arrival& arrival = this->Arrivals[vertex];
  const Plane& first = this->Planes[3 * arrival.Triangle + arrival.Corner];
  const Vector2 from = first.Apex, direction = arrival.Place - from;
  // The edge to cross: its right and left vertex, and their places.
  int right = triangles(arrival.Triangle, next(arrival.Corner)),
      left = triangles(arrival.Triangle, previous(arrival.Corner));
  Vector2 rightPlace = Vector2::Zero(), leftPlace(first.Length, 0.0);
  int triangle = this->Neighbors(arrival.Triangle, next(arrival.Corner));
  for (Index i = 0; i < triangles.rows() && triangle >= 0; ++i)
  {
    const Vector2 edge = leftPlace - rightPlace;
    const double whole = cross(edge, direction);
    const double fraction = whole != 0.0 ? cross(from - rightPlace, direction) / whole : 0.5;
    path.push_back({ right, left, std::clamp(fraction, 0.0, 1.0) });
    const auto ids = triangles.row(triangle);
    const int corner = previous(cornerOf(triangles, triangle, left)); // the edge starts at `left`
    const Plane& plane = this->Planes[3 * triangle + corner];
    const Vector2 along = plane.Length > 0.0 ? Vector2(-edge / plane.Length) : Vector2(1.0, 0.0);
    const Vector2 apex =
      leftPlace + plane.Apex.x() * along + plane.Apex.y() * Vector2(-along.y(), along.x());
    if (ids[corner] == arrival.Origin &&
      (apex - arrival.Place).norm() <= closeness * (direction.norm() + plane.Length))
    {
      return;
    }
    if (cross(direction, apex - from) > 0.0) // the path passes right of the apex
    {
      left = ids[corner];
      leftPlace = apex;
      triangle = this->Neighbors(triangle, previous(corner));
    }
    else
    {
      right = ids[corner];
      rightPlace = apex;
      triangle = this->Neighbors(triangle, corner);
    }
  }
}
}
