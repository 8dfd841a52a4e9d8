#include "Learn/Fit/LeastSquaresFit.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

using conformal::Index;
using conformal::LearnedMesh;
using conformal::leastSquaresFit;
using conformal::LeastSquaresFitOptions;
using conformal::Points;
using conformal::PointView;
using conformal::Random;
using conformal::TrainingSamples;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
// Points spread evenly over the triangles of a mesh.
Points samplesOf(const Points& positions, const Triangles& triangles, Index perTriangle)
{
  Random random(5);
  Points points(perTriangle * triangles.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const auto ids = triangles.row(i % triangles.rows());
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    points.row(i) =
      (1.0 - u - v) * positions.row(ids[0]) + u * positions.row(ids[1]) + v * positions.row(ids[2]);
  }
  return points;
}

// An ellipsoid's mesh, displaced in its patterns' unit.
struct Displaced
{
  explicit Displaced(double displacement)
    : Truth(conformal::makeGeodesicSphere(3))
  {
    this->Truth.Positions *= Vector3(1.0, 0.8, 0.9).asDiagonal();
    this->Cloud = samplesOf(this->Truth.Positions, this->Truth.Triangles, 60);
    this->Start.SpherePositions = conformal::makeGeodesicSphere(3).Positions;
    this->Start.Triangles = this->Truth.Triangles;
    this->Start.Positions = this->Truth.Positions;
    const TrainingSamples samples{ PointView(this->Cloud) };
    Random random(7);
    for (Index v = 0; v < this->Start.Positions.rows(); ++v)
    {
      const Vector3 shift(random.uniform(), random.uniform(), random.uniform());
      this->Start.Positions.row(v) = samples.normalize(this->Truth.Positions.row(v)) +
        displacement * (shift - Vector3::Constant(0.5));
    }
  }

  conformal::Mesh Truth;
  Points Cloud;
  LearnedMesh Start;
};

double farthest(const TrainingSamples& samples, const LearnedMesh& result, Index first)
{
  const conformal::TriangleTree surface(result.Positions, result.Triangles);
  double square = 0.0;
  for (Index i = 0; i < first; ++i)
  {
    square = std::max(square, surface.closestPoint(samples[i]).SquareDistance);
  }
  return std::sqrt(square);
}

LeastSquaresFitOptions loose()
{
  LeastSquaresFitOptions options;
  options.Iterations = 30;
  options.FirstSmoothness = 1e-3;
  options.LastSmoothness = 1e-8;
  options.AutomaticPriority = false;
  return options;
}
}

// The patterns lie on a mesh of this very connectivity: it is found.
TEST(LeastSquaresFit, FindsTheMeshThatThePatternsLieOn)
{
  Displaced mesh(0.05);
  const TrainingSamples samples{ PointView(mesh.Cloud) };
  const double before = farthest(samples, mesh.Start, samples.size());
  leastSquaresFit(samples, loose(), mesh.Start);
  const double after = farthest(samples, mesh.Start, samples.size());
  EXPECT_GT(before, 0.01);
  EXPECT_LT(after, 0.05 * before);
  ASSERT_EQ(mesh.Start.History.size(), 30U);
  EXPECT_LT(
    mesh.Start.History.back().MeanSquareError, 1e-3 * mesh.Start.History.front().MeanSquareError);
}

TEST(LeastSquaresFit, WithoutRoundsDoesNothing)
{
  Displaced mesh(0.05);
  const Points start = mesh.Start.Positions;
  LeastSquaresFitOptions options;
  options.Iterations = 0;
  const std::vector<double> masses =
    leastSquaresFit(TrainingSamples{ PointView(mesh.Cloud) }, options, mesh.Start);
  EXPECT_EQ(mesh.Start.Positions, start);
  EXPECT_TRUE(mesh.Start.History.empty());
  EXPECT_EQ(masses, std::vector<double>(mesh.Start.Triangles.rows(), 0.0));
}

// Every pattern has its foot in one triangle.
TEST(LeastSquaresFit, CountsThePatternsOfEachTriangle)
{
  Displaced mesh(0.02);
  LeastSquaresFitOptions options = loose();
  options.OutlierRatio = 1e6;
  const std::vector<double> masses =
    leastSquaresFit(TrainingSamples{ PointView(mesh.Cloud) }, options, mesh.Start);
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0),
    static_cast<double>(mesh.Cloud.rows()), 1e-6);
  for (const double mass : masses)
  {
    EXPECT_NEAR(mass, 60.0, 12.0);
  }
}

TEST(LeastSquaresFit, LeavesOutliersOut)
{
  Displaced mesh(0.02);
  const Index size = mesh.Cloud.rows();
  Points cloud(size + 20, 3);
  cloud.topRows(size) = mesh.Cloud;
  for (Index i = size; i < cloud.rows(); ++i)
  {
    cloud.row(i) = 0.5 * mesh.Cloud.row(31 * (i - size)); // well inside
  }
  const TrainingSamples samples{ PointView(cloud) };
  LearnedMesh kept = mesh.Start;
  LeastSquaresFitOptions options = loose();
  options.OutlierRatio = 6.0;
  leastSquaresFit(samples, options, kept);
  const double without = farthest(samples, kept, size);
  EXPECT_LT(without, 0.005);
  options.OutlierRatio = 1e6;
  leastSquaresFit(samples, options, mesh.Start);
  EXPECT_GT(farthest(samples, mesh.Start, size), 3.0 * without);
}

// A pattern that does not belong has no say, wherever it is.
TEST(LeastSquaresFit, AsksWhatBelongs)
{
  Displaced mesh(0.02);
  const Index size = mesh.Cloud.rows();
  Points cloud(size + 400, 3);
  cloud.topRows(size) = mesh.Cloud;
  for (Index i = size; i < cloud.rows(); ++i)
  {
    cloud.row(i) =
      Vector3(1.05, 0.0, 0.0) + 1e-3 * Vector3(i % 20 - 10.0, i % 7 - 3.0, i % 9 - 4.0);
  }
  const TrainingSamples samples{ PointView(cloud) };
  LeastSquaresFitOptions options = loose();
  options.OutlierRatio = 1e6;
  options.Belongs = [&](const Vector3& x) { return samples.restore(x)[0] < 1.01; };
  leastSquaresFit(samples, options, mesh.Start);
  EXPECT_LT(farthest(samples, mesh.Start, size), 0.01);
}

TEST(LeastSquaresFit, DoesNotDependOnTheOrderOfBlocks)
{
  Displaced one(0.05), other(0.05);
  const TrainingSamples samples{ PointView(one.Cloud) };
  leastSquaresFit(samples, {}, one.Start);
  leastSquaresFit(samples, {}, other.Start, runs::backwards());
  EXPECT_EQ(one.Start.Positions, other.Start.Positions);
}

// Patterns on rings around an axis, far from each other on a coarse start: between them the surface
// is flat, or as round as the guide.
TEST(LeastSquaresFit, FollowsAGuideBetweenPatterns)
{
  constexpr int rings = 7, perRing = 300;
  const double pi = std::acos(-1.0);
  Points cloud(rings * perRing + 2, 3);
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int i = 0; i < perRing; ++i)
    {
      const double tilt = pi * (ring + 1) / (rings + 1), turn = 2.0 * pi * i / perRing;
      cloud.row(ring * perRing + i) << std::sin(tilt) * std::cos(turn),
        std::sin(tilt) * std::sin(turn), std::cos(tilt);
    }
  }
  cloud.bottomRows(2) << 0.0, 0.0, 1.0, 0.0, 0.0, -1.0;
  const TrainingSamples samples{ PointView(cloud) };
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(16);
  const auto leastRadius = [&](const LeastSquaresFitOptions& options)
  {
    LearnedMesh result;
    result.SpherePositions = result.Positions = sphere.Positions;
    result.Triangles = sphere.Triangles;
    leastSquaresFit(samples, options, result);
    return result.Positions.rowwise().norm().minCoeff();
  };
  LeastSquaresFitOptions options;
  const double without = leastRadius(options);
  options.Guide = std::make_shared<conformal::TriangleTree>(sphere.Positions, sphere.Triangles);
  const double with = leastRadius(options);
  EXPECT_LT(without, 0.99);
  EXPECT_GT(with, 0.99);
}
