#include "Sphere/SphereCoverage.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::GeodesicSphere;
using conformal::makeGeodesicSphere;
using conformal::measureSphereCoverage;
using conformal::Points;
using conformal::Triangles;

TEST(SphereCoverage, LatticesCoverOnce)
{
  for (int f : { 1, 2, 7, 36 })
  {
    const GeodesicSphere sphere = makeGeodesicSphere(f);
    const auto coverage = measureSphereCoverage(sphere.Positions, sphere.Faces);
    EXPECT_EQ(coverage.Degree, 1);
    EXPECT_EQ(coverage.NumberOfFolds, 0);
  }
}

TEST(SphereCoverage, MirrorsCoverMinusOnce)
{
  const GeodesicSphere sphere = makeGeodesicSphere(4);
  const Points mirrored = -sphere.Positions;
  const auto coverage = measureSphereCoverage(mirrored, sphere.Faces);
  EXPECT_EQ(coverage.Degree, -1);
  EXPECT_EQ(coverage.NumberOfFolds, sphere.Faces.rows());
}

TEST(SphereCoverage, CountsTrianglesFoldedOver)
{
  GeodesicSphere sphere = makeGeodesicSphere(4);
  // A vertex pulled over its neighbours; the degree does not notice.
  const Eigen::RowVector3d far = sphere.Positions.row(sphere.Faces(50, 1));
  const int pulled = sphere.Faces(50, 0);
  sphere.Positions.row(pulled) = (2.5 * far - 1.5 * sphere.Positions.row(pulled)).normalized();
  const auto coverage = measureSphereCoverage(sphere.Positions, sphere.Faces);
  EXPECT_EQ(coverage.Degree, 1);
  EXPECT_GE(coverage.NumberOfFolds, 1);
  EXPECT_LE(coverage.NumberOfFolds, 6);
}

TEST(SphereCoverage, AMapToOneSideCoversNothing)
{
  const GeodesicSphere sphere = makeGeodesicSphere(4);
  Points bowl = sphere.Positions;
  bowl.col(2) = bowl.col(2).cwiseAbs();
  EXPECT_EQ(measureSphereCoverage(bowl, sphere.Faces).Degree, 0);
}
