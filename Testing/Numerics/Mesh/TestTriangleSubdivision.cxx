#include "Mesh/TriangleSubdivision.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Vector3;

namespace
{
/// Twice the area vector.
Vector3 areaVector(const Mesh& mesh, Index r)
{
  const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0)),
                b = mesh.Positions.row(mesh.Triangles(r, 1)),
                c = mesh.Positions.row(mesh.Triangles(r, 2));
  return (b - a).cross(c - a);
}

Mesh tetrahedron()
{
  Mesh mesh;
  mesh.Positions.resize(4, 3);
  mesh.Positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.Triangles.resize(4, 3);
  mesh.Triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return mesh;
}
}

TEST(TriangleSubdivision, PointsOfEdgesAreShared)
{
  for (const Mesh& mesh : { tetrahedron(), makeGeodesicSphere(3) })
  {
    for (int k = 1; k <= 6; ++k)
    {
      const Mesh fine = conformal::subdivide(mesh, k);
      EXPECT_EQ(fine.Positions.rows(), (mesh.Positions.rows() - 2) * k * k + 2);
      EXPECT_EQ(fine.Triangles.rows(), mesh.Triangles.rows() * k * k);
      EXPECT_EQ(fine.Positions.topRows(mesh.Positions.rows()), mesh.Positions);
      std::set<std::pair<int, int>> directed;
      std::set<int> used;
      for (Index r = 0; r < fine.Triangles.rows(); ++r)
      {
        for (int n = 0; n < 3; ++n)
        {
          used.insert(fine.Triangles(r, n));
          EXPECT_TRUE(
            directed.emplace(fine.Triangles(r, n), fine.Triangles(r, (n + 1) % 3)).second);
        }
      }
      for (const auto& [from, to] : directed)
      {
        EXPECT_TRUE(directed.count({ to, from }));
      }
      EXPECT_EQ(static_cast<Index>(used.size()), fine.Positions.rows());
      EXPECT_EQ(*used.rbegin(), fine.Positions.rows() - 1);
    }
  }
}

// Which says where every point is, and how the triangles run.
TEST(TriangleSubdivision, CutsEachTriangleIntoEqualParts)
{
  const Mesh mesh = makeGeodesicSphere(2);
  for (int k = 1; k <= 5; ++k)
  {
    const Mesh fine = conformal::subdivide(mesh, k);
    for (Index r = 0; r < fine.Triangles.rows(); ++r)
    {
      const Vector3 expected = areaVector(mesh, r / (k * k)) / (k * k);
      EXPECT_LT((areaVector(fine, r) - expected).norm(), 1e-14);
    }
  }
}

TEST(TriangleSubdivision, ThreadsChangeNoBit)
{
  const Mesh mesh = makeGeodesicSphere(8);
  const Mesh alone = conformal::subdivide(mesh, 7),
             both = conformal::subdivide(mesh, 7, runs::backwards());
  EXPECT_EQ(alone.Positions, both.Positions);
  EXPECT_EQ(alone.Triangles, both.Triangles);
}

TEST(TriangleSubdivision, SaysWhatItCannotDo)
{
  EXPECT_THROW(conformal::subdivide(tetrahedron(), 0), std::invalid_argument);
  EXPECT_THROW(conformal::subdivide(tetrahedron(), 30000), std::invalid_argument);
  EXPECT_THROW(
    conformal::subdivide(makeGeodesicSphere(40), 3, runs::stoppingAt(0.0)), conformal::Aborted);
}

TEST(TriangleSubdivision, MeetsANumberOfPoints)
{
  EXPECT_EQ(conformal::subdivisionsFor(12962, 64002.0), 3); // 116,642, not 51,842
  EXPECT_EQ(conformal::subdivisionsFor(12962, 51842.0), 2);
  EXPECT_EQ(conformal::subdivisionsFor(12962, 12962.0), 1);
  EXPECT_EQ(conformal::subdivisionsFor(12962, 4.0), 1);
  EXPECT_EQ(conformal::subdivisionsFor(4, 64002.0), 179);
}
