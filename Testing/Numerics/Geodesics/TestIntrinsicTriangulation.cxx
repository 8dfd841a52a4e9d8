#include "Geodesics/IntrinsicTriangulation.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
    changed += t >= mesh.Triangles.rows() || surface.Triangles.row(t) != mesh.Triangles.row(t);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 edge = surface.Positions.row(surface.Triangles(t, (k + 1) % 3)) -
        surface.Positions.row(surface.Triangles(t, k));
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
  fan.Positions << 0, 0, 0, 10, 0, 0, 5, 6, 0, 5, -6, 0, 5, 0, 6;
  fan.Triangles.resize(3, 3);
  fan.Triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  EXPECT_EQ(intrinsicDelaunay(fan).Triangles, fan.Triangles);
  fan.Positions(2, 1) = 0.1; // now the edge of 0 and 1 can be divided, but not flipped
  fan.Positions(3, 1) = -0.1;
  fan.Triangles.conservativeResize(2, 3);
  EXPECT_EQ(intrinsicDelaunay(fan).Positions.rows(), 5);
  EXPECT_NE(intrinsicDelaunay(fan).Triangles, fan.Triangles);
}

TEST(IntrinsicTriangulation, DividesEdgesWithNegativeWeights)
{
  Mesh needle; // a triangle with an obtuse angle, and two others at its longest edge
  needle.Positions.resize(5, 3);
  needle.Positions << 0, 0, 0, 1, 0, 0, 0.3, 0.03, 0, 0.4, -0.02, 0, 0.6, 0, 0.1;
  needle.Triangles.resize(3, 3);
  needle.Triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  for (const Index count : { 3, 1 })
  {
    needle.Triangles.conservativeResize(count, 3);
    const IntrinsicTriangulation surface = intrinsicDelaunay(needle);
    EXPECT_GT(surface.Positions.rows(), 5);
    EXPECT_EQ(surface.Positions.rows(), static_cast<Index>(surface.Parts.size()));
    EXPECT_EQ(surface.Positions.topRows(5), needle.Positions);
    std::map<std::pair<int, int>, double> weights;
    for (Index t = 0; t < surface.Triangles.rows(); ++t)
    {
      const Vector3 cotangents = cotangentsOf(surface.Lengths.row(t));
      EXPECT_EQ(surface.Parts[surface.Triangles(t, 0)], 0);
      for (int k = 0; k < 3; ++k)
      {
        const int a = surface.Triangles(t, k), b = surface.Triangles(t, (k + 1) % 3);
        weights[{ std::min(a, b), std::max(a, b) }] += cotangents[(k + 2) % 3];
        const double length = (surface.Positions.row(a) - surface.Positions.row(b)).norm();
        EXPECT_NEAR(surface.Lengths(t, k), length, 1e-12);
      }
    }
    for (const auto& [edge, weight] : weights)
    {
      EXPECT_GT(weight, -1e-8) << edge.first << " " << edge.second;
    }
    const double area = 0.5 * (0.03 + (count > 1 ? 0.02 + 0.1 : 0.0));
    EXPECT_NEAR(totalArea(surface), area, 1e-12);
  }
}

// Lengths of a part do not depend on other parts.
TEST(IntrinsicTriangulation, KeepsLengthsOfSmallParts)
{
  const Mesh sphere = conformal::makeGeodesicSphere(4);
  const Index size = sphere.Positions.rows(), count = sphere.Triangles.rows();
  Mesh both;
  both.Positions.resize(2 * size, 3);
  both.Positions << 1e8 * sphere.Positions, sphere.Positions;
  both.Triangles.resize(2 * count, 3);
  both.Triangles << sphere.Triangles, sphere.Triangles.array() + static_cast<int>(size);
  EXPECT_EQ(intrinsicDelaunay(both).Lengths.bottomRows(count), intrinsicDelaunay(sphere).Lengths);
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
