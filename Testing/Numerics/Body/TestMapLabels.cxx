#include "Body/MapLabels.h"

#include "Body/BodyCoordinates.h"
#include "Mesh/GenusZeroCheck.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::LabelMeasure;
using conformal::MapImage;
using conformal::MapLabels;
using conformal::MappedMesh;
using conformal::MapProjection;
using conformal::measureMapLabels;
using conformal::Pi;
using conformal::Vector3;
using spheres::mapped;

namespace
{
// Labels of caps around directions, by the angle from them.
std::vector<int> paintedCaps(
  const MapImage& image, const std::vector<Vector3>& centers, double angle)
{
  std::vector<int> labels(image.Grid.size(), 0);
  for (Index p = 0; p < image.Grid.size(); ++p)
  {
    Vector3 n;
    for (std::size_t c = 0; c < centers.size() && image.directionOf(p, n); ++c)
    {
      labels[p] = n.dot(centers[c]) > std::cos(angle) ? static_cast<int>(c) + 1 : labels[p];
    }
  }
  return labels;
}

const MapProjection All[] = { MapProjection::Equirectangular, MapProjection::LambertAzimuthal,
  MapProjection::Mollweide, MapProjection::PeirceQuincuncial, MapProjection::Mercator };
}

// Caps of known area and perimeter, one of them across the seam of most maps. Errors of areas
// shrink with the size of pixels.
TEST(MapLabels, CapsHaveTheirAreaInEveryProjection)
{
  const MappedMesh ball = mapped(40);
  const double angle = 0.35, area = 2.0 * Pi * (1.0 - std::cos(angle)),
               perimeter = 2.0 * Pi * std::sin(angle);
  const std::vector<Vector3> centers = { Vector3(0.3, 0.5, 0.4).normalized(),
    Vector3(-1.0, 0.05, 0.1).normalized(), Vector3(0.2, -0.9, -0.5).normalized() };
  for (const MapProjection projection : All)
  {
    const bool isSquare =
      projection == MapProjection::PeirceQuincuncial || projection == MapProjection::Mercator;
    for (const Index width : { 100, 400 })
    {
      const MapImage image = { projection, 0.0, { width, isSquare ? width : width / 2 } };
      const MapLabels result = measureMapLabels(ball, image, paintedCaps(image, centers, angle));
      ASSERT_EQ(result.Measures.size(), 3u);
      for (std::size_t c = 0; c < 3; ++c)
      {
        const LabelMeasure& measure = result.Measures[c];
        EXPECT_NEAR(measure.Area / area, 1.0, width == 100 ? 0.05 : 0.005)
          << static_cast<int>(projection) << " " << c;
        EXPECT_NEAR(measure.Perimeter / perimeter, 1.0, width == 100 ? 0.08 : 0.035)
          << static_cast<int>(projection) << " " << c;
        EXPECT_LT((measure.Centroid - centers[c]).norm(), width == 100 ? 0.02 : 0.006);
        EXPECT_NEAR(measure.Elongation, 1.0, 0.05);
        EXPECT_EQ(measure.NumberOfNeighbors, 0);
      }
    }
  }
}

// Caps around poles and across seams, where pixels are sheared and oblong.
TEST(MapLabels, PerimetersAreTrueAtPolesAndSeams)
{
  const MappedMesh ball = mapped(32);
  const double angle = 0.5, perimeter = 2.0 * Pi * std::sin(angle);
  const std::vector<Vector3> centers = { Vector3(0, 0, 1), Vector3(-1, 0, 0),
    Vector3(-0.49, 0.59, 0.64).normalized(), Vector3(0.34, 0, -0.94).normalized() };
  for (const MapProjection projection : All)
  {
    const bool isSquare =
      projection == MapProjection::PeirceQuincuncial || projection == MapProjection::Mercator;
    const MapImage image = { projection, 0.0, { 300, isSquare ? 300 : 150 } };
    for (const Vector3& center : centers)
    {
      const MapLabels result = measureMapLabels(ball, image, paintedCaps(image, { center }, angle));
      ASSERT_EQ(result.Measures.size(), 1u);
      EXPECT_NEAR(result.Measures[0].Perimeter / perimeter, 1.0, 0.04)
        << static_cast<int>(projection) << " " << center.transpose();
    }
  }
}

// On an ellipsoid, areas are those of the surface: parts of known sum, and two equal halves.
// A label that is cut by the outline has a part of its perimeter there.
TEST(MapLabels, PerimetersAreTrueAlongOutlines)
{
  const MappedMesh ball = mapped(40);
  for (const MapProjection projection :
    { MapProjection::LambertAzimuthal, MapProjection::Mollweide, MapProjection::Equirectangular })
  {
    const MapImage image = { projection, 0.0, { 300, 150 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      std::vector<int> labels(image.Grid.size(), 0);
      for (Index p = 0; p < image.Grid.size(); ++p)
      {
        Vector3 n;
        labels[p] = image.directionOf(p, n) ? (n[axis] > 0.0 ? 1 : 2) : 0;
      }
      const MapLabels result = measureMapLabels(ball, image, labels);
      ASSERT_EQ(result.Measures.size(), 2u);
      EXPECT_NEAR(result.Measures[0].Perimeter / (2.0 * Pi), 1.0, 0.06)
        << static_cast<int>(projection) << " " << axis;
      EXPECT_EQ(result.Measures[0].Perimeter, result.Measures[1].Perimeter);
    }
  }
}

TEST(MapLabels, AreasAreThoseOfTheBody)
{
  MappedMesh body = mapped(24);
  body.Positions *= Vector3(3.0, 1.0, 0.7).asDiagonal();
  const MapImage image = { MapProjection::Mollweide, 20.0, { 160, 80 } };
  std::vector<int> labels(image.Grid.size(), 0);
  for (Index p = 0; p < image.Grid.size(); ++p)
  {
    Vector3 n;
    labels[p] = image.directionOf(p, n) ? 1 + (n[0] > 0.0) + 2 * (n[2] > 0.0) : 0;
  }
  const MapLabels result = measureMapLabels(body, image, labels);
  const double whole = conformal::surfaceArea(body.Positions, body.Triangles);
  double sum = 0.0;
  for (const LabelMeasure& measure : result.Measures)
  {
    sum += measure.Area;
    EXPECT_NEAR(measure.Area / whole, 0.25, 0.005);
    EXPECT_EQ(
      measure.NumberOfNeighbors, measure.Label > 0 ? 2 + (measure.NumberOfNeighbors > 2) : 0);
  }
  EXPECT_GT(sum / whole, 0.998); // the rest is on the outline
  EXPECT_LT(sum / whole, 1.0 + 1e-12);
  std::vector<int> one(image.Grid.size(), 7);
  const MapLabels all = measureMapLabels(body, image, one);
  ASSERT_EQ(all.Measures.size(), 1u);
  EXPECT_NEAR(all.Measures[0].Area / whole, 1.0, 1e-12);
  EXPECT_EQ(all.Measures[0].Perimeter, 0.0);
  EXPECT_EQ(all.VertexLabels, std::vector<int>(body.Positions.rows(), 7));
}

// A patch that is long on the body, but round on the sphere.
TEST(MapLabels, ElongationIsThatOnTheBody)
{
  MappedMesh body = mapped(30);
  body.Positions *= Vector3(1.0, 1.0, 2.5).asDiagonal();
  const MapImage image = { MapProjection::Equirectangular, 0.0, { 400, 200 } };
  const MapLabels result =
    measureMapLabels(body, image, paintedCaps(image, { Vector3(1, 0, 0) }, 0.2));
  ASSERT_EQ(result.Measures.size(), 1u);
  EXPECT_NEAR(result.Measures[0].Elongation, 2.5, 0.05);
  EXPECT_GT(result.Measures[0].LongAxis[2], 0.999);
}

TEST(MapLabels, DoNotDependOnThePlaceOfTheBody)
{
  MappedMesh body = mapped(12);
  body.Positions *= Vector3(3.0, 2.0, 1.0).asDiagonal();
  const MapImage image = { MapProjection::Equirectangular, 0.0, { 120, 60 } };
  const std::vector<int> labels = paintedCaps(image, { Vector3(0.6, 0.8, 0.0) }, 0.3);
  const LabelMeasure here = measureMapLabels(body, image, labels).Measures[0];
  const Vector3 way(1e8, -2e8, 3e7);
  body.Positions.rowwise() += way.transpose();
  const LabelMeasure there = measureMapLabels(body, image, labels).Measures[0];
  EXPECT_GT(here.Elongation, 1.1);
  EXPECT_NEAR(there.Elongation, here.Elongation, 1e-6);
  EXPECT_LT((there.LongAxis - here.LongAxis).norm(), 1e-6);
  EXPECT_LT((there.Centroid - way - here.Centroid).norm(), 1e-6);
}

// Few large triangles: reports come often also then.
TEST(MapLabels, ReportsWithinLargeTriangles)
{
  const MapImage image = { MapProjection::Equirectangular, 0.0, { 400, 200 } };
  std::vector<double> reports = { 0.0 };
  measureMapLabels(mapped(1), image, paintedCaps(image, { Vector3(1, 0, 0) }, 0.3),
    conformal::Run({},
      [&](double fraction)
      {
        reports.push_back(fraction);
        return true;
      }));
  double gap = 0.0;
  for (std::size_t i = 1; i < reports.size(); ++i)
  {
    gap = std::max(gap, reports[i] - reports[i - 1]);
  }
  EXPECT_LT(gap, 0.2);
}

TEST(MapLabels, LabelsBehindALineAreNeighbors)
{
  const MappedMesh ball = mapped(10);
  const MapImage image = { MapProjection::Equirectangular, 0.0, { 40, 20 } };
  std::vector<int> labels(800, 0);
  for (Index p = 0; p < 800; ++p)
  {
    const Index column = p % 40, row = p / 40; // wedges would meet at the poles
    labels[p] = row < 5 || row > 14 || column == 10 || column == 11 || column == 30 ? 0
      : column < 10                                                                 ? 1
      : column < 30                                                                 ? 2
                                                                                    : 3;
  }
  const MapLabels result = measureMapLabels(ball, image, labels);
  ASSERT_EQ(result.Measures.size(), 3u);
  EXPECT_EQ(result.Measures[0].NumberOfNeighbors, 1); // 3, beyond the seam; 2 is too far
  EXPECT_EQ(result.Measures[1].NumberOfNeighbors, 1); // 3, behind a line
  EXPECT_EQ(result.Measures[2].NumberOfNeighbors, 2);
}

TEST(MapLabels, SameBitsOnAnyThreadsAndStops)
{
  const MappedMesh ball = mapped(12);
  const MapImage image = { MapProjection::LambertAzimuthal, 0.0, { 80, 40 } };
  const std::vector<int> labels = paintedCaps(image, { Vector3(0, 0.6, 0.8) }, 0.7);
  const MapLabels one = measureMapLabels(ball, image, labels),
                  two = measureMapLabels(ball, image, labels, runs::backwards());
  EXPECT_EQ(one.Measures[0].Area, two.Measures[0].Area);
  EXPECT_EQ(one.Measures[0].Perimeter, two.Measures[0].Perimeter);
  EXPECT_EQ(one.Measures[0].Centroid, two.Measures[0].Centroid);
  EXPECT_THROW(measureMapLabels(ball, image, labels, runs::stoppingAt(0.5)), conformal::Aborted);
  EXPECT_THROW(measureMapLabels(ball, image, { 1, 2 }), std::invalid_argument);
  MappedMesh broken = ball;
  broken.Positions(5, 1) = std::nan("");
  EXPECT_THROW(measureMapLabels(broken, image, labels), std::invalid_argument);
}
