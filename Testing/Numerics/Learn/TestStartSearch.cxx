#include "Learn/StartSearch.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"
#include "Learn/ConformalSOM.h"
#include "Learn/FirstSurface.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::MappedMesh;
using conformal::Mesh;
using conformal::MeshType;
using conformal::StartingShape;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
const double Pi = std::acos(-1.0);
constexpr double Inner = 0.93, Opening = 0.15; // of the radius, of half a turn

// A spherical shell with an opening, whose wall is thinner than its vertices lie apart: of those
// alone nobody can tell that the hollow is outside.
Mesh jar(int frequency)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    const Vector3 n = mesh.Positions.row(i);
    const double polar = std::acos(std::clamp(n[2], -1.0, 1.0)), around = std::atan2(n[1], n[0]);
    const double along = 1.0 - std::abs(1.0 - 2.0 * polar / Pi); // 0 at the poles, 1 at the rim
    const double angle = (1.0 - Opening) * Pi * along;
    const double inwards = std::clamp(20.0 * (polar / Pi - 0.5), -0.5, 0.5) + 0.5;
    mesh.Positions.row(i) = (1.0 - (1.0 - Inner) * inwards) *
      Vector3(
        std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle));
  }
  return mesh;
}

/// A cube of two triangles a side.
Mesh box()
{
  Mesh mesh;
  mesh.Positions.resize(8, 3);
  for (int i = 0; i < 8; ++i)
  {
    mesh.Positions.row(i) << 2 * (i & 1) - 1, (i & 2) - 1, (i & 4) / 2 - 1;
  }
  mesh.Triangles.resize(12, 3);
  mesh.Triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
    2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

double volumeOfJar()
{
  const double solidAngle = 2.0 * Pi * (1.0 - std::cos((1.0 - Opening) * Pi));
  return solidAngle * (1.0 - std::pow(Inner, 3)) / 3.0;
}

ConformalSOMOptions adaptive(Index neurons = 1442)
{
  ConformalSOMOptions options;
  options.MeshType = MeshType::Adaptive;
  options.NumberOfNeurons = neurons;
  return options;
}

double volumeOf(const ConformalSOMResult& result)
{
  return conformal::signedVolume(result.Positions, result.Triangles);
}
}

TEST(StartSearch, LearningFollowsTheMesh)
{
  const Mesh surface = jar(14);
  const MappedMesh start{ surface, {} };
  const TrainingSamples samples{ conformal::PointView(surface.Positions) };
  const ConformalSOMResult result = trainConformalSOM(samples, adaptive(), &start);
  EXPECT_TRUE(result.FromMesh);
  EXPECT_FALSE(result.FromHull);
  EXPECT_EQ(result.NumberOfStarts, 1);
  EXPECT_LE(conformal::defectScore(result.Quality), 1.0);
  EXPECT_NEAR(volumeOf(result), volumeOfJar(), 0.05 * volumeOfJar());
  EXPECT_GT(result.Positions.rowwise().norm().minCoeff(), Inner - 0.03);
  EXPECT_LT(result.Positions.rowwise().norm().maxCoeff(), 1.03);
}

// If they did, the test above would show nothing.
TEST(StartSearch, VerticesAloneDoNotTell)
{
  const Mesh surface = jar(14);
  const TrainingSamples samples{ conformal::PointView(surface.Positions) };
  ConformalSOMOptions options = adaptive();
  options.NumberOfNeurons = 1002;
  const ConformalSOMResult alone = trainConformalSOM(samples, options);
  EXPECT_FALSE(alone.FromMesh);
  EXPECT_GT(volumeOf(alone), 2.0 * volumeOfJar());
}

// Vertices of a sphere under other numbers: closed and of genus zero, but no surface of the points.
TEST(StartSearch, TriesAnotherStartWhereTheMeshIsBad)
{
  const Mesh sphere = conformal::makeGeodesicSphere(6);
  MappedMesh start{ sphere, {} };
  const Index size = sphere.Positions.rows();
  for (Index i = 0; i < size; ++i)
  {
    start.Positions.row(i) =
      sphere.Positions.row(i * 41 % size); // 41 and 362 have no factor in common
  }
  const TrainingSamples samples{ conformal::PointView(start.Positions) };
  ConformalSOMOptions options = adaptive(362);
  const ConformalSOMResult result = trainConformalSOM(samples, options, &start);
  EXPECT_FALSE(result.FromMesh);
  EXPECT_GT(result.NumberOfStarts, 1);
  EXPECT_LE(conformal::defectScore(result.Quality), 1.0);
  EXPECT_NEAR(volumeOf(result), 4.0 / 3.0 * Pi, 0.05 * 4.0 / 3.0 * Pi);
  // Asked for by name it is judged only.
  options.StartingShape = StartingShape::Mesh;
  const ConformalSOMResult kept = trainConformalSOM(samples, options, &start);
  EXPECT_TRUE(kept.FromMesh);
  EXPECT_EQ(kept.NumberOfStarts, 1);
  EXPECT_GT(conformal::defectScore(kept.Quality), 1.0);
}

TEST(StartSearch, TrianglesSayWhatLiesBetweenSparseVertices)
{
  const MappedMesh start{ box(), {} };
  const TrainingSamples samples{ conformal::PointView(start.Positions) };
  const ConformalSOMResult result = trainConformalSOM(samples, adaptive(), &start);
  EXPECT_TRUE(result.FromMesh);
  EXPECT_EQ(result.UnsupportedFraction, 0.0);
  EXPECT_NEAR(volumeOf(result), 8.0, 0.05);
  EXPECT_NEAR(conformal::surfaceArea(result.Positions, result.Triangles), 24.0, 0.2);
  EXPECT_NEAR(result.Positions.cwiseAbs().maxCoeff(), 1.0, 0.02);
}

// The levels of an egg are good, those of a needle are stretched.
TEST(StartSearch, LearnsFromTheSphereWhereThereAreNoLimbs)
{
  conformal::Mesh egg = conformal::makeGeodesicSphere(28);
  egg.Positions.col(1) *= 0.7;
  conformal::Points needle = egg.Positions;
  needle.col(0) *= 12.0;
  const auto learn = [](const conformal::Points& points, StartingShape shape)
  {
    ConformalSOMOptions options = adaptive(2562);
    options.StartingShape = shape;
    return firstSurfaceFromSphere(TrainingSamples{ conformal::PointView(points) }, options, {});
  };
  EXPECT_NO_THROW(learn(egg.Positions, StartingShape::Automatic));
  EXPECT_THROW(learn(needle, StartingShape::Automatic), conformal::NumericalFailure);
  EXPECT_NO_THROW(learn(needle, StartingShape::Sphere));
}

// A ball with a thin ear: between few points, the hull by distance is cracked across the ear. Its
// defects are tolerated, but its map to the sphere is not conformal.
TEST(StartSearch, TriesTheOtherHullWhereTheMapIsNotConformal)
{
  const Vector3 middle(0.0, 0.0, 0.7), axes(0.035, 0.2, 0.4);
  constexpr double ball = 0.5, largest = 60.0; // above all inverse axes
  conformal::Random random(46);                // five of the seeds from 1 to 60 give such a hull
  conformal::Points points(5000, 3);
  for (Index i = 0; i < points.rows();)
  {
    const double z = 2.0 * random.uniform() - 1.0, around = 2.0 * Pi * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 n(r * std::cos(around), r * std::sin(around), z);
    const bool onEar = random.uniform() < 0.15; // of the area
    if (onEar && largest * random.uniform() > n.cwiseQuotient(axes).norm())
    {
      continue;
    }
    const Vector3 x = onEar ? Vector3(middle + n.cwiseProduct(axes)) : Vector3(ball * n);
    if (onEar ? x.norm() > ball : (x - middle).cwiseQuotient(axes).norm() > 1.0)
    {
      points.row(i++) = x;
    }
  }
  const TrainingSamples samples{ conformal::PointView(points) };
  ConformalSOMOptions options = adaptive(5000);
  options.StartingShape = StartingShape::Hull;
  std::vector<std::pair<std::string, double>> scores; // of all starts
  options.Observer = [&](const conformal::LearningStage& stage)
  {
    if (scores.empty() || scores.back().first != stage.Start)
    {
      scores.emplace_back(stage.Start, 0.0);
    }
    scores.back().second = stage.DefectScore;
  };
  const ConformalSOMResult result = trainConformalSOM(samples, options);
  ASSERT_EQ(scores.size(), 3U); // The best start is reported once more.
  EXPECT_EQ(scores[0].first, "hull");
  EXPECT_LT(scores[0].second, 1.0);
  EXPECT_EQ(scores[1].first, "other hull");
  // A map is not more important than other defects.
  EXPECT_GT(scores[1].second, 2.0);
  EXPECT_EQ(scores[2].first, "hull");
  EXPECT_EQ(result.NumberOfStarts, 2);
}

// A limb that bends back to its body closes a handle of the hull, not of the object.
TEST(StartSearch, SeparatesHandlesOfTheObjectFromThoseOfTheHull)
{
  constexpr double Tube = 0.1;
  const auto ring = [&](double gap)
  {
    conformal::Random random(4);
    conformal::Points points(20000, 3);
    const double end = gap > 0.0 ? Tube + gap / 2.0 : 0.0; // where a cap begins, along the ring
    for (Index i = 0; i < points.rows();)
    {
      const double bend = 2.0 * Pi * random.uniform(), turn = 2.0 * Pi * random.uniform();
      const double beyond = std::max({ 0.0, end - bend, bend - (2.0 * Pi - end) });
      const double tube = std::sqrt(std::max(0.0, Tube * Tube - beyond * beyond));
      const double r = 1.0 + tube * std::cos(turn);
      if (beyond < Tube && (1.0 + Tube) * random.uniform() < r)
      {
        points.row(i++) << r * std::cos(bend), r * std::sin(bend), tube * std::sin(turn);
      }
    }
    return points;
  };
  const auto cutFraction = [&](const conformal::Points& cloud)
  {
    return firstSurfaceFromHull(TrainingSamples{ conformal::PointView(cloud) }, adaptive(12962),
      conformal::HullMethod::Distance)
      .Report.CutFraction;
  };
  EXPECT_EQ(cutFraction(ring(0.03)), 0.0);
  // Two discs as wide as the tube.
  EXPECT_NEAR(cutFraction(ring(0.0)), Tube / (2.0 * Pi), 0.03);
}

TEST(StartSearch, SpreadsPointsEvenly)
{
  const Mesh surface = box();
  EXPECT_EQ(
    conformal::withPointsBetween(surface, 11).Positions.rows(), 8); // 12 triangles, all as large
  const conformal::Points points = conformal::withPointsBetween(surface, 1201).Positions;
  ASSERT_EQ(points.rows(), 8 + 12 * 100);
  EXPECT_EQ(points.topRows(8), surface.Positions);
  EXPECT_NEAR(points.colwise().mean().norm(), 0.0, 1e-12);
  for (Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_NEAR(points.row(i).cwiseAbs().maxCoeff(), 1.0, 1e-12);
  }
}

TEST(StartSearch, AsksForTheMeshWhereItMustStartFromIt)
{
  const Mesh surface = jar(10);
  MappedMesh start{ surface, {} };
  const TrainingSamples samples{ conformal::PointView(surface.Positions) };
  ConformalSOMOptions options = adaptive();
  options.StartingShape = StartingShape::Mesh;
  EXPECT_THROW(trainConformalSOM(samples, options), std::invalid_argument);
  EXPECT_TRUE(trainConformalSOM(samples, options, &start).FromMesh);
  // Online learning has no use for a mesh without a map.
  options.MeshType = MeshType::Geodesic;
  options.TrainingMode = conformal::TrainingMode::Online;
  EXPECT_THROW(trainConformalSOM(samples, options, &start), std::invalid_argument);
  options.TrainingMode = conformal::TrainingMode::Batch;
  start.Triangles.conservativeResize(start.Triangles.rows() - 1, 3); // open
  EXPECT_THROW(trainConformalSOM(samples, options, &start), std::invalid_argument);
}

TEST(StartSearch, TwoTrianglesBackToBackAreNoStart)
{
  MappedMesh start;
  start.Positions.resize(3, 3);
  start.Positions << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  start.Triangles.resize(2, 3);
  start.Triangles << 0, 1, 2, 0, 2, 1;
  const TrainingSamples samples{ conformal::PointView(start.Positions) };
  ConformalSOMOptions options = adaptive();
  options.StartingShape = StartingShape::Mesh;
  EXPECT_THROW(trainConformalSOM(samples, options, &start), std::invalid_argument);
  MappedMesh mapped = start;
  mapped.SpherePositions.resize(3, 3);
  mapped.SpherePositions << 1.0, 0.0, 0.0, -0.6, 0.8, 0.0, -0.6, -0.8, 0.0;
  EXPECT_THROW(trainConformalSOM(samples, adaptive(), &mapped), std::invalid_argument);
}
