#include "Mesh/Creases.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/SharpEdges.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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
}

TEST(Creases, AreTheEdgesOfACube)
{
  Mesh cube =
    ball(24, [](const Vector3& direction) { return 0.5 / direction.cwiseAbs().maxCoeff(); });
  conformal::sharpenEdges(cube);
  const std::vector<unsigned char> creases = creasesOf(cube);
  Index found = 0, edges = 0;
  for (Index v = 0; v < cube.Positions.rows(); ++v)
  {
    Vector3 x = Vector3(cube.Positions.row(v)).cwiseAbs();
    std::sort(x.data(), x.data() + 3);
    const bool onEdge = x[1] > 0.499;
    edges += onEdge;
    found += onEdge && creases[v];
    EXPECT_FALSE(creases[v] && x[1] < 0.47) << v; // farther than an edge length from all edges
  }
  EXPECT_GT(edges, 150);
  EXPECT_GT(found, 0.95 * edges);
}

// Coarse triangles of round shapes meet at large angles too.
TEST(Creases, AreNotOnRoundShapes)
{
  const auto sphere = [](const Vector3&) { return 1.0; };
  const auto needle = [](const Vector3& direction)
  { return 1.0 / direction.cwiseProduct(Vector3(0.2, 1.0, 1.0)).norm(); };
  for (const int frequency : { 1, 2, 4, 16 })
  {
    for (const Mesh& mesh : { ball(frequency, sphere), ball(frequency, needle) })
    {
      const std::vector<unsigned char> creases = creasesOf(mesh);
      EXPECT_EQ(std::count(creases.begin(), creases.end(), 1), 0) << frequency;
    }
  }
}
