#include "Learn/Fit/SurfaceQuality.h"

#include "Base/Random.h"
#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using conformal::evaluateSurface;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Pi;
using conformal::Points;
using conformal::PointView;
using conformal::SurfaceQuality;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
// In the samples' own unit.
SurfaceQuality qualityOn(
  Mesh mesh, const TrainingSamples& samples, double noise = 0.0, const conformal::Run& run = {})
{
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    mesh.Positions.row(i) = samples.normalize(mesh.Positions.row(i));
  }
  return evaluateSurface(samples, mesh.Positions, mesh.Triangles, noise, run);
}

SurfaceQuality qualityOn(const Mesh& mesh, const Points& points)
{
  return qualityOn(mesh, TrainingSamples{ PointView(points) });
}

Mesh sphere()
{
  return makeGeodesicSphere(24);
}

void expectGood(const SurfaceQuality& quality)
{
  EXPECT_EQ(quality.UncoveredFraction, 0.0);
  EXPECT_LT(quality.InvertedFraction, 1e-3);
  EXPECT_EQ(quality.FoldedFraction, 0.0);
  EXPECT_LT(defectScore(quality), 0.5);
}

constexpr double Opening = 0.9; // of Pi, of what is there of the sphere in a bag

// A sphere with a hole, and a surface that goes along both of its sides.
Mesh bag()
{
  Mesh mesh = makeGeodesicSphere(48);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    const Vector3 n = mesh.Positions.row(i);
    const double angle = std::acos(n[2]);
    const bool outer = angle < 0.5 * Pi;
    const double folded = 2.0 * Opening * (outer ? angle : Pi - angle), r = outer ? 1.0003 : 0.9997;
    const double around = std::atan2(n[1], n[0]);
    mesh.Positions.row(i) = r *
      Vector3(
        std::sin(folded) * std::cos(around), std::sin(folded) * std::sin(around), std::cos(folded));
  }
  return mesh;
}

Points pointsOfBag()
{
  Points all = spheres::spiral(20000);
  for (Index i = 0; i < all.rows(); ++i)
  {
    all.row(i) *= 1.0 + 0.001 * std::sin(78.233 * static_cast<double>(i)); // nearer to either side
  }
  return all.topRows(static_cast<Index>(0.5 * (1.0 - std::cos(Opening * Pi)) * 20000));
}
}

TEST(SurfaceQuality, IsGoodForASphereAndThinPlates)
{
  const Points points = spheres::spiral(20000);
  expectGood(qualityOn(sphere(), points));
  Points plate = points;
  Mesh surface = makeGeodesicSphere(40);
  for (Points* positions : { &plate, &surface.Positions })
  {
    positions->col(2) *= 0.05;
  }
  expectGood(qualityOn(surface, plate));
}

TEST(SurfaceQuality, SeesTwoSidesOnTheSamePoints)
{
  const SurfaceQuality quality = qualityOn(bag(), pointsOfBag());
  EXPECT_GT(quality.InvertedFraction, 0.05);
  EXPECT_EQ(quality.UncoveredFraction, 0.0);
  EXPECT_GT(defectScore(quality), 1.0);
  expectGood(qualityOn(sphere(), pointsOfBag())); // a hole is no fault of the surface
}

// Inward or outward, if only they agree; where they do not, they are no measure.
TEST(SurfaceQuality, SingleWrongNormalsDoNotInvertARightSurface)
{
  const Points points = makeGeodesicSphere(17).Positions;
  TrainingSamples samples{ PointView(points) };
  Points normals = points;
  for (Index i = 3; i < normals.rows(); i += 7)
  {
    normals.row(i) *= -1.0;
  }
  samples.setNormals(normals);
  EXPECT_LT(qualityOn(sphere(), samples).InvertedFraction, 1e-3);
}

TEST(SurfaceQuality, HoldsTheSurfaceAgainstNormals)
{
  const Points points = spheres::spiral(20000);
  TrainingSamples samples{ PointView(points) };
  Mesh insideOut = sphere();
  insideOut.Triangles.col(0).swap(insideOut.Triangles.col(1));
  Points normals = points;
  for (const double sign : { 1.0, -1.0 })
  {
    normals = sign * points;
    samples.setNormals(normals);
    expectGood(qualityOn(sphere(), samples));
    EXPECT_EQ(qualityOn(insideOut, samples).InvertedFraction, 1.0);
  }
  for (Index i = 0; i < normals.rows(); i += 2)
  {
    normals.row(i) *= -1.0;
  }
  samples.setNormals(normals);
  expectGood(qualityOn(sphere(), samples));
}

// A twentieth of the points, as dense as the others, lie on a small sphere beside the surface.
TEST(SurfaceQuality, CountsPointsThatTheSurfaceDoesNotReach)
{
  Points points = spheres::spiral(20000);
  points.bottomRows(1000) = std::sqrt(1.0 / 20.0) * spheres::spiral(1000);
  points.bottomRows(1000).col(0).array() += 1.4;
  EXPECT_NEAR(qualityOn(sphere(), points).UncoveredFraction, 0.05, 0.005);
}

// Farther from each other than points of the surface: outliers.
TEST(SurfaceQuality, DoesNotCountOutliers)
{
  Points points = spheres::spiral(20000);
  points.bottomRows(200) = 1.5 * spheres::spiral(200);
  EXPECT_EQ(qualityOn(sphere(), points).UncoveredFraction, 0.0);
}

TEST(SurfaceQuality, AllowsForNoise)
{
  Points points = spheres::spiral(20000);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) *= 1.0 + 0.15 * std::sin(12.9898 * static_cast<double>(i));
  }
  const TrainingSamples samples{ PointView(points) };
  EXPECT_GT(qualityOn(sphere(), samples).UncoveredFraction, 0.1);
  EXPECT_EQ(qualityOn(sphere(), samples, 0.1).UncoveredFraction, 0.0);
}

TEST(SurfaceQuality, CountsFolds)
{
  Mesh mesh = sphere();
  // A vertex across its neighbors: its triangles lie on those around them, folded at their edges.
  const Index moved = 100;
  Vector3 across = Vector3::Zero();
  for (Index r = 0; r < mesh.Triangles.rows() && across.isZero(); ++r)
  {
    if (mesh.Triangles(r, 0) == moved)
    {
      across = mesh.Positions.row(mesh.Triangles(r, 1)) - mesh.Positions.row(moved);
    }
  }
  ASSERT_FALSE(across.isZero());
  mesh.Positions.row(moved) += 1.7 * across.transpose();
  const double folded = qualityOn(mesh, spheres::spiral(20000)).FoldedFraction;
  EXPECT_GT(folded, 0.0);
  EXPECT_LT(folded, 7.0 / static_cast<double>(3 * mesh.Positions.rows() - 6));
}

TEST(SurfaceQuality, TellsNothingOfTooFewPoints)
{
  for (const Index size : { 1, 3, 19 })
  {
    const Points points = spheres::spiral(size);
    EXPECT_EQ(qualityOn(sphere(), points).UncoveredFraction, 0.0) << size;
  }
}

TEST(SurfaceQuality, SameOnAnyThreadsAndRanks)
{
  const Points points = pointsOfBag();
  const SurfaceQuality whole = qualityOn(bag(), points);
  const auto expectSame = [&](const SurfaceQuality& quality)
  {
    EXPECT_EQ(quality.UncoveredFraction, whole.UncoveredFraction);
    EXPECT_EQ(quality.InvertedFraction, whole.InvertedFraction);
    EXPECT_EQ(quality.FoldedFraction, whole.FoldedFraction);
  };
  expectSame(qualityOn(bag(), TrainingSamples{ PointView(points) }, 0.0, runs::backwards()));
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = points.rows() * reduce.Rank / 3,
                  last = points.rows() * (reduce.Rank + 1) / 3;
      const Points own = points.middleRows(first, last - first);
      expectSame(qualityOn(bag(), TrainingSamples(own, {}, {}, reduce)));
    });
}

// A tenth as dense in spacing, a third of the sphere: what is missing is a third, not the hundredth
// of the points.
TEST(SurfaceQuality, CountsPointsForWhatTheyStandFor)
{
  const Points points = spheres::random(20000, true);
  Mesh flat = makeGeodesicSphere(48);
  for (Index i = 0; i < flat.Positions.rows(); ++i)
  {
    flat.Positions(i, 0) = std::max(flat.Positions(i, 0), -0.3);
  }
  EXPECT_NEAR(qualityOn(flat, points).UncoveredFraction, 0.35, 0.1);
  EXPECT_LT(qualityOn(makeGeodesicSphere(48), points).UncoveredFraction, 0.02);
}

TEST(SurfaceQuality, SaysWherePointsAreTooFewForTheShape)
{
  EXPECT_EQ(qualityOn(sphere(), spheres::random(10000)).UndersampledFraction, 0.0);
  EXPECT_GT(qualityOn(sphere(), spheres::random(100)).UndersampledFraction, 0.2);
}

TEST(SurfaceQuality, DoesNotTakeNoiseForTooFewPoints)
{
  Points noisy = spheres::random(20000);
  conformal::Random random(7);
  for (Index i = 0; i < noisy.rows(); ++i)
  {
    noisy.row(i) *= 1.0 + 0.009 * clouds::gaussian(random);
  }
  const TrainingSamples samples{ PointView(noisy) };
  EXPECT_GT(qualityOn(sphere(), samples, 0.0).UndersampledFraction, 0.015);
  EXPECT_LT(qualityOn(sphere(), samples, 0.009).UndersampledFraction, 0.002);
}

TEST(SurfaceQuality, FindsTheDistanceOfTwoLayersAndNoneInNoise)
{
  Points layers = spheres::random(20000), noisy = layers;
  conformal::Random random(7);
  for (Index i = 0; i < layers.rows(); ++i)
  {
    layers.row(i) *=
      1.0 + (random.uniform() < 0.5 ? 0.006 : -0.006) + clouds::gaussian(random) * 0.001;
    noisy.row(i) *= 1.0 + 0.006 * clouds::gaussian(random);
  }
  EXPECT_NEAR(qualityOn(makeGeodesicSphere(48), layers).LayerDistance, 0.012, 0.001);
  EXPECT_EQ(qualityOn(makeGeodesicSphere(48), noisy).LayerDistance, 0.0);
  EXPECT_EQ(qualityOn(makeGeodesicSphere(48), spheres::random(20000)).LayerDistance, 0.0);
}

// Flat triangles lie below a sphere by a hundredth of its radius: at their corners and within, the
// offsets of points have two values.
TEST(SurfaceQuality, DoesNotTakeTheTrianglesOfACoarseMeshForLayers)
{
  for (const int frequency : { 2, 3, 4, 6 })
  {
    const Mesh coarse = makeGeodesicSphere(frequency);
    for (const Index size : { 800, 3000 })
    {
      for (const double scale : { 1.0, 1.01 })
      {
        SCOPED_TRACE(
          std::to_string(frequency) + " " + std::to_string(size) + " " + std::to_string(scale));
        Mesh mesh = coarse;
        mesh.Positions *= scale;
        EXPECT_EQ(qualityOn(mesh, spheres::spiral(size)).LayerDistance, 0.0);
        EXPECT_EQ(qualityOn(mesh, spheres::random(size)).LayerDistance, 0.0);
      }
    }
  }
}

TEST(SurfaceQuality, FindsLayersOfFewPointsAroundACoarseMesh)
{
  for (const Index size : { 800, 3000, 10000 })
  {
    conformal::Random random(7);
    Points layers = spheres::random(size);
    for (Index i = 0; i < size; ++i)
    {
      layers.row(i) *= random.uniform() < 0.5 ? 0.98 : 1.02;
    }
    EXPECT_NEAR(qualityOn(makeGeodesicSphere(8), layers).LayerDistance, 0.04, 0.004) << size;
  }
}

// Of 2,000 samples, 30 are near the surface, though farther than noise explains, and 20 are not.
TEST(SurfaceQuality, CountsSamplesThatTheSurfaceDoesNotReach)
{
  Points points = spheres::random(2000);
  points.topRows(30) *= 1.008;
  points.middleRows(30, 20) *= 0.95;
  points.bottomRows(1) *= 1.2 / points.bottomRows(1).norm(); // determines the unit
  const conformal::TrainingSamples samples(points);
  const Mesh mesh = makeGeodesicSphere(48);
  const Points positions = samples.normalizeAll(mesh.Positions);
  EXPECT_EQ(conformal::countBeyondReach(samples, positions, mesh.Triangles, 0.0), 21);
  EXPECT_EQ(conformal::countBeyondReach(samples, positions, mesh.Triangles, 0.02), 1);
  EXPECT_EQ(conformal::countBeyondReach(samples, positions, mesh.Triangles, 0.1), 0);
}
