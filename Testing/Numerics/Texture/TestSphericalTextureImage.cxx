#include "Texture/SphericalTextureImage.h"

#include "Mesh/GeodesicSphere.h"
#include "TextureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::MappedMesh;
using conformal::paintSphericalTexture;
using conformal::PixelGrid;
using conformal::Points;
using conformal::SphereImage;
using conformal::SphereProjection;
using conformal::SurfacePlace;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
const PixelGrid Grid = { 30, 20 };

std::vector<SurfacePlace> painted(const MappedMesh& surface, const SphereImage& image)
{
  std::vector<SurfacePlace> result(Grid.size());
  paintSphericalTexture(surface, image, Grid,
    [&](Index first, const std::vector<SurfacePlace>& places)
    { std::copy(places.begin(), places.end(), result.begin() + first); });
  return result;
}

Vector3 valueAt(const SurfacePlace& place, const Points& values)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += place.Weights[k] * values.row(place.Ids[k]).transpose();
  }
  return sum;
}
}

TEST(SphericalTextureImage, PixelsShowTheirDirection)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  Triangles mirrored = sphere.Triangles; // clockwise on the sphere
  mirrored.col(1).swap(mirrored.col(2));
  SphereImage image;
  image.Margin = 0.05;
  for (SphereProjection projection :
    { SphereProjection::Stereographic, SphereProjection::LongitudeLatitude,
      SphereProjection::Octahedral, SphereProjection::CubeMap })
  {
    image.Projection = projection;
    for (const Triangles& triangles : { sphere.Triangles, mirrored })
    {
      const auto places = painted({ sphere.Positions, triangles, sphere.Positions }, image);
      for (Index i = 0; i < Grid.size(); ++i)
      {
        const Vector3 direction = conformal::textureToSphere(Grid.middleOf(i), image);
        ASSERT_LT((valueAt(places[i], sphere.Positions).normalized() - direction).norm(), 1e-12);
        ASSERT_GE(places[i].Weights.minCoeff(), 0.0);
      }
    }
  }
}

TEST(SphericalTextureImage, LeavesHolesOut)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  Triangles half(sphere.Triangles.rows(), 3);
  Index kept = 0;
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    if (sphere.Positions(sphere.Triangles(r, 0), 2) > 0.3)
    {
      half.row(kept++) = sphere.Triangles.row(r);
    }
  }
  SphereImage image;
  image.Projection = SphereProjection::Octahedral;
  const auto places = painted({ sphere.Positions, half.topRows(kept), sphere.Positions }, image);
  for (Index i = 0; i < Grid.size(); ++i)
  {
    const double z = conformal::textureToSphere(Grid.middleOf(i), image)[2];
    if (std::abs(z - 0.3) > 0.4)
    {
      ASSERT_EQ(places[i].Ids[0] < 0, z < 0.3);
    }
  }
}

// Of a cloud the nearest point, of its triangles the closest place.
TEST(SphericalTextureImage, TakesPlacesFromAnotherSurface)
{
  const auto coarse = conformal::makeGeodesicSphere(6), fine = conformal::makeGeodesicSphere(20);
  const Points model = fixtures::egg(coarse.Positions), cloud = fixtures::egg(fine.Positions);
  const MappedMesh surface = { model, coarse.Triangles, coarse.Positions };
  const SphereImage image;
  const auto own = painted(surface, image);
  for (const Triangles& triangles : { Triangles(0, 3), fine.Triangles })
  {
    paintSphericalTexture(surface, cloud, triangles, image, Grid,
      [&](Index first, const std::vector<SurfacePlace>& places)
      {
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          const Vector3 x = valueAt(own[first + i], model);
          const double distance = (valueAt(places[i], cloud) - x).norm();
          const double nearest = (cloud.rowwise() - x.transpose()).rowwise().norm().minCoeff();
          if (triangles.rows() == 0)
          {
            ASSERT_NEAR(distance, nearest, 1e-15);
          }
          ASSERT_LE(distance, nearest + 1e-15);
        }
      });
  }
}

TEST(SphericalTextureImage, RefusesWhatHasNoPixelsOrPoints)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  const MappedMesh surface = { sphere.Positions, sphere.Triangles, sphere.Positions };
  const auto sink = [](Index, const std::vector<SurfacePlace>&) {};
  EXPECT_THROW(paintSphericalTexture(surface, {}, { 0, 5 }, sink), std::invalid_argument);
  EXPECT_THROW(
    paintSphericalTexture({ sphere.Positions, Triangles(0, 3), sphere.Positions }, {}, Grid, sink),
    std::invalid_argument);
  EXPECT_THROW(
    paintSphericalTexture(surface, conformal::PointView(), Triangles(0, 3), {}, Grid, sink),
    std::invalid_argument);
  Points broken = sphere.Positions;
  broken(3, 1) = std::nan("");
  EXPECT_THROW(paintSphericalTexture(surface, broken, sphere.Triangles, {}, Grid, sink),
    std::invalid_argument);
  EXPECT_THROW(
    paintSphericalTexture(surface, broken, Triangles(0, 3), {}, Grid, sink), std::invalid_argument);
  EXPECT_THROW(paintSphericalTexture({ broken, sphere.Triangles, sphere.Positions },
                 sphere.Positions, sphere.Triangles, {}, Grid, sink),
    std::invalid_argument);
}

// Too large to be squared: nothing is found, nothing breaks.
TEST(SphericalTextureImage, LeavesOutWhatNumbersCannotHold)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  const Points huge = 1e200 * sphere.Positions;
  paintSphericalTexture({ huge, sphere.Triangles, sphere.Positions }, sphere.Positions,
    sphere.Triangles, {}, Grid,
    [&](Index, const std::vector<SurfacePlace>& places)
    {
      for (const SurfacePlace& place : places)
      {
        ASSERT_TRUE(place.Ids[0] < static_cast<int>(sphere.Positions.rows()));
        ASSERT_TRUE(place.Weights.allFinite());
      }
    });
}
