#include "Geodesics/GeodesicPath.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::PathPoint;
using conformal::PathStraightener;
using conformal::Vector3;

namespace
{
// Return the shortest path along edges.
std::vector<int> alongEdges(const Mesh& mesh, int from, int to)
{
  const std::vector<int> ways = conformal::pathsAlongEdges(mesh, { to }).Ways;
  std::vector<int> path = { from };
  while (path.back() != to)
  {
    path.push_back(ways[path.back()]);
  }
  return path;
}

// Return whether each two successive points are in a triangle.
bool isOnSurface(const Mesh& mesh, const std::vector<PathPoint>& path)
{
  const conformal::Adjacency around =
    conformal::vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const auto hasAll = [&](int t)
    {
      const auto has = [&](int v) { return (mesh.Triangles.row(t).array() == v).any(); };
      return has(path[i].First) && has(path[i].Second) && has(path[i - 1].First) &&
        has(path[i - 1].Second);
    };
    if (std::none_of(around.begin(path[i].First), around.end(path[i].First), hasAll))
    {
      return false;
    }
  }
  return true;
}

// A square of n by n cells, without the cells for which `isHole` is true.
template <typename IsHole>
Mesh square(int n, const IsHole& isHole)
{
  Mesh mesh;
  mesh.Positions.resize((n + 1) * (n + 1), 3);
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const int a = j * (n + 1) + i;
      mesh.Positions.row(a) << i, j, 0.0;
      if (i < n && j < n && !isHole(i, j))
      {
        triangles.push_back({ a, a + 1, a + n + 2 });
        triangles.push_back({ a, a + n + 2, a + n + 1 });
      }
    }
  }
  mesh.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.Triangles.row(static_cast<Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return mesh;
}
}

TEST(GeodesicPath, IsStraightInAPlane)
{
  const Mesh mesh = square(12, [](int, int) { return false; });
  const PathStraightener surface(mesh);
  for (const auto& [from, to] : { std::pair(0, 12 * 13 + 5), std::pair(12, 12 * 13),
         std::pair(3, 9), std::pair(40, 131), std::pair(14, 15), std::pair(26, 166) })
  {
    const std::vector<PathPoint> path = surface.straighten(alongEdges(mesh, from, to));
    EXPECT_EQ(path.front().First, from);
    EXPECT_EQ(path.back().First, to);
    EXPECT_NEAR(lengthOf(path, mesh.Positions),
      (mesh.Positions.row(from) - mesh.Positions.row(to)).norm(), 1e-12)
      << from << " " << to;
  }
}

TEST(GeodesicPath, ReportsProgressAndStops)
{
  const Mesh mesh = square(40, [](int, int) { return false; });
  const std::vector<int> edges = alongEdges(mesh, 0, 20 * 41 + 40);
  const PathStraightener surface(mesh);
  runs::Watch watch;
  surface.straighten(edges, watch.run());
  EXPECT_GT(watch.calls(), 5);
  EXPECT_THROW(surface.straighten(edges, runs::stoppingAt(0.05)), conformal::Aborted);
}

TEST(GeodesicPath, GoesAroundHoles)
{
  // The hole has the corners (4, 2) and (8, 10).
  const Mesh mesh = square(12, [](int i, int j) { return i >= 4 && i < 8 && j >= 2 && j < 10; });
  const PathStraightener surface(mesh);
  const int from = 5 * 13, to = 5 * 13 + 12;
  const double around = 2.0 * std::hypot(4.0, 3.0) + 4.0; // below the hole
  EXPECT_NEAR(
    lengthOf(surface.straighten(alongEdges(mesh, from, to)), mesh.Positions), around, 1e-12);
}

TEST(GeodesicPath, UnfoldsAFold)
{
  Mesh box = square(8, [](int, int) { return false; });
  for (Index v = 0; v < box.Positions.rows(); ++v) // fold the square along x = 4 by a right angle
  {
    const double beyond = box.Positions(v, 0) - 4.0;
    if (beyond > 0.0)
    {
      box.Positions(v, 0) = 4.0;
      box.Positions(v, 2) = beyond;
    }
  }
  const PathStraightener surface(box);
  EXPECT_NEAR(lengthOf(surface.straighten(alongEdges(box, 9, 7 * 9 + 7)), box.Positions),
    std::hypot(7.0, 6.0), 1e-12);
}

TEST(GeodesicPath, FollowsGreatCircles)
{
  const Mesh sphere = conformal::makeGeodesicSphere(40);
  const PathStraightener surface(sphere);
  for (const auto& [from, to] : { std::pair(0, 9000), std::pair(77, 4321), std::pair(512, 15000) })
  {
    const std::vector<int> edges = alongEdges(sphere, from, to);
    const std::vector<PathPoint> path = surface.straighten(edges);
    const double angle =
      std::acos(Vector3(sphere.Positions.row(from)).dot(Vector3(sphere.Positions.row(to))));
    // The mesh is inside of the sphere.
    EXPECT_LT(lengthOf(path, sphere.Positions), angle);
    EXPECT_GT(lengthOf(path, sphere.Positions), angle * (1.0 - 2e-3));
  }
}

TEST(GeodesicPath, IsShorterThanPathsAlongEdgesOnBumps)
{
  Mesh mesh = conformal::makeGeodesicSphere(30);
  mesh.Positions = shapes::over(mesh.Positions,
    [](const Vector3& n) -> Vector3
    { return n * (1.0 + 0.2 * std::sin(6.0 * n.x()) * std::cos(5.0 * n.y())); });
  const PathStraightener surface(mesh);
  for (int from = 0; from < 8000; from += 997)
  {
    const std::vector<int> edges = alongEdges(mesh, from, 3);
    std::vector<PathPoint> along;
    for (const int v : edges)
    {
      along.push_back({ v, v, 0.0 });
    }
    EXPECT_TRUE(isOnSurface(mesh, surface.straighten(edges)));
    const double before = lengthOf(along, mesh.Positions),
                 after = lengthOf(surface.straighten(edges), mesh.Positions);
    EXPECT_LE(after, before * (1.0 + 1e-12));
    EXPECT_GT(after, 0.8 * before);
  }
}

TEST(GeodesicPath, PassesTrianglesWithoutAreaAndRejectsOtherSurfaces)
{
  Mesh mesh = square(4, [](int, int) { return false; });
  mesh.Positions.row(12) = mesh.Positions.row(13); // some triangles have no area
  const PathStraightener surface(mesh);
  for (const int from : { 0, 1, 5, 10, 12 })
  {
    const double length = lengthOf(surface.straighten(alongEdges(mesh, from, 24)), mesh.Positions);
    EXPECT_TRUE(std::isfinite(length));
    EXPECT_GE(length, (mesh.Positions.row(from) - mesh.Positions.row(24)).norm() - 1e-9);
  }
  mesh.Triangles.row(0) = mesh.Triangles.row(1);
  EXPECT_THROW(PathStraightener{ mesh }, std::invalid_argument);
}

TEST(GeodesicPath, FindsTheWayAlongEdges)
{
  const Mesh mesh = square(12, [](int i, int) { return i == 6; }); // two parts
  const std::vector<int> next = conformal::pathsAlongEdges(mesh, { 0, 12 }).Ways;
  EXPECT_EQ(next[0], 0);
  EXPECT_EQ(next[12], 12);
  int v = 12 * 13 + 3, count = 0;
  for (; next[v] != v; v = next[v], ++count)
  {
    ASSERT_LT(count, 40);
  }
  EXPECT_EQ(v, 0);
  const std::vector<int> ofOne = conformal::pathsAlongEdges(mesh, { 0 }).Ways;
  EXPECT_EQ(ofOne[12], -1);
}
