#include "SphereMap/GuYauMap.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::GuYauOptions;
using conformal::GuYauResult;
using conformal::makeGeodesicSphere;
using conformal::mapByGuYau;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
// An ellipsoid that is smooth enough for its triangles to be acute.
Points ellipsoid(const Points& sphere)
{
  return sphere * Vector3(0.8, 0.9, 1.0).asDiagonal();
}

double maximumDistance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}
}

// The paper's first step, by itself.
TEST(GuYauMap, StartsAtTheGaussMap)
{
  const Mesh sphere = makeGeodesicSphere(6);
  const Points points = ellipsoid(sphere.Positions);
  GuYauOptions options;
  options.MaximumNumberOfIterations = 0;
  const GuYauResult result = mapByGuYau({ points, sphere.Triangles }, options);
  EXPECT_EQ(result.Positions, conformal::vertexNormals(points, sphere.Triangles));
  EXPECT_EQ(result.NumberOfIterations, 0);
  EXPECT_FALSE(result.Converged);
}

// The sphere is a fixed point, of the energy of a conformal map.
TEST(GuYauMap, LeavesTheSphereWhereItIs)
{
  const Mesh sphere = makeGeodesicSphere(12);
  const GuYauResult result = mapByGuYau(sphere);
  EXPECT_TRUE(result.Converged);
  EXPECT_EQ(result.NumberOfNegativeStringConstants, 0);
  EXPECT_EQ(result.NumberOfInfiniteStringConstants, 0);
  EXPECT_LT(maximumDistance(result.Positions, sphere.Positions), 0.01);
  EXPECT_NEAR(result.Energy, 4.0 * std::acos(-1.0), 0.1);
}

TEST(GuYauMap, LowersTheEnergyAndKeepsTheMeanAtTheCenter)
{
  const Mesh sphere = makeGeodesicSphere(8);
  const Points points = ellipsoid(sphere.Positions);
  GuYauOptions options;
  options.MaximumNumberOfIterations = 0;
  const GuYauResult start = mapByGuYau({ points, sphere.Triangles }, options);
  const GuYauResult result = mapByGuYau({ points, sphere.Triangles });
  EXPECT_LT(result.Energy, start.Energy);
  EXPECT_LT((result.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14);
  const Eigen::VectorXd areas = conformal::vertexAreas(points, sphere.Triangles);
  const Eigen::RowVector3d mean = areas.transpose() * result.Positions / areas.sum();
  EXPECT_LT(mean.norm(), 1e-3);
}

TEST(GuYauMap, TurnsWithTheSurface)
{
  const Mesh sphere = makeGeodesicSphere(6);
  const Points points = ellipsoid(sphere.Positions);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3(1, 2, -3).normalized()).toRotationMatrix();
  GuYauOptions options;
  options.MaximumNumberOfIterations = 50;
  const GuYauResult result = mapByGuYau({ points, sphere.Triangles }, options);
  const GuYauResult turned = mapByGuYau({ points * turn.transpose(), sphere.Triangles }, options);
  EXPECT_LT(maximumDistance(turned.Positions, result.Positions * turn.transpose()), 1e-10);
}
