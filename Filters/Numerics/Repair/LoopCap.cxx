#include "Repair/LoopCap.h"

#include "Mesh/Mesh.h"
#include "Mesh/PolygonTriangulation.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace conformal
{
namespace
{
// Compute the center, weighted by edge lengths, so that it does not depend on the subdivision of
// the edges.
Vector3 middleOf(const Points& corners)
{
  Vector3 sum = Vector3::Zero();
  double length = 0.0;
  for (Index i = 0; i < corners.rows(); ++i)
  {
    const Vector3 a = corners.row(i), b = corners.row((i + 1) % corners.rows());
    const double weight = (b - a).norm();
    sum += 0.5 * weight * (a + b);
    length += weight;
  }
  return length > 0.0 ? Vector3(sum / length) : Vector3(corners.row(0));
}

// Ring of vertices, with the corners nearest to each vertex.
struct CapRing
{
  std::vector<int> Ids;
  std::vector<std::pair<int, int>> Parents;
  Points Around; ///< means of corner positions, before contraction to the center

  int size() const { return static_cast<int>(this->Ids.size()); }
};

CapRing outermost(const Points& corners)
{
  CapRing ring;
  ring.Ids.resize(corners.rows());
  std::iota(ring.Ids.begin(), ring.Ids.end(), 0);
  for (const int i : ring.Ids)
  {
    ring.Parents.emplace_back(i, i + 1);
  }
  ring.Around = corners;
  return ring;
}

// Make the inner ring. Each vertex belongs to two vertices of the outer ring; the last vertex may
// belong to one.
CapRing halved(const CapRing& outer, int firstId)
{
  const int count = (outer.size() + 1) / 2;
  CapRing ring;
  ring.Around.resize(count, 3);
  for (int j = 0; j < count; ++j)
  {
    const int a = 2 * j, b = std::min(2 * j + 1, outer.size() - 1);
    ring.Ids.push_back(firstId + j);
    ring.Parents.emplace_back(outer.Parents[a].first, outer.Parents[b].second);
    ring.Around.row(j) = 0.5 * outer.Around.row(a) + 0.5 * outer.Around.row(b);
  }
  return ring;
}

using CapTriangles = std::vector<std::array<int, 3>>;

void addStrip(const CapRing& outer, const CapRing& inner, CapTriangles& triangles)
{
  for (int j = 0; j < inner.size(); ++j)
  {
    const int last = std::min(2 * j + 1, outer.size() - 1);
    const int here = inner.Ids[j], there = inner.Ids[(j + 1) % inner.size()];
    if (last > 2 * j)
    {
      triangles.push_back({ outer.Ids[2 * j], outer.Ids[last], here });
    }
    const int after = outer.Ids[(last + 1) % outer.size()];
    triangles.push_back({ outer.Ids[last], after, there });
    triangles.push_back({ outer.Ids[last], there, here });
  }
}

void addFan(const CapRing& ring, int middle, CapTriangles& triangles)
{
  for (int j = 0; j < ring.size(); ++j)
  {
    triangles.push_back({ ring.Ids[j], ring.Ids[(j + 1) % ring.size()], middle });
  }
}

Triangles toTriangles(const CapTriangles& corners)
{
  return Eigen::Map<const Triangles>(
    corners.empty() ? nullptr : corners.front().data(), static_cast<Index>(corners.size()), 3);
}

// Make rings until a ring has at most the given number of vertices. This ring is closed by a fan.
LoopCap ringsOf(const Points& corners, int maximumOfFan)
{
  // Distance between rings around a circle, in edges of the outer ring, times 2 pi.
  constexpr double pitch = 1.3 * 2.0 * Pi;
  constexpr double minimum = 0.35; // minimum radius of a ring, relative to the outer ring
  const Vector3 middle = middleOf(corners);
  const auto size = static_cast<int>(corners.rows());
  LoopCap cap;
  CapTriangles triangles;
  std::vector<Vector3> added;
  CapRing ring = outermost(corners);
  double radius = 1.0;
  while (ring.size() > maximumOfFan)
  {
    const CapRing inner = halved(ring, size + static_cast<int>(added.size()));
    radius *= std::max(minimum, 1.0 - pitch / ring.size());
    for (int j = 0; j < inner.size(); ++j)
    {
      added.emplace_back(middle + radius * (inner.Around.row(j).transpose() - middle));
      cap.Parents.push_back(inner.Parents[j]);
    }
    addStrip(ring, inner, triangles);
    ring = inner;
  }
  addFan(ring, size + static_cast<int>(added.size()), triangles);
  added.push_back(middle);
  cap.Parents.emplace_back(0, size);
  cap.Triangles = toTriangles(triangles);
  cap.Added.resize(static_cast<Index>(added.size()), 3);
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    cap.Added.row(static_cast<Index>(i)) = added[i];
  }
  return cap;
}

Points positionsOf(const LoopCap& cap, const Points& corners)
{
  Points all(corners.rows() + cap.Added.rows(), 3);
  all << corners, cap.Added;
  return all;
}

// Return whether a triangle is oriented against the mean normal of the cap.
bool folds(const LoopCap& cap, const Points& corners)
{
  const Points positions = positionsOf(cap, corners);
  Vector3 normal = Vector3::Zero();
  for (Index r = 0; r < cap.Triangles.rows(); ++r)
  {
    normal += areaVector(positions, cap.Triangles, r);
  }
  for (Index r = 0; r < cap.Triangles.rows(); ++r)
  {
    if (areaVector(positions, cap.Triangles, r).dot(normal) < 0.0)
    {
      return true;
    }
  }
  return false;
}

bool joinsAnew(const Triangles& triangles, int size, const std::function<bool(int, int)>& isJoined)
{
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangles(r, k), j = triangles(r, next(k));
      const bool isSide = (i + 1) % size == j || (j + 1) % size == i;
      if (!isSide && isJoined(i, j))
      {
        return true;
      }
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
LoopCap capLoop(const Points& corners, const std::function<bool(int, int)>& isJoined)
{
  if (corners.rows() == 3)
  {
    LoopCap cap;
    cap.Triangles.resize(1, 3);
    cap.Triangles << 0, 1, 2;
    cap.Added.resize(0, 3);
    return cap;
  }
  constexpr int maximumOfFan = 10;
  LoopCap rings = ringsOf(corners, maximumOfFan);
  if (!folds(rings, corners))
  {
    return rings;
  }
  LoopCap ears;
  ears.Triangles = triangulatePolygon(corners);
  ears.Added.resize(0, 3);
  const bool fits = ears.Triangles.rows() == corners.rows() - 2 &&
    !joinsAnew(ears.Triangles, static_cast<int>(corners.rows()), isJoined);
  return fits ? ears : rings;
}

//------------------------------------------------------------------------------
LoopCap fanOf(const Points& corners)
{
  return ringsOf(corners, static_cast<int>(corners.rows()));
}

//------------------------------------------------------------------------------
double areaOf(const LoopCap& cap, const Points& corners)
{
  const Points positions = positionsOf(cap, corners);
  double area = 0.0;
  for (Index r = 0; r < cap.Triangles.rows(); ++r)
  {
    area += areaVector(positions, cap.Triangles, r).norm();
  }
  return area;
}
}
