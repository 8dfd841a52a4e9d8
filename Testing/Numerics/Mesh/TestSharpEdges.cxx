#include "Mesh/SharpEdges.h"

#include "Base/Random.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::sharpenEdges;
using conformal::Vector3;

namespace
{
// What is left of a large ball between planes, each { normal, distance }, as far as a regular
// lattice of directions sees it: triangles across the edges cut these off.
struct Plane
{
  Vector3 Normal;
  double Distance;
};

Mesh between(const std::vector<Plane>& planes, int frequency = 24)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    // The lattice has edges along the planes of symmetry, which would meet the object's.
    const Vector3 direction =
      Eigen::AngleAxisd(0.3, Vector3(1.0, 2.0, 4.0).normalized()) * Vector3(mesh.Positions.row(v));
    double reach = 1.0;
    for (const Plane& plane : planes)
    {
      const double along = direction.dot(plane.Normal);
      reach = along > 0.0 ? std::min(reach, plane.Distance / along) : reach;
    }
    mesh.Positions.row(v) = reach * direction;
  }
  return mesh;
}

Mesh cube()
{
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      planes.push_back({ sign * Vector3(Vector3::Unit(axis)), 0.5 });
    }
  }
  return between(planes);
}

// Root mean square distance of points on the object's edges to the surface.
double edgeError(const Mesh& mesh, const std::vector<std::array<Vector3, 2>>& edges)
{
  const conformal::TriangleTree tree(mesh.Positions, mesh.Triangles);
  constexpr int steps = 200;
  double sum = 0.0;
  for (const auto& [from, to] : edges)
  {
    for (int i = 0; i <= steps; ++i)
    {
      sum += tree.closestPoint(from + i / double(steps) * (to - from)).SquareDistance;
    }
  }
  return std::sqrt(sum / static_cast<double>(edges.size() * (steps + 1)));
}

Index countFolds(const Mesh& mesh)
{
  const auto normal = [&](Index r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0));
    return Vector3((Vector3(mesh.Positions.row(mesh.Triangles(r, 1))) - a)
                     .cross(Vector3(mesh.Positions.row(mesh.Triangles(r, 2))) - a));
  };
  const conformal::Triangles across =
    conformal::triangleNeighbors(mesh.Triangles, mesh.Positions.rows());
  Index count = 0;
  for (Index r = 0; r < across.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      count += normal(r).dot(normal(across(r, k))) < 0.0;
    }
  }
  return count;
}
}

// Triangles that a regular lattice lays across an edge at random cut off more of it than those that
// are fitted to samples, and some are taken for planes.
TEST(SharpEdges, CompletesACube)
{
  std::vector<std::array<Vector3, 2>> edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double y : { -0.5, 0.5 })
    {
      for (const double z : { -0.5, 0.5 })
      {
        Vector3 from;
        from[axis] = -0.5;
        from[(axis + 1) % 3] = y;
        from[(axis + 2) % 3] = z;
        edges.push_back({ from, from + Vector3(Vector3::Unit(axis)) });
      }
    }
  }
  const Mesh before = cube();
  Mesh mesh = before;
  EXPECT_GT(sharpenEdges(mesh), 0);
  EXPECT_EQ(mesh.Triangles, before.Triangles);
  const double error = edgeError(before, edges), left = edgeError(mesh, edges);
  RecordProperty("Left", std::to_string(left / error));
  EXPECT_LT(left, 0.7 * error);
  const double missing = 1.0 - conformal::signedVolume(before.Positions, before.Triangles);
  EXPECT_LT(std::abs(1.0 - conformal::signedVolume(mesh.Positions, mesh.Triangles)), 0.5 * missing);
  EXPECT_EQ(countFolds(mesh), 0);
}

// Whichever side is outside.
TEST(SharpEdges, CompletesAWedge)
{
  for (const double degrees : { 70.0, 80.0, 90.0 })
  {
    for (const bool insideOut : { false, true })
    {
      SCOPED_TRACE(std::to_string(degrees) + (insideOut ? " inside out" : ""));
      const double half = 0.5 * degrees * std::acos(-1.0) / 180.0;
      const Vector3 left(std::sin(half), std::cos(half), 0.0), right(-left[0], left[1], 0.0);
      const Vector3 middle(0.0, 0.5 / std::cos(half), 0.0), way(0.0, 0.0, 0.3);
      Mesh mesh = between({ { left, 0.5 }, { right, 0.5 } });
      if (insideOut)
      {
        mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
      }
      const double before = edgeError(mesh, { { middle - way, middle + way } });
      EXPECT_GT(sharpenEdges(mesh), 0);
      const double after = edgeError(mesh, { { middle - way, middle + way } });
      RecordProperty("Left", std::to_string(after / before));
      EXPECT_LT(after, 0.75 * before);
      EXPECT_EQ(countFolds(mesh), 0);
    }
  }
}

TEST(SharpEdges, LeavesSmoothSurfacesAlone)
{
  for (const Vector3& axes : { Vector3(1.0, 1.0, 1.0), Vector3(1.0, 0.4, 0.2) })
  {
    Mesh mesh = conformal::makeGeodesicSphere(24);
    mesh.Positions = mesh.Positions * axes.asDiagonal();
    const Points before = mesh.Positions;
    EXPECT_EQ(sharpenEdges(mesh), 0);
    EXPECT_EQ(mesh.Positions, before);
  }
  Mesh flat = between({ { Vector3(1.0, 1.0, 0.0).normalized(), 0.93 } }); // an edge of 22 degrees
  EXPECT_EQ(sharpenEdges(flat), 0);
}

TEST(SharpEdges, LeavesNoiseAlone)
{
  Mesh mesh = conformal::makeGeodesicSphere(24);
  conformal::Random random(3);
  const double edge = 0.05;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    mesh.Positions.row(v) *= 1.0 + 0.5 * edge * (2.0 * random.uniform() - 1.0);
  }
  const Points before = mesh.Positions;
  EXPECT_EQ(sharpenEdges(mesh), 0);
  EXPECT_EQ(mesh.Positions, before);
}

TEST(SharpEdges, TakesMeshesOfAnySizeAndShape)
{
  for (const double scale : { 0.0, 1e-3, 1.0 })
  {
    for (const int frequency : { 1, 2 })
    {
      Mesh mesh = between({ { Vector3(1.0, 0.0, 0.0), 0.5 } }, frequency);
      mesh.Positions *= scale;
      sharpenEdges(mesh);
      EXPECT_TRUE(mesh.Positions.allFinite());
    }
  }
  Mesh unit = cube(), small = unit;
  small.Positions *= 0x1p-10;
  sharpenEdges(unit);
  sharpenEdges(small);
  EXPECT_EQ(small.Positions, unit.Positions * 0x1p-10);
}

TEST(SharpEdges, SameBitsInAnyOrderOfBlocks)
{
  Mesh a = cube(), b = a;
  sharpenEdges(a);
  sharpenEdges(b, runs::backwards());
  EXPECT_EQ(a.Positions, b.Positions);
}

TEST(SharpEdges, StopsWhenToldTo)
{
  for (const double when : { 0.0, 0.5 })
  {
    Mesh mesh = cube();
    const Points before = mesh.Positions;
    EXPECT_THROW(sharpenEdges(mesh, runs::stoppingAt(when)), conformal::Aborted);
    EXPECT_EQ(mesh.Positions, before);
  }
}
