/// Make meshes with handles, by joining a tube to two holes of a mesh.
#ifndef ConformalTestHandles_h
#define ConformalTestHandles_h

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace handles
{
/// Points and triangles. Seen from outside, triangles are counter-clockwise.
struct Mesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<int, 3>> Triangles;
};

inline double distance(const Mesh& mesh, int a, int b)
{
  double square = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const double d = mesh.Points[a][c] - mesh.Points[b][c];
    square += d * d;
  }
  return std::sqrt(square);
}

/// Mark the points that a path of at most `edges` edges connects to a point.
inline std::vector<char> within(const Mesh& mesh, int point, int edges)
{
  std::vector<char> isNear(mesh.Points.size(), 0);
  isNear[point] = 1;
  for (int i = 0; i < edges; ++i)
  {
    const std::vector<char> before = isNear;
    for (const auto& ids : mesh.Triangles)
    {
      if (before[ids[0]] || before[ids[1]] || before[ids[2]])
      {
        isNear[ids[0]] = isNear[ids[1]] = isNear[ids[2]] = 1;
      }
    }
  }
  return isNear;
}

/// Remove the triangles of a disk around a point. The radius of the disk is `edges` edges.
/// @return the points of the rim, in the direction of the remaining triangles
inline std::vector<int> cutDisk(Mesh& mesh, int point, int edges)
{
  const std::vector<char> inner = within(mesh, point, edges - 1);
  const auto isInner = [&](const std::array<int, 3>& ids)
  { return inner[ids[0]] || inner[ids[1]] || inner[ids[2]]; };
  std::map<int, int> after; // next point on the rim, against the direction of the disk
  for (const auto& ids : mesh.Triangles)
  {
    for (int k = 0; k < 3 && isInner(ids); ++k)
    {
      const int from = ids[k], to = ids[(k + 1) % 3];
      if (!inner[from] && !inner[to])
      {
        after[to] = from;
      }
    }
  }
  mesh.Triangles.erase(
    std::remove_if(mesh.Triangles.begin(), mesh.Triangles.end(), isInner), mesh.Triangles.end());
  std::vector<int> rim = { after.begin()->first };
  while (after.at(rim.back()) != rim.front())
  {
    rim.push_back(after.at(rim.back()));
  }
  if (rim.size() != after.size())
  {
    throw std::logic_error("disks overlap");
  }
  return rim;
}

/// Remove two disks, and join their rims by a tube.
/// @param[in] a, b    points at the centers of the disks
/// @param[in] edges   radius of the disks, in edges
/// @param[in] length  number of rings of triangles in the tube
/// @param[in] isBent  whether the tube is an arch that points away from the origin; otherwise it is
///   straight
/// @return the number of points around the tube
inline int addTube(Mesh& mesh, int a, int b, int edges, int length, bool isBent)
{
  std::vector<int> first = cutDisk(mesh, a, edges), last = cutDisk(mesh, b, edges);
  if (first.size() != last.size())
  {
    throw std::logic_error("rims differ");
  }
  std::reverse(last.begin(), last.end());
  const std::size_t size = first.size();
  const auto mismatch = [&](std::size_t shift)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double d = mesh.Points[first[i]][c] - mesh.Points[last[(i + shift) % size]][c];
        sum += d * d;
      }
    }
    return sum;
  };
  std::size_t best = 0;
  for (std::size_t shift = 1; shift < size; ++shift)
  {
    best = mismatch(shift) < mismatch(best) ? shift : best;
  }
  std::rotate(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(best), last.end());
  std::array<double, 3> up = {};
  const double norm = std::hypot(mesh.Points[a][0] + mesh.Points[b][0],
    mesh.Points[a][1] + mesh.Points[b][1], mesh.Points[a][2] + mesh.Points[b][2]);
  for (int c = 0; c < 3 && isBent; ++c)
  {
    up[c] = (mesh.Points[a][c] + mesh.Points[b][c]) / norm;
  }
  std::vector<int> ring = first;
  for (int step = 1; step <= length; ++step)
  {
    std::vector<int> next = last;
    const double t = static_cast<double>(step) / length, turn = 3.14159265358979 * t;
    const double toFirst = isBent ? 0.5 + 0.5 * std::cos(turn) : 1.0 - t;
    for (std::size_t i = 0; i < size && step < length; ++i)
    {
      next[i] = static_cast<int>(mesh.Points.size());
      const double rise = isBent ? 0.5 * distance(mesh, first[i], last[i]) * std::sin(turn) : 0.0;
      const auto p = mesh.Points[first[i]], q = mesh.Points[last[i]];
      mesh.Points.push_back({});
      for (int c = 0; c < 3; ++c)
      {
        mesh.Points.back()[c] = toFirst * p[c] + (1.0 - toFirst) * q[c] + rise * up[c];
      }
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t j = (i + 1) % size;
      mesh.Triangles.push_back({ ring[j], ring[i], next[i] });
      mesh.Triangles.push_back({ ring[j], next[i], next[j] });
    }
    ring = next;
  }
  return static_cast<int>(size);
}

/// Return `count` points of a mesh that are spread over the mesh. Each point has the largest
/// possible distance from the points before it.
inline std::vector<int> spread(const Mesh& mesh, int count, int first)
{
  std::vector<int> taken = { first };
  std::vector<double> distances(mesh.Points.size(), 1e300);
  while (static_cast<int>(taken.size()) < count)
  {
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      distances[i] = std::min(distances[i], distance(mesh, static_cast<int>(i), taken.back()));
    }
    taken.push_back(
      static_cast<int>(std::max_element(distances.begin(), distances.end()) - distances.begin()));
  }
  return taken;
}

/// Add handles that are spread over a sphere. Each handle is an arched tube between two points of
/// the sphere, with 6 times `edges` edges around.
/// @param[in] edges   radius of the disks that are removed, in edges
/// @param[in] apart   distance between the ends of a handle
/// @param[in] length  number of rings of triangles in each tube
inline void addHandles(Mesh& mesh, int count, int edges, double apart, int length)
{
  const auto isEven = [&](int point) // no vertex with five neighbors nearby
  {
    Mesh copy = mesh;
    return static_cast<int>(cutDisk(copy, point, edges).size()) == 6 * edges;
  };
  const int numberOfPoints = static_cast<int>(mesh.Points.size());
  const auto nearest = [&](int point, double wanted)
  {
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < numberOfPoints; ++i)
    {
      order.emplace_back(std::abs(distance(mesh, point, i) - wanted), i);
    }
    std::sort(order.begin(), order.end());
    return *std::find_if(order.begin(), order.end(),
      [&](const std::pair<double, int>& each) { return isEven(each.second); });
  };
  for (const int point : spread(mesh, count, 20))
  {
    const int a = nearest(point, 0.0).second, b = nearest(a, apart).second;
    addTube(mesh, a, b, edges, length, true);
  }
}
}

#endif
