#include "Sphere/SheetCaps.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Sheets.h"
#include "Sphere/SphereCoverage.h"

#include <gtest/gtest.h>

using conformal::CappedSheet;
using conformal::MappedMesh;

namespace
{
MappedMesh mapped(const conformal::Mesh& mesh)
{
  MappedMesh result;
  static_cast<conformal::Mesh&>(result) = mesh;
  result.SpherePositions = mesh.Positions;
  return result;
}

void expectClosed(const CappedSheet& capped)
{
  EXPECT_NO_THROW(conformal::requireGenusZero(capped.Triangles, capped.Positions.rows()));
  const auto coverage = conformal::measureSphereCoverage(capped.SpherePositions, capped.Triangles);
  EXPECT_EQ(coverage.Degree, 1);
  EXPECT_EQ(coverage.NumberOfFolds, 0);
}
}

TEST(SheetCaps, AHemisphereIsClosedByOneVertex)
{
  const MappedMesh sheet = mapped(sheets::cap(6, 0.5 * conformal::Pi));
  const CappedSheet capped = conformal::withCaps(sheet);
  EXPECT_EQ(capped.NumberOfCapVertices, 1);
  EXPECT_EQ(capped.NumberOfCapTriangles, 36);
  EXPECT_TRUE(capped.SpherePositions.bottomRows(1).isApprox(Eigen::RowVector3d(0, 0, -1), 1e-12));
  EXPECT_EQ(capped.Triangles.topRows(sheet.Triangles.rows()), sheet.Triangles);
  expectClosed(capped);
}

TEST(SheetCaps, HolesAreClosedBetweenTheirVertices)
{
  MappedMesh sheet = mapped(sheets::cap(6, 1.2));
  const conformal::Index removed = 6 * 4; // the triangles of two rings
  sheet.Triangles = sheet.Triangles.bottomRows(sheet.Triangles.rows() - removed).eval();
  sheet.Triangles.array() -= 7;
  sheet.Positions = sheet.Positions.bottomRows(sheet.Positions.rows() - 7).eval();
  sheet.SpherePositions = sheet.Positions;
  const CappedSheet capped = conformal::withCaps(sheet);
  EXPECT_EQ(capped.NumberOfCapVertices, 1);
  EXPECT_EQ(capped.NumberOfCapTriangles, 36 + 12 - 2);
  expectClosed(capped);
}

TEST(SheetCaps, AClosedSurfaceStaysAsItIs)
{
  const MappedMesh sphere = mapped(conformal::makeGeodesicSphere(4));
  const CappedSheet capped = conformal::withCaps(sphere);
  EXPECT_EQ(capped.NumberOfCapTriangles, 0);
  EXPECT_EQ(capped.Triangles, sphere.Triangles);
  EXPECT_EQ(capped.Positions, sphere.Positions);
}
