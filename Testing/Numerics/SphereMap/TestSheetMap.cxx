#include "SphereMap/SheetMap.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Sheets.h"
#include "SphereMap/Sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

using conformal::Index;
using conformal::mapSheet;
using conformal::Mesh;
using conformal::Points;
using conformal::SheetMapResult;
using conformal::Triangles;
using conformal::Vector3;
using sheets::cap;

namespace
{
void expectCircle(const Mesh& mesh, const SheetMapResult& map)
{
  const std::vector<char> border = conformal::borderVertices(mesh.Triangles, mesh.Positions.rows());
  const auto disk = conformal::diskPositions(map.Positions);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    EXPECT_NEAR(map.Positions.row(v).norm(), 1.0, 1e-14);
    if (border[v])
    {
      EXPECT_EQ(map.Positions(v, 2), 0.0);
      EXPECT_NEAR(disk.row(v).norm(), 1.0, 1e-14);
    }
    else
    {
      EXPECT_GT(map.Positions(v, 2), 0.0);
    }
  }
  EXPECT_EQ(map.NumberOfFlippedTriangles, 0);
}
}

// The conformal map of a cap is the stereographic projection: known at every point.
TEST(SheetMap, OfACapIsTheStereographicProjection)
{
  for (const double angle : { 0.3, 1.2, 2.2 })
  {
    double errors[2] = {};
    for (int level = 0; level < 2; ++level)
    {
      const Mesh mesh = cap(level == 0 ? 12 : 24, angle);
      const SheetMapResult map = mapSheet(mesh);
      expectCircle(mesh, map);
      const auto disk = conformal::diskPositions(map.Positions);
      for (Index v = 0; v < disk.rows(); ++v)
      {
        const Vector3 p = mesh.Positions.row(v);
        const double radius =
          std::tan(0.5 * std::acos(std::min(p[2], 1.0))) / std::tan(0.5 * angle);
        const Eigen::Vector2d direction = p.head<2>().norm() > 0.0
          ? Eigen::Vector2d(p.head<2>().normalized())
          : Eigen::Vector2d::Zero();
        errors[level] =
          std::max(errors[level], (disk.row(v).transpose() - radius * direction).norm());
      }
    }
    EXPECT_LT(errors[0], 0.02) << angle;
    EXPECT_LT(errors[1], 0.5 * errors[0]) << angle;
  }
}

// A chord is an edge inside whose two ends are on the border; a corner of a square is cut off by
// one.
TEST(SheetMap, MapsSheetsWithChords)
{
  Mesh square;
  constexpr int side = 9;
  square.Positions.resize(side * side, 3);
  square.Triangles.resize(2 * (side - 1) * (side - 1), 3);
  Index f = 0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const int v = j * side + i;
      square.Positions.row(v) = Vector3(i, 0.3 * j, 0.1 * std::sin(0.5 * i));
      if (i + 1 < side && j + 1 < side)
      {
        square.Triangles.row(f++) << v, v + 1, v + side;
        square.Triangles.row(f++) << v + 1, v + side + 1, v + side;
      }
    }
  }
  const SheetMapResult map = mapSheet(square);
  expectCircle(square, map);
  EXPECT_EQ(map.NumberOfEars, 2); // at two corners
  EXPECT_EQ(mapSheet(cap(4, 1.0)).NumberOfEars, 0);
}

// Without holes, the map is the same but for the missing triangles.
TEST(SheetMap, FillsHoles)
{
  const Mesh whole = cap(16, 1.0);
  Mesh holed = whole;
  holed.Triangles = whole.Triangles.bottomRows(whole.Triangles.rows() - 54).eval(); // three rings
  const Points kept = whole.Positions.bottomRows(whole.Positions.rows() - 19);
  holed.Positions = kept;
  holed.Triangles.array() -= 19;
  const SheetMapResult map = mapSheet(holed);
  EXPECT_EQ(map.NumberOfFlippedTriangles, 0);
  const Points expected = mapSheet(whole).Positions.bottomRows(kept.rows());
  EXPECT_LT((map.Positions - expected).rowwise().norm().maxCoeff(), 0.05);
}

TEST(SheetMap, ResemblesTheSheetFromItsFront)
{
  const Mesh mesh = cap(8, 0.8);
  const auto disk = conformal::diskPositions(mapSheet(mesh).Positions);
  const double along = (disk.col(0).array() * mesh.Positions.col(0).array()).sum();
  EXPECT_GT(along, 0.0);
  EXPECT_NEAR((disk.col(0).array() * mesh.Positions.col(1).array()).sum(), 0.0, 0.01 * along);
}

TEST(SheetMap, RefusesOtherSurfaces)
{
  const Mesh sphere = conformal::makeGeodesicSphere(4);
  EXPECT_FALSE(conformal::isSheet(sphere.Triangles, sphere.Positions.rows()));
  EXPECT_THROW(mapSheet(sphere), std::invalid_argument);
  Mesh two = sphere; // two pieces
  two.Triangles.conservativeResize(2, 3);
  two.Triangles << 0, 1, 2, 3, 4, 5;
  two.Positions.conservativeResize(6, 3);
  EXPECT_THROW(mapSheet(two), std::invalid_argument);
  EXPECT_TRUE(conformal::isSheet(cap(2, 1.0).Triangles, cap(2, 1.0).Positions.rows()));
}

TEST(SheetMap, DoesNotDependOnThreads)
{
  const Mesh mesh = cap(20, 1.0);
  EXPECT_EQ(mapSheet(mesh).Positions, mapSheet(mesh, runs::backwards()).Positions);
}
