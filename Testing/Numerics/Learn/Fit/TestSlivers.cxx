#include "Learn/Fit/Slivers.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexRings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using conformal::Index;
using conformal::Mesh;
using conformal::SliverRemoval;
using conformal::Vector3;

namespace
{
double minimumQuality(const Mesh& mesh)
{
  double minimum = 1.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0)),
                  b = mesh.Positions.row(mesh.Triangles(r, 1)),
                  c = mesh.Positions.row(mesh.Triangles(r, 2));
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    minimum = std::min(minimum, 2.0 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares);
  }
  return minimum;
}

Mesh sphereWith(int frequency, int vertex, double share)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  const conformal::VertexRings rings(mesh.Triangles, mesh.Positions.rows());
  const auto& ring = rings[vertex];
  const Vector3 from = mesh.Positions.row(vertex);
  const Vector3 to = 0.5 * (mesh.Positions.row(ring[0]) + mesh.Positions.row(ring[1])).transpose();
  mesh.Positions.row(vertex) = (1.0 - share) * from + share * to;
  return mesh;
}
}

TEST(Slivers, AMeshWithoutSliversKeepsItsBits)
{
  const Mesh sphere = conformal::makeGeodesicSphere(10);
  Mesh mesh = sphere;
  const SliverRemoval removal = conformal::removeSlivers(mesh);
  EXPECT_EQ(removal.Before, 0);
  EXPECT_TRUE(removal.Sources.empty());
  EXPECT_EQ(mesh.Positions, sphere.Positions);
  EXPECT_EQ(mesh.Triangles, sphere.Triangles);
}

// A vertex on the opposite edge of one of its triangles, as in a cap
TEST(Slivers, CapsAreFlipped)
{
  Mesh mesh = sphereWith(10, 500, 0.99);
  const Mesh before = mesh;
  ASSERT_LT(minimumQuality(mesh), 0.1);
  const SliverRemoval removal = conformal::removeSlivers(mesh);
  EXPECT_GE(removal.Before, 1);
  EXPECT_EQ(removal.After, 0);
  EXPECT_GE(minimumQuality(mesh), 0.1);
  EXPECT_EQ(mesh.Positions, before.Positions); // only triangles changed
  EXPECT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
}

// A hair: the tip of a cone as wide as a thousandth of an edge
TEST(Slivers, HairsAreCollapsed)
{
  Mesh mesh = conformal::makeGeodesicSphere(10);
  const conformal::VertexRings rings(mesh.Triangles, mesh.Positions.rows());
  const int tip = 500;
  const Vector3 center = mesh.Positions.row(tip);
  for (const int v : rings[tip])
  {
    mesh.Positions.row(v) = 1.05 * center + 1e-3 * (mesh.Positions.row(v).transpose() - center);
  }
  mesh.Positions.row(tip) = 1.1 * center;
  ASSERT_LT(minimumQuality(mesh), 0.01);
  const Mesh before = mesh;
  const SliverRemoval removal = conformal::removeSlivers(mesh);
  EXPECT_GE(removal.Before, 12);
  EXPECT_EQ(removal.After, 0);
  EXPECT_EQ(mesh.Positions.rows(), before.Positions.rows());
  EXPECT_EQ(mesh.Triangles.rows(), before.Triangles.rows());
  EXPECT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
  // What is far from the hair keeps its place.
  ASSERT_EQ(static_cast<Index>(removal.Sources.size()), mesh.Positions.rows());
  Index kept = 0;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const auto [a, b] = removal.Sources[v];
    kept += a == v && b == v && mesh.Positions.row(v) == before.Positions.row(v);
  }
  EXPECT_GT(kept, mesh.Positions.rows() - 30);
}

// Of a mesh that is a needle as a whole, all triangles stay slivers. It stays closed.
TEST(Slivers, ANeedleStaysClosed)
{
  Mesh mesh = conformal::makeGeodesicSphere(2);
  mesh.Positions.rightCols(2) *= 1e-6;
  const Index vertices = mesh.Positions.rows(), triangles = mesh.Triangles.rows();
  const SliverRemoval removal = conformal::removeSlivers(mesh);
  EXPECT_GT(removal.Before, 0);
  EXPECT_LE(removal.After, removal.Before);
  EXPECT_EQ(mesh.Positions.rows(), vertices);
  EXPECT_EQ(mesh.Triangles.rows(), triangles);
  EXPECT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
  EXPECT_TRUE(mesh.Positions.allFinite());
}

// A triangle is replaced by the rest of an octahedron: a part that hangs on three edges.
TEST(Slivers, PartsThatHangOnThreeEdgesAreCutOff)
{
  const Mesh sphere = conformal::makeGeodesicSphere(10);
  const Index vertices = sphere.Positions.rows(), triangles = sphere.Triangles.rows();
  const int row = 700;
  const auto corner = [&](int k) { return sphere.Triangles(row, k); };
  Mesh mesh;
  mesh.Positions.resize(vertices + 3, 3);
  mesh.Positions.topRows(vertices) = sphere.Positions;
  for (int k = 0; k < 3; ++k) // the vertex opposite to each edge of the octahedron
  {
    mesh.Positions.row(vertices + k) = 1.1 * 0.5 *
      (sphere.Positions.row(corner(k)) + sphere.Positions.row(corner(conformal::next(k))));
  }
  mesh.Triangles.resize(triangles + 6, 3);
  mesh.Triangles.topRows(triangles) = sphere.Triangles;
  const int n = static_cast<int>(vertices);
  mesh.Triangles.row(row) << n, n + 1, n + 2;
  for (int k = 0; k < 3; ++k)
  {
    mesh.Triangles.row(triangles + 2 * k) << corner(k), corner(conformal::next(k)), n + k;
    mesh.Triangles.row(triangles + 2 * k + 1) << corner(k), n + k, n + conformal::previous(k);
  }
  ASSERT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
  const SliverRemoval removal = conformal::removeSlivers(mesh);
  EXPECT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
  EXPECT_EQ(mesh.Positions.rows(), vertices + 3);
  // The three vertices of the part are now middles of edges of the sphere.
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_LT(mesh.Positions.row(vertices + k).norm(), 1.0);
    EXPECT_NE(removal.Sources[vertices + k][0], removal.Sources[vertices + k][1]);
  }
}

// A tail around which three edges lead at each of its rings is longer than these edges. At most
// its last ring is cut off.
TEST(Slivers, ThinTailsAreKept)
{
  constexpr int rings = 5, row = 700;
  const Mesh sphere = conformal::makeGeodesicSphere(40);
  const Index vertices = sphere.Positions.rows(), triangles = sphere.Triangles.rows();
  Mesh mesh;
  mesh.Positions.resize(vertices + 3 * rings, 3);
  mesh.Positions.topRows(vertices) = sphere.Positions;
  mesh.Triangles.resize(triangles + 6 * rings, 3);
  mesh.Triangles.topRows(triangles) = sphere.Triangles;
  std::array<int, 3> below = { sphere.Triangles(row, 0), sphere.Triangles(row, 1),
    sphere.Triangles(row, 2) };
  const double edge = (sphere.Positions.row(below[0]) - sphere.Positions.row(below[1])).norm();
  Index used = triangles;
  for (int ring = 0; ring < rings; ++ring)
  {
    std::array<int, 3> above;
    for (int k = 0; k < 3; ++k)
    {
      above[k] = static_cast<int>(vertices) + 3 * ring + k;
      mesh.Positions.row(above[k]) =
        (1.0 + (ring + 1) * edge) * sphere.Positions.row(sphere.Triangles(row, k));
    }
    for (int k = 0; k < 3; ++k)
    {
      const int n = conformal::next(k);
      mesh.Triangles.row(used++) << below[k], below[n], above[k];
      mesh.Triangles.row(used++) << below[n], above[n], above[k];
    }
    below = above;
  }
  mesh.Triangles.row(row) << below[0], below[1], below[2];
  ASSERT_NO_THROW(conformal::requireGenusZero(mesh.Triangles, mesh.Positions.rows()));
  ASSERT_LT(3.0 * rings, 0.005 * static_cast<double>(mesh.Positions.rows()));
  conformal::removeSlivers(mesh);
  EXPECT_GT(mesh.Positions.rowwise().norm().maxCoeff(), 1.0 + (rings - 1.5) * edge);
}
