#include "Body/MapAreas.h"

#include "Body/BodyCoordinates.h"
#include "Capsules.h"
#include "Mesh/GenusZeroCheck.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using conformal::areaOfPixel;
using conformal::findCapsuleAspect;
using conformal::Index;
using conformal::MapImage;
using conformal::MappedMesh;
using conformal::MapProjection;
using conformal::Pi;
using conformal::SurfacePlace;
using conformal::Vector3;

namespace
{
std::vector<double> pixelAreas(const MappedMesh& body, const MapImage& image)
{
  std::vector<double> areas(image.Grid.size());
  conformal::paintMap(body, image,
    [&](Index first, const std::vector<SurfacePlace>& places)
    {
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Index pixel = first + static_cast<Index>(i);
        areas[pixel] = areaOfPixel(body, image, pixel, places[i]);
      }
    });
  return areas;
}

double sum(const std::vector<double>& values)
{
  double result = 0.0;
  for (const double value : values)
  {
    result += value;
  }
  return result;
}
}

// A capsule is found by its map to the sphere, however long.
TEST(MapAreas, FindsTheAspectOfACapsule)
{
  for (const double aspect : { 1.0, 1.5, 2.0, 5.0, 10.0, 20.0 })
  {
    EXPECT_NEAR(findCapsuleAspect(capsules::make(aspect - 1.0, 40)), aspect, 0.03);
  }
  EXPECT_EQ(findCapsuleAspect(capsules::make(40.0, 12)), conformal::MaximumCapsuleAspect);
}

// On a capsule, all pixels show the same area, and together the whole surface. The deviation is
// that of the triangles: a quarter at half the size, or less.
TEST(MapAreas, PixelsOfACapsuleShowEqualAreas)
{
  for (const double aspect : { 1.0, 3.0, 12.0, 20.0 })
  {
    double errors[2];
    for (const int level : { 0, 1 })
    {
      const MappedMesh body = capsules::make(aspect - 1.0, level == 0 ? 40 : 120);
      const MapImage image = { MapProjection::Capsule, 0.0,
        { 80, static_cast<Index>(40 + 30 * aspect) }, aspect };
      const std::vector<double> areas = pixelAreas(body, image);
      const double whole = conformal::surfaceArea(body.Positions, body.Triangles);
      EXPECT_NEAR(sum(areas) / whole, 1.0, 0.03) << aspect;
      const auto compared = conformal::comparePixelAreas(areas);
      errors[level] = compared.High / compared.Low - 1.0;
    }
    EXPECT_LT(errors[0], 0.25) << aspect;
    EXPECT_LT(errors[1], 0.09) << aspect;
    EXPECT_LT(errors[1], 0.5 * errors[0]) << aspect;
  }
}

// In other projections of a sphere, areas are those of the projection.
TEST(MapAreas, AreasOfOtherMapsAreKnown)
{
  const MappedMesh ball = spheres::mapped(60);
  const MapImage image = { MapProjection::Equirectangular, 0.0, { 72, 36 } };
  const std::vector<double> areas = pixelAreas(ball, image);
  for (Index row = 0; row < 36; ++row)
  {
    const double latitude = (row - 17.5) * 5.0 * Pi / 180.0,
                 expected = std::cos(latitude) * std::pow(5.0 * Pi / 180.0, 2);
    for (Index column = 0; column < 72; ++column)
    {
      EXPECT_NEAR(areas[72 * row + column] / expected, 1.0, 0.035) << row;
    }
  }
  const auto mollweide =
    conformal::comparePixelAreas(pixelAreas(ball, { MapProjection::Mollweide, 0.0, { 120, 60 } }));
  EXPECT_LT(mollweide.High / mollweide.Low, 1.05);
  EXPECT_EQ(*std::min_element(mollweide.Scales.begin(), mollweide.Scales.end()), 0.0); // corners
}

TEST(MapAreas, RangesLeaveOutFivePercent)
{
  std::vector<double> areas(102, 1.0);
  areas[7] = 0.0;
  areas[9] = 4.0; // 4 of 103 parts of the area
  areas[50] = 1e-3;
  const auto compared = conformal::comparePixelAreas(areas);
  EXPECT_EQ(compared.Low, compared.High);
  EXPECT_EQ(compared.Scales[7], 0.0);
  EXPECT_NEAR(compared.Scales[9] / compared.Scales[8], 4.0, 1e-12);
  EXPECT_NEAR(sum(compared.Scales), 101.0, 1e-9); // the mean is 1
  EXPECT_EQ(conformal::comparePixelAreas({ 0.0, 0.0 }).Low, 1.0);
}

TEST(MapAreas, AspectsAreThoseOfTheProperty)
{
  const MappedMesh body = capsules::make(2.0, 24);
  EXPECT_EQ(conformal::capsuleAspectOf(body, MapProjection::Mercator, 4.0), 1.0);
  EXPECT_EQ(conformal::capsuleAspectOf(body, MapProjection::Capsule, 4.0), 4.0);
  EXPECT_EQ(conformal::capsuleAspectOf(body, MapProjection::Capsule, 0.5), findCapsuleAspect(body));
  EXPECT_THROW(conformal::capsuleAspectOf(
                 body, MapProjection::Capsule, std::numeric_limits<double>::quiet_NaN()),
    std::invalid_argument);
  EXPECT_THROW(findCapsuleAspect({}), std::invalid_argument);
  EXPECT_THROW(findCapsuleAspect(body, runs::stoppingAt(0.5)), conformal::Aborted);
}

// A bent tube: its ends are not on a straight axis through it.
TEST(MapAreas, EndsOfABentTubeAreItsPoles)
{
  MappedMesh body = capsules::make(7.0, 32);
  const Vector3 ends[] = { body.Positions.row(0), body.Positions.bottomRows(1).transpose() };
  EXPECT_EQ(ends[0][2], -8.0);
  const double turn = 0.3;
  for (Index v = 0; v < body.Positions.rows(); ++v)
  {
    const Vector3 x = body.Positions.row(v);
    const double radius = 1.0 / turn - x[0], angle = turn * x[2];
    body.Positions.row(v) << 1.0 / turn - radius * std::cos(angle), x[1], radius * std::sin(angle);
  }
  conformal::BodyCoordinatesOptions options;
  options.UseEnds = true;
  options.Center = Vector3(2.0, 0.0, 0.0);
  const auto coordinates = conformal::findBodyCoordinates(body, options);
  const Vector3 south = body.Positions.row(0), north = body.Positions.bottomRows(1).transpose();
  EXPECT_LT((coordinates.NorthPole - (north[2] > south[2] ? north : south)).norm(), 1.0);
  EXPECT_LT((coordinates.SouthPole - (north[2] > south[2] ? south : north)).norm(), 1.0);
  body.SpherePositions = coordinates.SpherePositions;
  EXPECT_NEAR(findCapsuleAspect(body), 8.0, 0.4);
}
