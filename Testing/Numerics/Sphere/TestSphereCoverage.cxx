#include "Sphere/SphereCoverage.h"

#include "Mesh/GeodesicSphere.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

using conformal::makeGeodesicSphere;
using conformal::measureSphereCoverage;
using conformal::Mesh;
using conformal::Points;
using conformal::Triangles;

TEST(SphereCoverage, LatticesCoverOnce)
{
  for (int f : { 1, 2, 7, 36 })
  {
    const Mesh sphere = makeGeodesicSphere(f);
    const auto coverage = measureSphereCoverage(sphere.Positions, sphere.Triangles);
    EXPECT_EQ(coverage.Degree, 1);
    EXPECT_EQ(coverage.NumberOfFolds, 0);
  }
}

TEST(SphereCoverage, MirrorsCoverMinusOnce)
{
  const Mesh sphere = makeGeodesicSphere(4);
  const Points mirrored = -sphere.Positions;
  const auto coverage = measureSphereCoverage(mirrored, sphere.Triangles);
  EXPECT_EQ(coverage.Degree, -1);
  EXPECT_EQ(coverage.NumberOfFolds, sphere.Triangles.rows());
}

TEST(SphereCoverage, CountsTrianglesFoldedOver)
{
  Mesh sphere = makeGeodesicSphere(4);
  // A vertex pulled over its neighbors; the degree does not notice.
  const Eigen::RowVector3d far = sphere.Positions.row(sphere.Triangles(50, 1));
  const int pulled = sphere.Triangles(50, 0);
  sphere.Positions.row(pulled) = (2.5 * far - 1.5 * sphere.Positions.row(pulled)).normalized();
  const auto coverage = measureSphereCoverage(sphere.Positions, sphere.Triangles);
  EXPECT_EQ(coverage.Degree, 1);
  EXPECT_GE(coverage.NumberOfFolds, 1);
  EXPECT_LE(coverage.NumberOfFolds, 6);
}

TEST(SphereCoverage, AMapToOneSideCoversNothing)
{
  const Mesh sphere = makeGeodesicSphere(4);
  Points bowl = sphere.Positions;
  bowl.col(2) = bowl.col(2).cwiseAbs();
  EXPECT_EQ(measureSphereCoverage(bowl, sphere.Triangles).Degree, 0);
}

// The solid angles of triangles that go around the center would add up to any number, by chance.
TEST(SphereCoverage, AFlatMapFolds)
{
  Mesh sphere = makeGeodesicSphere(1);
  sphere.Positions.col(1).setZero();
  sphere.Positions.rowwise().normalize();
  sphere.Positions *=
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const auto coverage = measureSphereCoverage(sphere.Positions, sphere.Triangles);
  EXPECT_EQ(coverage.Degree, 0);
  EXPECT_NEAR(coverage.Times, 0.0, 1e-12);
  EXPECT_GE(coverage.NumberOfFolds, 2);
  EXPECT_THROW(conformal::turnedToCoverOnce(sphere.Positions, sphere.Triangles, "the map"),
    std::invalid_argument);
}

TEST(SphereCoverage, LargeTrianglesDoNotFold)
{
  const double s = 1.0 / std::sqrt(3.0);
  const Points corners = (Points(4, 3) << s, s, s, s, -s, -s, -s, s, -s, -s, -s, s).finished();
  const Triangles tetrahedron = (Triangles(4, 3) << 0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2).finished();
  const auto coverage = measureSphereCoverage(corners, tetrahedron);
  EXPECT_EQ(coverage.Degree, 1);
  EXPECT_EQ(coverage.NumberOfFolds, 0);
}

// A sheet covers half of the sphere. Half must not be rounded to 1 by chance.
TEST(SphereCoverage, ASheetIsNoCover)
{
  for (int rings = 1; rings < 20; ++rings)
  {
    const Mesh sheet = sheets::cap(rings, 0.5 * conformal::Pi);
    const auto coverage = measureSphereCoverage(sheet.Positions, sheet.Triangles);
    EXPECT_EQ(coverage.Degree, 0) << rings;
    EXPECT_NEAR(coverage.Times, 0.5, 1e-12);
  }
}

TEST(SphereCoverage, ASmallHoleChangesNothing)
{
  const Mesh sphere = makeGeodesicSphere(6);
  const Triangles most = sphere.Triangles.bottomRows(sphere.Triangles.rows() - 2);
  EXPECT_EQ(measureSphereCoverage(sphere.Positions, most).Degree, 1);
}

TEST(SphereCoverage, TurnsMirroredMapsAndRefusesWhatFolds)
{
  const Mesh sphere = makeGeodesicSphere(4);
  Points positions = sphere.Positions;
  EXPECT_EQ(conformal::turnedToCoverOnce(positions, sphere.Triangles, "the map"), sphere.Triangles);
  const Triangles turned = conformal::turnedToCoverOnce(-positions, sphere.Triangles, "the map");
  EXPECT_EQ(turned.col(1), sphere.Triangles.col(2));
  positions.row(30) *= -1.0;
  try
  {
    conformal::turnedToCoverOnce(positions, sphere.Triangles, "the map of a dented sphere");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(
      std::string(error.what()).rfind("the map of a dented sphere covers it 0 times with 6", 0), 0U)
      << error.what();
  }
}
