#include "Body/MapImage.h"

#include "Body/BodyCoordinates.h"
#include "Projections.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::Index;
using conformal::MapImage;
using conformal::MapMarks;
using conformal::MappedMesh;
using conformal::MapProjection;
using conformal::markMap;
using conformal::Pi;
using conformal::Points;
using conformal::Vector2;
using conformal::Vector3;
using projections::Whole;
using spheres::mapped;

namespace
{
MapImage image(MapProjection projection, Index width, Index height)
{
  MapImage result;
  result.Projection = projection;
  result.Grid = { width, height };
  return result;
}
}

// On a sphere a pixel shows the direction of its place.
TEST(MapImage, ShowsTheDirectionOfEachPixel)
{
  const MappedMesh body = mapped(20);
  for (const MapProjection projection : Whole)
  {
    const MapImage map = image(projection, 60, 40);
    std::vector<int> seen(map.Grid.size(), 0);
    conformal::paintMap(body, map,
      [&](Index first, const std::vector<conformal::SurfacePlace>& places)
      {
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          const Index pixel = first + static_cast<Index>(i);
          Vector3 n;
          ASSERT_EQ(map.directionOf(pixel, n), places[i].Ids[0] >= 0);
          ++seen[pixel];
          if (places[i].Ids[0] >= 0)
          {
            Vector3 position = Vector3::Zero();
            for (int k = 0; k < 3; ++k)
            {
              position += places[i].Weights[k] * body.Positions.row(places[i].Ids[k]).transpose();
            }
            EXPECT_LT((position.normalized() - n).norm(), 1e-9);
            EXPECT_LT((sphereToMap(n, projection, 0.0) - map.placeOf(pixel)).norm(), 1e-9);
          }
        }
      });
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), map.Grid.size());
  }
}

// The outline of two disks, or of an ellipse, leaves out as much of the rectangle.
TEST(MapImage, MarksWhatIsBeyondTheOutline)
{
  for (const MapProjection projection : Whole)
  {
    const MapImage map = image(projection, 600, 300);
    const MapMarks marks = markMap(map, 0.0);
    EXPECT_TRUE(marks.Graticule.empty());
    const double share =
      static_cast<double>(std::count(marks.OutsideMap.begin(), marks.OutsideMap.end(), 1)) /
      static_cast<double>(map.Grid.size());
    const bool isRound =
      projection == MapProjection::LambertAzimuthal || projection == MapProjection::Mollweide;
    EXPECT_NEAR(share, isRound ? 1.0 - Pi / 4.0 : 0.0, 2e-3);
  }
}

// Every pixel on a line has a line between it and the next one, and lines are all there.
TEST(MapImage, DrawsLinesWhereTheyAre)
{
  for (const MapProjection projection : Whole)
  {
    const MapImage map = image(projection, 400, 200);
    const MapMarks marks = markMap(map, 30.0);
    ASSERT_EQ(static_cast<Index>(marks.Graticule.size()), map.Grid.size());
    Index lines = 0;
    for (Index i = 0; i < map.Grid.size(); ++i)
    {
      if (!marks.Graticule[i])
      {
        continue;
      }
      ++lines;
      Vector3 n;
      ASSERT_TRUE(map.directionOf(i, n));
      const Vector2 degrees = conformal::toLongitudeLatitude(n);
      const auto off = [](double value)
      { return std::abs(value - 30.0 * std::round(value / 30.0)); };
      // In degrees of arc; the coarsest of these maps has pixels of 5 degrees somewhere.
      const double arc =
        std::min(off(degrees[1]), off(degrees[0]) * std::cos(degrees[1] * Pi / 180.0));
      EXPECT_LT(arc, 6.0) << static_cast<int>(projection);
    }
    EXPECT_GT(lines, 2000);
    EXPECT_LT(lines, map.Grid.size() / 8);
  }
  // A parallel of the simplest map is a row.
  const MapImage map = image(MapProjection::Equirectangular, 360, 180);
  const MapMarks marks = markMap(map, 30.0);
  for (const Index row : { 29, 59, 89, 119, 149 })
  {
    EXPECT_EQ(
      std::count(marks.Graticule.begin() + row * 360, marks.Graticule.begin() + (row + 1) * 360, 1),
      360);
  }
}

TEST(MapImage, IsTheSameOnAnyThreads)
{
  const MapImage map = image(MapProjection::PeirceQuincuncial, 300, 300);
  const MapMarks one = markMap(map, 10.0), two = markMap(map, 10.0, runs::backwards());
  EXPECT_EQ(one.OutsideMap, two.OutsideMap);
  EXPECT_EQ(one.Graticule, two.Graticule);
  EXPECT_THROW(markMap(map, 10.0, runs::stoppingAt(0.3)), conformal::Aborted);
}
