#include "Surface/Creases.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"
#include "Surface/CurvedTriangles.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

using conformal::creaseVertices;
using conformal::Index;
using conformal::Mesh;
using conformal::Vector3;

namespace
{
std::vector<unsigned char> creasesOf(const Mesh& mesh)
{
  const conformal::Adjacency around =
    conformal::vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  return creaseVertices(
    mesh.Positions, mesh.Triangles, around, conformal::triangleNeighbors(mesh.Triangles, around));
}

// A ball whose radius depends on the direction. Lattice and object have different axes.
Mesh ball(int frequency, const std::function<double(const Vector3&)>& radius)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 direction =
      Eigen::AngleAxisd(0.3, Vector3(1.0, 2.0, 4.0).normalized()) * Vector3(mesh.Positions.row(v));
    mesh.Positions.row(v) = radius(direction) * direction;
  }
  return mesh;
}

// The faces of a cube of edge length n, in squares of two triangles.
Mesh cube(int n)
{
  std::map<std::array<int, 3>, int> ids;
  std::vector<std::array<int, 3>> triangles;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      for (int i = 0; i < n * n; ++i)
      {
        const auto corner = [&](int u, int v)
        {
          std::array<int, 3> at{};
          at[axis] = side;
          at[(axis + 1) % 3] = i % n + u;
          at[(axis + 2) % 3] = i / n + v;
          return ids.emplace(at, static_cast<int>(ids.size())).first->second;
        };
        const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        triangles.push_back(
          side > 0 ? std::array<int, 3>{ a, b, c } : std::array<int, 3>{ a, c, b });
        triangles.push_back(
          side > 0 ? std::array<int, 3>{ a, c, d } : std::array<int, 3>{ a, d, c });
      }
    }
  }
  Mesh mesh;
  mesh.Positions.resize(static_cast<Index>(ids.size()), 3);
  for (const auto& [at, id] : ids)
  {
    mesh.Positions.row(id) << at[0], at[1], at[2];
  }
  mesh.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t r = 0; r < triangles.size(); ++r)
  {
    mesh.Triangles.row(static_cast<Index>(r)) << triangles[r][0], triangles[r][1], triangles[r][2];
  }
  return mesh;
}
}

TEST(Creases, AreTheEdgesOfACube)
{
  const int n = 7;
  const Mesh mesh = cube(n);
  const std::vector<unsigned char> creases = creasesOf(mesh);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sides += mesh.Positions(v, axis) == 0.0 || mesh.Positions(v, axis) == n;
    }
    EXPECT_EQ(creases[v] != 0, sides >= 2) << mesh.Positions.row(v);
  }
}

// Domes would bulge over the faces. A rounded cube has domes.
TEST(Creases, KeepTheFacesOfACubeFlat)
{
  const Mesh mesh = cube(7);
  const conformal::Adjacency around =
    conformal::vertexTriangles(mesh.Triangles, mesh.Positions.rows());
  const conformal::Points normals = conformal::curvingNormals(
    mesh.Positions, mesh.Triangles, around, conformal::triangleNeighbors(mesh.Triangles, around));
  const conformal::CurvedTriangles domes(mesh.Positions, normals, mesh.Triangles);
  const conformal::CurvedTriangles bulging(mesh.Positions,
    conformal::vertexNormals(mesh.Positions, mesh.Triangles, around), mesh.Triangles);
  double height = 0.0, usual = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 middle(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);
    const conformal::CurvedTriangle flat(
      domes[r].positions(), { Vector3::Zero(), Vector3::Zero(), Vector3::Zero() });
    height = std::max(height, (domes[r].position(middle) - flat.position(middle)).norm());
    usual = std::max(usual, (bulging[r].position(middle) - flat.position(middle)).norm());
  }
  EXPECT_LT(height, 1e-6);
  EXPECT_GT(usual, 0.05);
}

// Coarse triangles of round shapes meet at large angles too.
TEST(Creases, AreNotOnRoundShapes)
{
  const auto sphere = [](const Vector3&) { return 1.0; };
  const auto needle = [](const Vector3& direction)
  { return 1.0 / direction.cwiseProduct(Vector3(0.2, 1.0, 1.0)).norm(); };
  for (const int frequency : { 2, 3, 4, 16 })
  {
    for (const Mesh& mesh : { ball(frequency, sphere), ball(frequency, needle) })
    {
      SCOPED_TRACE(frequency);
      const std::vector<unsigned char> creases = creasesOf(mesh);
      EXPECT_EQ(std::count(creases.begin(), creases.end(), 1), 0);
    }
  }
}
