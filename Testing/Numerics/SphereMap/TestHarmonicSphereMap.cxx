#include "SphereMap/HarmonicSphereMap.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Sphere/ClosestMoebiusTransform.h"
#include "SphereMap/FlipRepair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using conformal::HarmonicSphereMap;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::mapHarmonically;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
// z of the conformal map to the sphere of a spheroid with half axes 1, 1 and c < 1, from the
// eccentricity e and the sine s of the geodetic latitude: the conformal latitude.
double conformalHeight(double s, double e)
{
  return std::tanh(std::atanh(s) - e * std::atanh(e * s));
}
}

TEST(HarmonicSphereMap, OfTheSphereIsTheSphere)
{
  const Mesh sphere = makeGeodesicSphere(16);
  HarmonicSphereMap map = mapHarmonically(sphere);
  EXPECT_TRUE(map.OneToOne);
  EXPECT_FALSE(map.Repaired);
  EXPECT_EQ(map.NumberOfSolves, 1);
  conformal::closestMoebiusTransform(
    map.Positions, sphere.Positions, Eigen::VectorXd::Ones(sphere.Positions.rows()))
    .applyTo(map.Positions);
  EXPECT_LT((map.Positions - sphere.Positions).rowwise().norm().maxCoeff(), 5e-3);
}

// Cartographers know the answer, and it is met better with more triangles.
TEST(HarmonicSphereMap, OfASpheroidIsItsConformalLatitude)
{
  constexpr double c = 0.6;
  const double e = std::sqrt(1.0 - c * c);
  double errors[2] = {};
  for (int level = 0; level < 2; ++level)
  {
    const Mesh sphere = makeGeodesicSphere(level == 0 ? 12 : 24);
    Points points = sphere.Positions, exact = sphere.Positions;
    points.col(2) *= c;
    for (Index v = 0; v < points.rows(); ++v)
    {
      const Vector3 normal =
        Vector3(points(v, 0), points(v, 1), points(v, 2) / (c * c)).normalized();
      const double z =
        std::abs(normal[2]) < 1.0 - 1e-12 ? conformalHeight(normal[2], e) : normal[2];
      const double across = std::hypot(points(v, 0), points(v, 1));
      const double radius = across > 0.0 ? std::sqrt(1.0 - z * z) / across : 0.0;
      exact.row(v) = Vector3(radius * points(v, 0), radius * points(v, 1), z);
    }
    HarmonicSphereMap map = mapHarmonically({ points, sphere.Triangles });
    ASSERT_TRUE(map.OneToOne);
    conformal::closestMoebiusTransform(
      map.Positions, exact, conformal::vertexAreas(points, sphere.Triangles))
      .applyTo(map.Positions);
    errors[level] = std::sqrt((map.Positions - exact).rowwise().squaredNorm().mean());
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], 0.5 * errors[0]);
}

TEST(HarmonicSphereMap, IsCenteredByAreaAndOfUnitLength)
{
  const Mesh sphere = makeGeodesicSphere(10);
  Points points = sphere.Positions;
  for (Index v = 0; v < points.rows(); ++v)
  {
    points.row(v) *= 1.0 + 0.5 * std::exp(4.0 * (sphere.Positions(v, 0) - 1.0));
  }
  const HarmonicSphereMap map = mapHarmonically({ points, sphere.Triangles });
  EXPECT_TRUE(map.OneToOne);
  EXPECT_LT((map.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  const Eigen::VectorXd areas = conformal::vertexAreas(points, sphere.Triangles);
  EXPECT_LT((areas.transpose() * map.Positions / areas.sum()).norm(), 1e-9);
  std::vector<Vector3> positions(map.Positions.rows());
  for (Index v = 0; v < map.Positions.rows(); ++v)
  {
    positions[v] = map.Positions.row(v);
  }
  EXPECT_TRUE(conformal::badTriangles(positions, sphere.Triangles).empty());
}

TEST(HarmonicSphereMap, DoesNotDependOnThreads)
{
  const Mesh sphere = makeGeodesicSphere(10);
  Points points = sphere.Positions;
  points.col(0) *= 3.0;
  const Points one = mapHarmonically({ points, sphere.Triangles }).Positions;
  EXPECT_EQ(mapHarmonically({ points, sphere.Triangles }, runs::backwards()).Positions, one);
}
