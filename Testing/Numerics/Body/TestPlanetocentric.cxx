#include "Body/Planetocentric.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/OutermostHits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using conformal::BodyCoordinatesOptions;
using conformal::Index;
using conformal::MapImage;
using conformal::Mesh;
using conformal::PlanetocentricFrame;
using conformal::Points;
using conformal::Vector3;

namespace
{
// Two concentric shells; the outer one is an ellipsoid.
Mesh shells()
{
  const Mesh sphere = conformal::makeGeodesicSphere(24);
  const Index points = sphere.Positions.rows(), triangles = sphere.Triangles.rows();
  Mesh mesh;
  mesh.Positions.resize(2 * points, 3);
  mesh.Positions << 0.2 * sphere.Positions, sphere.Positions * Vector3(1.0, 0.8, 0.6).asDiagonal();
  mesh.Triangles.resize(2 * triangles, 3);
  mesh.Triangles << sphere.Triangles, sphere.Triangles.array() + static_cast<int>(points);
  return mesh;
}
}

TEST(Planetocentric, KnowsAxesAndMarker)
{
  BodyCoordinatesOptions options;
  options.Center = { 1.0, 2.0, 3.0 };
  options.RotationAxis = { 0.0, 5.0, 0.0 };
  options.UseMarkerPoint = true;
  options.MarkerPoint = options.Center + Vector3(0.0, 0.7, 2.0);
  Points points(4, 3);
  points << 1, 2, 5, 3, 2, 3, 1, 4, 3, 1, 1, 2;
  const Points result =
    conformal::planetocentricCoordinates(points, conformal::planetocentricFrame(options));
  EXPECT_NEAR(result(0, 0), 0.0, 1e-12); // the marker's meridian
  EXPECT_NEAR(result(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(result(0, 2), 2.0, 1e-15);
  EXPECT_NEAR(result(1, 0), 90.0, 1e-12); // east is counter-clockwise around the north pole
  EXPECT_NEAR(result(2, 1), 90.0, 1e-12);
  EXPECT_NEAR(result(3, 0), 180.0, 1e-12);
  EXPECT_NEAR(result(3, 1), -45.0, 1e-12);
  options.MarkerPoint = options.Center + Vector3(0.0, 0.7, 0.0);
  EXPECT_THROW(conformal::planetocentricFrame(options), std::invalid_argument);
  // On an oblique axis, rounding leaves a small part across it.
  options.Center.setZero();
  for (const Vector3& axis : { Vector3(2.04, -2.56, 0.42), Vector3(-0.57, -0.45, -0.22),
         Vector3(-2.02, -0.23, -0.87), Vector3(0.31, 1.17, -2.9) })
  {
    options.RotationAxis = axis;
    options.MarkerPoint = 0.3 * axis;
    EXPECT_THROW(conformal::planetocentricFrame(options), std::invalid_argument);
  }
}

// A pixel shows the outer shell, at the longitude and latitude of the pixel.
TEST(Planetocentric, PixelsShowTheirLongitudeLatitudeAndTheOutermostPoint)
{
  const Mesh body = shells();
  MapImage map;
  map.Grid = { 72, 36 };
  PlanetocentricFrame frame;
  frame.Center = { 0.05, -0.02, 0.01 };
  frame.Axes << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  std::vector<int> seen(map.Grid.size(), 0);
  conformal::paintPlanetocentricMap(body, frame, map,
    [&](Index first, const std::vector<conformal::SurfacePlace>& places)
    {
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Index pixel = first + static_cast<Index>(i);
        ASSERT_GE(places[i].Ids[0], body.Positions.rows() / 2);
        Vector3 x = Vector3::Zero(), n;
        for (int k = 0; k < 3; ++k)
        {
          x += places[i].Weights[k] * body.Positions.row(places[i].Ids[k]).transpose();
        }
        ASSERT_TRUE(map.directionOf(pixel, n));
        const Vector3 way = frame.Axes.transpose() * (x - frame.Center);
        EXPECT_LT((way.normalized() - n).norm(), 1e-9);
        ++seen[pixel];
      }
    });
  EXPECT_EQ(seen, std::vector<int>(map.Grid.size(), 1));
}

TEST(OutermostHits, AgreeWithTrianglesOneByOne)
{
  const Mesh body = shells();
  const conformal::OutermostHits all(body.Positions, body.Triangles);
  const Points directions = conformal::makeGeodesicSphere(3).Positions;
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const Vector3 direction = directions.row(i), origin(0.1, 0.3, -0.2);
    double farthest = 0.0;
    for (Index r = 0; r < body.Triangles.rows(); ++r)
    {
      const conformal::Triangles one = body.Triangles.row(r);
      farthest = std::max(
        farthest, conformal::OutermostHits(body.Positions, one).along(origin, direction).Distance);
    }
    EXPECT_EQ(all.along(origin, direction).Distance, farthest);
    EXPECT_GT(farthest, 0.0);
    EXPECT_EQ(all.along(5.0 * direction, direction).Triangle, -1); // away from the body
  }
}

TEST(Planetocentric, StopsWhenAsked)
{
  MapImage map;
  map.Grid = { 512, 256 };
  const Mesh body = shells();
  EXPECT_THROW(conformal::paintPlanetocentricMap(
                 body, {}, map, [](Index, const auto&) {}, runs::stoppingAt(0.5)),
    conformal::Aborted);
  map.Grid = { 0, 0 };
  EXPECT_THROW(conformal::paintPlanetocentricMap(body, {}, map, [](Index, const auto&) {}),
    std::invalid_argument);
}
