#include "Texture/AveragedTexture.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using conformal::averageSphericalTexture;
using conformal::imageHeightFor;
using conformal::Index;
using conformal::MappedMesh;
using conformal::PixelGrid;
using conformal::PointMixture;
using conformal::Points;
using conformal::SphereImage;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
MappedMesh unitSphere(int frequency)
{
  const auto sphere = conformal::makeGeodesicSphere(frequency);
  MappedMesh mesh;
  mesh.Triangles = sphere.Triangles;
  mesh.Positions = mesh.SpherePositions = sphere.Positions;
  return mesh;
}

SphereImage octahedral()
{
  SphereImage image;
  image.Projection = conformal::SphereProjection::Octahedral;
  image.View.Pole = Vector3::UnitZ();
  image.View.Up = Vector3::UnitY();
  image.View.Right = Vector3::UnitX();
  return image;
}

// Bake the x coordinate of a cloud, and return the largest error of a pixel.
double errorOfX(const Points& cloud, const Triangles& triangles, Index side)
{
  const MappedMesh sphere = unitSphere(40);
  const SphereImage image = octahedral();
  const PixelGrid grid = { side, side };
  double worst = 0.0;
  std::vector<double> errors(grid.size(), HUGE_VAL);
  averageSphericalTexture(sphere, cloud, triangles, image, grid,
    [&](Index first, const std::vector<PointMixture>& mixtures)
    {
      for (std::size_t i = 0; i < mixtures.size(); ++i)
      {
        const Index pixel = first + static_cast<Index>(i);
        double sum = 0.0, weights = 0.0;
        for (const auto& [id, weight] : mixtures[i])
        {
          sum += weight * cloud(id, 0);
          weights += weight;
        }
        EXPECT_NEAR(weights, 1.0, 1e-12);
        errors[pixel] = std::abs(sum - conformal::textureToSphere(grid.middleOf(pixel), image)[0]);
      }
    });
  for (const double error : errors)
  {
    worst = std::max(worst, error);
  }
  return worst;
}
}

TEST(AveragedTexture, ShowsTheValuesOfACloudAndOfTriangles)
{
  const auto sphere = conformal::makeGeodesicSphere(40);
  EXPECT_LT(errorOfX(sphere.Positions, Triangles(0, 3), 64), 0.03); // spacing of the points
  EXPECT_LT(errorOfX(sphere.Positions, sphere.Triangles, 64), 0.01);
}

// A cap of the sphere without points is filled from its border, without a hole.
TEST(AveragedTexture, FillsGaps)
{
  const auto sphere = conformal::makeGeodesicSphere(40);
  Points cloud(0, 3);
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    if (sphere.Positions(v, 2) < 0.9)
    {
      cloud.conservativeResize(cloud.rows() + 1, 3);
      cloud.row(cloud.rows() - 1) = sphere.Positions.row(v);
    }
  }
  EXPECT_LT(errorOfX(cloud, Triangles(0, 3), 64), 0.5);
}

// A pixel that shows many points is their mean: x of two points at each place differs by 2.
TEST(AveragedTexture, AveragesManyPointsOfAPixel)
{
  const auto sphere = conformal::makeGeodesicSphere(60);
  const MappedMesh mesh = unitSphere(20);
  const PixelGrid grid = { 8, 8 };
  averageSphericalTexture(mesh, sphere.Positions, Triangles(0, 3), octahedral(), grid,
    [&](Index, const std::vector<PointMixture>& mixtures)
    {
      for (const PointMixture& mixture : mixtures)
      {
        EXPECT_GE(mixture.size(), 40u);
        for (const auto& [id, weight] : mixture)
        {
          EXPECT_LT(weight, 0.2);
        }
      }
    });
}

TEST(AveragedTexture, SizeGrowsWithTheDensityOfTheScan)
{
  const MappedMesh surface = unitSphere(20);
  const auto coarse = conformal::makeGeodesicSphere(40), fine = conformal::makeGeodesicSphere(80);
  const Index height = imageHeightFor(surface, coarse.Positions, octahedral(), 4.0);
  EXPECT_EQ(height % 64, 0);
  // 16,002 points with 4 pixels each need 253^2 pixels in a map that preserves areas.
  EXPECT_GE(height, 253);
  EXPECT_LE(height, 640);
  EXPECT_NEAR(static_cast<double>(imageHeightFor(surface, fine.Positions, octahedral(), 4.0)),
    2.0 * static_cast<double>(height), 128.0);
}

TEST(AveragedTexture, RejectsBadInput)
{
  const MappedMesh surface = unitSphere(4);
  const auto nothing = [](Index, const std::vector<PointMixture>&) {};
  EXPECT_THROW(averageSphericalTexture(
                 surface, Points(0, 3), Triangles(0, 3), octahedral(), { 4, 4 }, nothing),
    std::invalid_argument);
  EXPECT_THROW(averageSphericalTexture(
                 surface, surface.Positions, Triangles(0, 3), octahedral(), { 0, 4 }, nothing),
    std::invalid_argument);
  EXPECT_THROW(averageSphericalTexture(
                 MappedMesh(), surface.Positions, Triangles(0, 3), octahedral(), { 4, 4 }, nothing),
    std::invalid_argument);
  EXPECT_THROW(
    imageHeightFor(surface, surface.Positions, octahedral(), 0.0), std::invalid_argument);
  Points broken = surface.Positions;
  broken(3, 1) = std::nan("");
  EXPECT_THROW(
    averageSphericalTexture(surface, broken, Triangles(0, 3), octahedral(), { 4, 4 }, nothing),
    std::invalid_argument);
}
