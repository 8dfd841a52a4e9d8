#include "Border/SheetCut.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::BorderSurface;
using conformal::CutSheet;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;

namespace
{
CutSheet cutAt(const Mesh& mesh, double height, const Points& points)
{
  std::vector<char> open;
  std::vector<double> support;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    open.push_back(mesh.Positions(v, 2) < height);
    support.push_back(open.back() ? 0.0 : 1.0);
  }
  const BorderSurface surface(mesh);
  const auto borders =
    conformal::fitBorders(conformal::firstBorders(mesh, open, support), surface, points);
  return conformal::cutSheet(surface, open, borders);
}

double smallestAngle(const Mesh& mesh)
{
  double smallest = 180.0;
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const conformal::Vector3 a = mesh.Positions.row(mesh.Triangles(f, k)),
                               b = mesh.Positions.row(mesh.Triangles(f, conformal::next(k))),
                               c = mesh.Positions.row(mesh.Triangles(f, conformal::previous(k)));
      const double angle =
        std::acos((b - a).normalized().dot((c - a).normalized())) * 180.0 / conformal::Pi;
      smallest = std::min(smallest, angle);
    }
  }
  return smallest;
}
}

TEST(SheetCut, IsASheetWithTheBorderOfThePoints)
{
  const Mesh mesh = conformal::makeGeodesicSphere(30);
  const CutSheet sheet = cutAt(mesh, 0.25, sheets::pointsAbove(0.3, 40000, 5));
  ASSERT_GT(sheet.Triangles.rows(), 0);
  EXPECT_TRUE(conformal::checkGenusZero(sheet.Triangles, sheet.Positions.rows()).isSheet());
  EXPECT_EQ(sheet.DroppedFraction, 0.0);
  const auto loops = conformal::borderLoops(sheet);
  ASSERT_EQ(loops.size(), 1u);
  for (const int v : loops[0])
  {
    EXPECT_NEAR(sheet.Positions(v, 2), 0.3, 0.01);
  }
  EXPECT_GE(sheet.Positions.col(2).minCoeff(), 0.29);
  EXPECT_NEAR(
    conformal::surfaceArea(sheet.Positions, sheet.Triangles), 2.0 * conformal::Pi * 0.7, 0.03);
  EXPECT_GT(smallestAngle(sheet), 8.0);
}

TEST(SheetCut, VerticesAreThoseOfTheMeshOrOnItsEdges)
{
  const Mesh mesh = conformal::makeGeodesicSphere(12);
  const CutSheet sheet = cutAt(mesh, 0.1, sheets::pointsAbove(0.1, 20000, 5));
  ASSERT_EQ(static_cast<Index>(sheet.Vertices.size()), sheet.Positions.rows());
  Index moved = 0;
  for (Index v = 0; v < sheet.Positions.rows(); ++v)
  {
    const auto [first, second, weight] = sheet.Vertices[v];
    EXPECT_GE(weight, 0.0);
    EXPECT_LE(weight, 1.0);
    const Eigen::RowVector3d place =
      (1.0 - weight) * mesh.Positions.row(first) + weight * mesh.Positions.row(second);
    const double away = (place - sheet.Positions.row(v)).norm();
    moved += away > 1e-12;
    EXPECT_LT(away, 0.05);
  }
  EXPECT_LT(moved, 200); // of 730, only those at the border
}

TEST(SheetCut, NothingIsKeptIfAllIsOpen)
{
  const Mesh mesh = conformal::makeGeodesicSphere(6);
  const std::vector<char> open(mesh.Positions.rows(), 1);
  conformal::BorderCurve far;
  far.Positions = Points::Constant(1, 3, 5.0);
  far.Normals = far.Outward = Points::Zero(1, 3);
  EXPECT_EQ(conformal::cutSheet(BorderSurface(mesh), open, { far }).Triangles.rows(), 0);
}
