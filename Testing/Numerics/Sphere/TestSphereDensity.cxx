#include "Sphere/SphereDensity.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

using conformal::densityOnSurface;
using conformal::Index;
using conformal::MappedMesh;
using conformal::SphereDensity;
using conformal::Vector3;

namespace
{
/// A sphere of radius 2 mapped by a Moebius transform, which makes the north larger by a factor.
MappedMesh moebius(double factor, int frequency = 40)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  MappedMesh surface;
  surface.Positions = 2.0 * sphere.Positions;
  surface.Triangles = sphere.Triangles;
  surface.SpherePositions.resize(sphere.Positions.rows(), 3);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    const Vector3 n = sphere.Positions.row(i);
    const double w = 1.0 + n[2], x = factor * n[0], y = factor * n[1], square = x * x + y * y;
    surface.SpherePositions.row(i) = w > 1e-12
      ? Vector3(2.0 * x * w, 2.0 * y * w, w * w - square).normalized()
      : Vector3(0.0, 0.0, -1.0);
  }
  return surface;
}
}

TEST(SphereDensity, OnASurfaceIsTheRatioOfAreas)
{
  const double factor = 3.0;
  const MappedMesh surface = moebius(factor);
  const SphereDensity density =
    densityOnSurface(surface, std::vector<double>(surface.Positions.rows(), 5.0));
  // Lengths at the poles are multiplied by the factor and divided by it; 4 by the radius 2.
  const double atNorth = 5.0 * 4.0 / (factor * factor), atSouth = 5.0 * 4.0 * factor * factor;
  EXPECT_NEAR(density.At({ 0.0, 0.0, 1.0 }), atNorth, 0.02 * atNorth);
  EXPECT_NEAR(density.At({ 0.0, 0.0, -1.0 }), atSouth, 0.02 * atSouth);
  // And in all it is the surface's area, times the weight.
  const double area = 4.0 * std::acos(-1.0) * 4.0;
  EXPECT_NEAR(
    conformal::integralOf(density, conformal::densitiesOf(density)), 5.0 * area, 0.01 * 5.0 * area);
}

TEST(SphereDensity, MirroredMapsAreFine)
{
  MappedMesh surface = moebius(3.0, 10);
  const std::vector<double> ones(surface.Positions.rows(), 1.0);
  const Vector3 direction = Vector3(0.3, -0.5, 0.2).normalized();
  const double expected = densityOnSurface(surface, ones).At(direction);
  surface.Triangles.col(0).swap(surface.Triangles.col(1));
  EXPECT_DOUBLE_EQ(densityOnSurface(surface, ones).At(direction), expected);
}

TEST(SphereDensity, MapsThatDoNotCoverTheSphereOnceAreRefused)
{
  MappedMesh surface = moebius(1.0, 4);
  surface.SpherePositions.col(2) = surface.SpherePositions.col(2).cwiseAbs().eval();
  EXPECT_THROW(densityOnSurface(surface, std::vector<double>(surface.Positions.rows(), 1.0)),
    std::invalid_argument);
}

TEST(SphereDensity, BendingIsTheSumOfPrincipalCurvatures)
{
  const double radius = 3.0;
  conformal::Mesh sphere = conformal::makeGeodesicSphere(30);
  sphere.Positions *= radius;
  const std::vector<double> bending = conformal::vertexBending(sphere);
  const double mean =
    std::accumulate(bending.begin(), bending.end(), 0.0) / static_cast<double>(bending.size());
  EXPECT_NEAR(mean, 2.0 / radius, 0.01 * 2.0 / radius);
  // Flat parts do not bend.
  conformal::Mesh flat = conformal::makeGeodesicSphere(30);
  flat.Positions.col(2) = flat.Positions.col(2).cwiseMax(-0.5).cwiseMin(0.5).eval();
  EXPECT_NEAR(conformal::vertexBending(flat)[0], 0.0, 1e-12);
}

TEST(SphereDensity, HalfOfThePointsLieByBending)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(30);
  mesh.Positions.col(2) = mesh.Positions.col(2).cwiseMax(-0.5).cwiseMin(0.5).eval();
  const std::vector<double> weights = conformal::weightsByBending(mesh);
  EXPECT_NEAR(weights[0], 1.0, 1e-12); // flat
  const std::vector<double> bending = conformal::vertexBending(mesh);
  const auto bent =
    static_cast<std::size_t>(std::max_element(bending.begin(), bending.end()) - bending.begin());
  const double mean = bending[bent] / (weights[bent] - 1.0);
  for (std::size_t v = 0; v < weights.size(); ++v)
  {
    EXPECT_NEAR(weights[v], 1.0 + bending[v] / mean, 1e-9);
  }
  EXPECT_GT(weights[bent], 2.0);
  // In all they double the points.
  const MappedMesh surface = moebius(2.0);
  const auto total = [&](const std::vector<double>& with)
  {
    const SphereDensity density = densityOnSurface(surface, with);
    return conformal::integralOf(density, conformal::densitiesOf(density));
  };
  const double even = total(std::vector<double>(surface.Positions.rows(), 1.0));
  EXPECT_NEAR(total(conformal::weightsByBending(surface)), 2.0 * even, 1e-9 * even);
}

TEST(SphereDensity, MeansOfTrianglesAreWeightedByArea)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(5);
  std::vector<double> values(sphere.Triangles.rows(), 2.5);
  for (const double mean : conformal::vertexMeans(sphere, values))
  {
    EXPECT_NEAR(mean, 2.5, 1e-14);
  }
  // One triangle's value goes to its corners, which all have six like it around or a corner of the
  // icosahedron five.
  values.assign(values.size(), 0.0);
  values[0] = 30.0;
  const std::vector<double> means = conformal::vertexMeans(sphere, values);
  EXPECT_NEAR(std::accumulate(means.begin(), means.end(), 0.0) - means[sphere.Triangles(0, 0)] -
      means[sphere.Triangles(0, 1)] - means[sphere.Triangles(0, 2)],
    0.0, 1e-12);
  EXPECT_NEAR(means[sphere.Triangles(0, 0)], 6.0, 1e-12); // the pole's five are congruent
}

TEST(SphereDensity, HalvesHaveTheSameWeight)
{
  SphereDensity north, everywhere;
  north.Directions = everywhere.Directions = conformal::makeGeodesicSphere(20).Positions;
  north.Areas.assign(north.Directions.rows(), 0.5);
  everywhere.Areas = north.Areas;
  north.At = [](const Vector3& p) { return p[2] > 0.8 ? 1e6 : 0.0; };
  everywhere.At = [](const Vector3&) { return 7.0; };
  const SphereDensity both = conformal::equalShares({ north, everywhere });
  EXPECT_EQ(both.Directions.rows(), 2 * north.Directions.rows());
  // A tenth of the sphere has half of all, and its share of the other half.
  const double ofNorth = both.At({ 0, 0, 1 }), ofRest = both.At({ 0, 0, -1 });
  EXPECT_NEAR(ofNorth / ofRest, 11.0, 0.5);
}

TEST(SphereDensity, BadOnesAreRefused)
{
  SphereDensity density;
  EXPECT_THROW(conformal::densitiesOf(density), std::invalid_argument);
  density.Directions = conformal::makeGeodesicSphere(2).Positions;
  density.Areas.assign(density.Directions.rows(), 1.0);
  EXPECT_THROW(conformal::densitiesOf(density), std::invalid_argument);
  density.At = [](const Vector3& p) { return p[2]; };
  EXPECT_THROW(conformal::densitiesOf(density), std::invalid_argument);
  density.At = [](const Vector3&) { return std::numeric_limits<double>::infinity(); };
  EXPECT_THROW(conformal::isAnywhere(density), std::invalid_argument);
  density.At = [](const Vector3&) { return 0.0; };
  EXPECT_FALSE(conformal::isAnywhere(density));
  EXPECT_THROW(
    conformal::integralOf(density, conformal::densitiesOf(density)), std::invalid_argument);
  density.At = [](const Vector3&) { return 1.0; };
  EXPECT_TRUE(conformal::isAnywhere(density));
  density.Areas.pop_back();
  EXPECT_THROW(conformal::densitiesOf(density), std::invalid_argument);
}
