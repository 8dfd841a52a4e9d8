#include "Geodesics/IntrinsicTriangulation.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::areaOf;
using conformal::cotangentsOf;
using conformal::Index;
using conformal::intrinsicDelaunay;
using conformal::IntrinsicTriangulation;
using conformal::Mesh;
using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
double totalArea(const IntrinsicTriangulation& surface)
{
  double area = 0.0;
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    area += areaOf(surface.Lengths.row(t));
  }
  return area;
}

// Grid of a rectangle whose rows are much closer than its columns, with each row shifted, so that
// triangles are thin.
Mesh thinGrid(int columns, int rows, double height)
{
  Mesh mesh;
  mesh.Positions.resize(columns * rows, 3);
  mesh.Triangles.resize(2 * (columns - 1) * (rows - 1), 3);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const bool isInside = i > 0 && i + 1 < columns;
      mesh.Positions.row(j * columns + i) << i + (isInside ? 0.9 * (j % 2) : 0.0), height * j, 0.0;
    }
  }
  Index t = 0;
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const int a = j * columns + i;
      mesh.Triangles.row(t++) << a, a + 1, a + columns + 1;
      mesh.Triangles.row(t++) << a, a + columns + 1, a + columns;
    }
  }
  return mesh;
}
}

TEST(IntrinsicTriangulation, KnowsAreasAndAnglesOfTriangles)
{
  EXPECT_NEAR(areaOf({ 3.0, 4.0, 5.0 }), 6.0, 1e-15);
  const double base = 1e-9; // of a needle
  EXPECT_NEAR(areaOf({ 1.0, base, 1.0 }), 0.5 * base, 1e-24);
  // Corners (0, 0), (3, 0), (3, 4): edges 3, 4, 5.
  const Vector3 cotangents = cotangentsOf({ 3.0, 4.0, 5.0 });
  EXPECT_NEAR(cotangents[0], 3.0 / 4.0, 1e-15);
  EXPECT_NEAR(cotangents[1], 0.0, 1e-15);
  EXPECT_NEAR(cotangents[2], 4.0 / 3.0, 1e-15);
}

TEST(IntrinsicTriangulation, FlipsThinTrianglesOfAPlaneAndKeepsTheArea)
{
  const Mesh mesh = thinGrid(12, 40, 0.05);
  const IntrinsicTriangulation surface = intrinsicDelaunay(mesh);
  EXPECT_NEAR(totalArea(surface), 11.0 * 39.0 * 0.05, 1e-9);
  // In a plane, an edge has the length of the distance of its ends.
  double shortest = 1.0;
  Index changed = 0;
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    changed += surface.Triangles.row(t) != mesh.Triangles.row(t);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 edge = mesh.Positions.row(surface.Triangles(t, (k + 1) % 3)) -
        mesh.Positions.row(surface.Triangles(t, k));
      EXPECT_NEAR(surface.Lengths(t, k), edge.norm(), 1e-9);
      shortest = std::min(shortest, surface.Lengths(t, k));
    }
  }
  EXPECT_GT(changed, 100);
  EXPECT_GT(shortest, 0.04);
}

TEST(IntrinsicTriangulation, KeepsDelaunayMeshesAndEdgesThatCannotBeFlipped)
{
  const Mesh sphere = conformal::makeGeodesicSphere(6);
  EXPECT_EQ(intrinsicDelaunay(sphere).Triangles, sphere.Triangles);
  // Three triangles at one edge, one of them with the orientation of another.
  Mesh fan;
  fan.Positions.resize(5, 3);
  fan.Positions << 0, 0, 0, 10, 0, 0, 5, 0.1, 0, 5, -0.1, 0, 5, 0, 0.1;
  fan.Triangles.resize(3, 3);
  fan.Triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  EXPECT_EQ(intrinsicDelaunay(fan).Triangles, fan.Triangles);
  fan.Triangles.conservativeResize(2, 3);
  EXPECT_NE(intrinsicDelaunay(fan).Triangles, fan.Triangles);
}

TEST(IntrinsicTriangulation, GivesAreaToTrianglesWithout)
{
  Mesh flat;
  flat.Positions.resize(4, 3);
  flat.Positions << 0, 0, 0, 1, 0, 0, 0.5, 0, 0, 0.5, 1, 0;
  flat.Triangles.resize(2, 3);
  flat.Triangles << 0, 1, 2, 1, 0, 3;
  const IntrinsicTriangulation surface = intrinsicDelaunay(flat);
  for (Index t = 0; t < 2; ++t)
  {
    EXPECT_GT(areaOf(surface.Lengths.row(t)), 0.0);
  }
  EXPECT_NEAR(totalArea(surface), 0.5, 1e-2);
}
