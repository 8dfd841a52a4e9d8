#include "Body/MapOutlines.h"

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

using conformal::Degree;
using conformal::Index;
using conformal::MapImage;
using conformal::MapOutline;
using conformal::MappedMesh;
using conformal::MapProjection;
using conformal::measureMapOutlines;
using conformal::Pi;
using conformal::SurfaceOutline;
using conformal::Vector2;
using conformal::Vector3;
using spheres::mapped;

namespace
{
SurfaceOutline measured(
  const MappedMesh& body, const MapImage& image, std::vector<Vector2> corners, bool isClosed)
{
  return measureMapOutlines(body, image, { { std::move(corners), isClosed } })[0];
}

// One pixel of this image is a degree. The lower left corner is at 180 degrees west and 90 south.
const MapImage Degrees = { MapProjection::Equirectangular, 0.0, { 360, 180 } };

Vector2 place(double longitude, double latitude)
{
  return { longitude + 180.0, latitude + 90.0 };
}

// Height of a latitude in a Mercator image of 1000 by 1000 pixels.
double mercator(double latitude)
{
  return 500.0 * (1.0 + std::asinh(std::tan(latitude * Degree)) / Pi);
}
}

// Errors are those of the flat triangles: a quarter at half the size.
TEST(MapOutlines, LinesAndRectanglesOfTheSphereConverge)
{
  double errors[3][4];
  int level = 0;
  for (const int frequency : { 15, 30, 60 })
  {
    const MappedMesh ball = mapped(frequency);
    const auto results = measureMapOutlines(ball, Degrees,
      { { { place(-180, 0), place(180, 0) }, false },   // equator
        { { place(20, -90), place(20, 90) }, false },   // meridian
        { { place(-180, 60), place(180, 60) }, false }, // parallel
        { { place(10, 20), place(50, 20), place(50, 60), place(10, 60) }, true } });
    const double rectangle = 40.0 * Degree * (std::sin(60 * Degree) - std::sin(20 * Degree));
    EXPECT_EQ(results[0].Area, 0.0);
    errors[level][0] = std::abs(results[0].Length - 2.0 * Pi);
    errors[level][1] = std::abs(results[1].Length - Pi);
    errors[level][2] = std::abs(results[2].Length - Pi);
    errors[level++][3] = std::abs(results[3].Area / rectangle - 1.0);
    EXPECT_NEAR(results[0].PictureLength, 360.0, 1e-9);
    EXPECT_NEAR(results[3].PictureArea, 1600.0, 1e-9);
  }
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_LT(errors[2][k], 2e-3) << k;
    EXPECT_LT(errors[1][k], 0.35 * errors[0][k]) << k;
    EXPECT_LT(errors[2][k], 0.35 * errors[1][k]) << k;
  }
}

// A straight line of a Mercator map has a constant angle from north: its length is the difference
// of latitudes over the cosine. The map is conformal, so that angles are those of the image.
TEST(MapOutlines, RhumbLinesAndAnglesAreKnown)
{
  const MappedMesh ball = mapped(50);
  const MapImage image = { MapProjection::Mercator, 0.0, { 1000, 1000 } };
  const double high = mercator(65.0), low = mercator(-30.0), across = 400.0;
  const auto line = measured(ball, image, { { 300.0, low }, { 300.0 + across, high } }, false);
  const double bearing = std::atan2(across, high - low);
  EXPECT_NEAR(line.Length / (95.0 * Degree / std::cos(bearing)), 1.0, 3e-4);
  const std::vector<Vector2> corners = { { 200, 300 }, { 700, 420 }, { 600, 700 }, { 450, 500 },
    { 300, 750 } };
  for (const bool isReversed : { false, true })
  {
    std::vector<Vector2> drawn = corners;
    if (isReversed)
    {
      std::reverse(drawn.begin(), drawn.end());
    }
    const auto polygon = measured(ball, image, drawn, true);
    int found = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < polygon.Corners.size(); ++i)
    {
      const int id = polygon.Corners[i];
      if (id < 0)
      {
        EXPECT_EQ(polygon.Angles[i], 0.0);
        continue;
      }
      const Vector2 here = drawn[id], a = drawn[(id + 4) % 5] - here,
                    b = drawn[(id + 1) % 5] - here;
      double angle = std::acos(a.normalized().dot(b.normalized())) / Degree;
      angle = here == corners[3] ? 360.0 - angle : angle;
      EXPECT_NEAR(polygon.Angles[i], angle, 1.5) << id;
      sum += polygon.Angles[i];
      ++found;
    }
    EXPECT_EQ(found, 5);
    EXPECT_NEAR(sum, 540.0, 1.5);
    EXPECT_EQ(polygon.Corners.back(), polygon.Corners.front());
    EXPECT_EQ(polygon.Positions.row(0), polygon.Positions.bottomRows(1));
  }
}

// A spherical triangle of great circles, drawn with many corners: Girard's theorem gives its area
// from its angles.
TEST(MapOutlines, AreaOfASphericalTriangleIsItsExcess)
{
  const MappedMesh ball = mapped(30);
  const Vector3 corners[] = { Vector3(1, -0.3, 0.2).normalized(), Vector3(0.6, 1, 0.1).normalized(),
    Vector3(0.4, 0.2, 1).normalized() };
  for (const MapProjection projection :
    { MapProjection::Equirectangular, MapProjection::Mollweide, MapProjection::PeirceQuincuncial })
  {
    const MapImage image = { projection, 0.0, { 900, 900 } };
    std::vector<Vector2> drawn;
    constexpr int pieces = 100;
    double excess = -Pi, perimeter = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
      for (int i = 0; i < pieces; ++i)
      {
        drawn.push_back(image.toPixels((a + (b - a) * i / pieces).normalized()));
      }
      excess += std::acos(a.cross(b).normalized().dot(a.cross(c).normalized()));
      perimeter += std::acos(a.dot(b));
    }
    const auto triangle = measured(ball, image, drawn, true);
    EXPECT_NEAR(triangle.Area / excess, 1.0, 2e-3) << static_cast<int>(projection);
    EXPECT_NEAR(triangle.Length / perimeter, 1.0, 1e-3);
  }
}

// The cylinder of a capsule is developable: on its map, everything is true to scale.
TEST(MapOutlines, CylindersAreTrueToScale)
{
  const double half = 4.0;
  const MappedMesh body = capsules::make(half, 120);
  MapImage image = { MapProjection::Capsule, 0.0, { 300, 700 }, half + 1.0 };
  const double unit = 2.0 * image.halfSize()[0] / 300.0;
  const std::vector<Vector2> corners = { { 100, 200 }, { 220, 250 }, { 180, 480 }, { 110, 300 } };
  const auto polygon = measured(body, image, corners, true);
  EXPECT_NEAR(polygon.Length / (unit * polygon.PictureLength), 1.0, 3e-4);
  EXPECT_NEAR(polygon.Area / (unit * unit * polygon.PictureArea), 1.0, 6e-4);
  for (std::size_t i = 0; i < polygon.Corners.size(); ++i)
  {
    if (polygon.Corners[i] >= 0)
    {
      const int id = polygon.Corners[i];
      const Vector2 a = corners[(id + 3) % 4] - corners[id],
                    b = corners[(id + 1) % 4] - corners[id];
      EXPECT_NEAR(polygon.Angles[i], std::acos(a.normalized().dot(b.normalized())) / Degree, 1.2);
    }
  }
  // A circle of latitude of a cap, inside of a disk of the map
  std::vector<Vector2> circle;
  const double colatitude = 50.0 * Degree, middle = half + std::sqrt(2.0);
  for (int i = 0; i < 360; ++i)
  {
    const double radius = 2.0 * std::sin(0.5 * colatitude);
    circle.push_back(Vector2(150, 350) +
      Vector2(radius * std::cos(i * Degree), middle + radius * std::sin(i * Degree)) / unit);
  }
  const auto cap = measured(body, image, circle, true);
  EXPECT_NEAR(cap.Length / (2.0 * Pi * std::sin(colatitude)), 1.0, 2e-3);
  EXPECT_NEAR(cap.Area / (2.0 * Pi * (1.0 - std::cos(colatitude))), 1.0, 2e-3);
  // The end of the cylinder is drawn twice, away from the central meridian.
  EXPECT_FALSE(measured(body, image, { { 120, 350 }, { 120, 600 } }, false).IsOnMap);
}

// A spheroid whose map is that of a sphere: a zone of it has a known area.
TEST(MapOutlines, AreasAreThoseOfTheBody)
{
  MappedMesh body = mapped(30);
  const double a = 2.5;
  body.Positions.col(2) *= a;
  const auto zone = measured(
    body, Degrees, { place(-180, -30), place(180, -30), place(180, 50), place(-180, 50) }, true);
  // Area between heights: 2 pi times the integral of sqrt(1 + (a^2 - 1) ... ) over the sine.
  double area = 0.0;
  constexpr int pieces = 2000;
  const double from = std::sin(-30 * Degree), to = std::sin(50 * Degree);
  for (int i = 0; i < pieces; ++i)
  {
    const double z = from + (to - from) * (i + 0.5) / pieces;
    area += 2.0 * Pi * std::sqrt(a * a * (1.0 - z * z) + z * z) * (to - from) / pieces;
  }
  EXPECT_NEAR(zone.Area / area, 1.0, 2e-3);
  const auto all = measured(
    body, Degrees, { place(-180, -90), place(180, -90), place(180, 90), place(-180, 90) }, true);
  EXPECT_NEAR(all.Area / conformal::surfaceArea(body.Positions, body.Triangles), 1.0, 1e-9);
}

TEST(MapOutlines, DoNotDependOnThePlaceOfTheBody)
{
  MappedMesh body = mapped(12);
  const std::vector<Vector2> square = { place(10, 10), place(30, 10), place(30, 30),
    place(10, 30) };
  const SurfaceOutline here = measured(body, Degrees, square, true);
  const Vector3 way(1e8, -2e8, 3e7);
  body.Positions.rowwise() += way.transpose();
  const SurfaceOutline there = measured(body, Degrees, square, true);
  EXPECT_NEAR(there.Length, here.Length, 1e-5);
  EXPECT_NEAR(there.Area, here.Area, 1e-6);
  ASSERT_EQ(here.Corners.front(), 0);
  EXPECT_NEAR(there.Angles.front(), here.Angles.front(), 1e-3);
  const Vector3 corner = there.Positions.row(0) - here.Positions.row(0);
  EXPECT_LT((corner - way).norm(), 1e-6);
}

// An outline across the sides of the image is that in the middle of an image with another central
// meridian.
TEST(MapOutlines, OutlinesContinueBeyondTheSides)
{
  const MappedMesh ball = mapped(20);
  const std::vector<Vector2> middle = { { 160, 70 }, { 210, 75 }, { 190, 120 } };
  std::vector<Vector2> right = middle, left = middle;
  for (int k = 0; k < 3; ++k)
  {
    right[k][0] += 180.0;
    left[k][0] -= 180.0;
  }
  MapImage turned = Degrees;
  turned.CentralLongitude = 180.0;
  const auto expected = measured(ball, turned, middle, true);
  for (const auto& corners : { right, left })
  {
    const auto found = measured(ball, Degrees, corners, true);
    EXPECT_TRUE(found.IsOnMap);
    EXPECT_NEAR(found.Length, expected.Length, 1e-6);
    EXPECT_NEAR(found.Area, expected.Area, 2e-6);
  }
}

TEST(MapOutlines, OutlinesThatLeaveTheMapHaveNoMeasures)
{
  const MappedMesh ball = mapped(10);
  const MapImage disks = { MapProjection::LambertAzimuthal, 0.0, { 200, 100 } };
  const auto across = measured(ball, disks, { { 60, 70 }, { 140, 70 } }, false);
  EXPECT_FALSE(across.IsOnMap);
  EXPECT_EQ(across.Length, 0.0);
  EXPECT_EQ(across.Positions.rows(), 0);
  EXPECT_FALSE(measured(ball, Degrees, { { 100, 170 }, { 100, 190 } }, false).IsOnMap);
  EXPECT_FALSE(measured(ball, Degrees, { { 100, 170 }, { 100, 170 } }, true).IsOnMap);
  EXPECT_FALSE(measured(ball, Degrees, {}, true).IsOnMap);
  EXPECT_THROW(measured(ball, Degrees, { { 100, 1e9 }, { 100, 1 } }, false), std::invalid_argument);
  EXPECT_THROW(
    measured(ball, Degrees, { { std::nan(""), 3 }, { 100, 1 } }, false), std::invalid_argument);
}

TEST(MapOutlines, RefusesASurfaceWithAPointThatIsNotFinite)
{
  MappedMesh ball = mapped(10);
  ball.Positions(100, 1) = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(measured(ball, Degrees, { { 100, 90 }, { 120, 90 } }, false), std::invalid_argument);
}

TEST(MapOutlines, SameBitsOnAnyThreadsAndStops)
{
  const MappedMesh ball = mapped(12);
  std::vector<MapOutline> outlines;
  for (int i = 0; i < 9; ++i)
  {
    outlines.push_back(
      { { { 20.0 * i, 60 }, { 20.0 * i + 30, 70 }, { 20.0 * i + 5, 110 } }, true });
  }
  const auto one = measureMapOutlines(ball, Degrees, outlines),
             two = measureMapOutlines(ball, Degrees, outlines, runs::backwards());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_GT(one[i].Area, 0.0);
    EXPECT_EQ(one[i].Area, two[i].Area);
    EXPECT_EQ(one[i].Length, two[i].Length);
    EXPECT_EQ(one[i].Angles, two[i].Angles);
  }
  EXPECT_THROW(
    measureMapOutlines(ball, Degrees, outlines, runs::stoppingAt(0.3)), conformal::Aborted);
}
