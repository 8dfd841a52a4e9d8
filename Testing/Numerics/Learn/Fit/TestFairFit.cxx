#include "Learn/Fit/FairFit.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::fairFit;
using conformal::FairFitResult;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
/// Normal deviate, by the sum of twelve uniform ones.
double deviate(conformal::Random& random)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.uniform();
  }
  return sum;
}

/// A unit sphere with noise along the normal, 6 points for each vertex of a rough mesh. Noise is
/// multiplied by a factor where x > 0.
struct Noisy
{
  explicit Noisy(double noise, double factor = 1.0)
  {
    conformal::Random random(3);
    this->Rough = conformal::makeGeodesicSphere(16);
    this->Cloud.resize(6 * this->Rough.Positions.rows(), 3);
    for (Index i = 0; i < this->Cloud.rows(); ++i)
    {
      Vector3 direction(deviate(random), deviate(random), deviate(random));
      direction.normalize();
      const double own = direction[0] > 0.0 ? factor * noise : noise;
      this->Cloud.row(i) = (1.0 + own * deviate(random)) * direction;
    }
    const TrainingSamples samples{ PointView(this->Cloud) };
    for (Index i = 0; i < this->Rough.Positions.rows(); ++i)
    {
      this->Rough.Positions.row(i) = samples.normalize(
        (1.0 + 0.3 * noise * deviate(random)) * Vector3(this->Rough.Positions.row(i)));
    }
  }

  Points Cloud;
  Mesh Rough; // in the samples' unit
};

/// Positions in the frame of the cloud, the center of the sphere.
Points restored(Points positions, const TrainingSamples& samples)
{
  for (Index i = 0; i < positions.rows(); ++i)
  {
    positions.row(i) = samples.restore(positions.row(i));
  }
  return positions;
}

/// Root mean square of the distance of vertices from their mean radius, on one side or on both.
double roughness(const Points& positions, double side = 0.0)
{
  const auto counts = [&](Index i) { return side * positions(i, 0) >= 0.0; };
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (Index i = 0; i < positions.rows(); ++i)
  {
    const double radius = counts(i) ? positions.row(i).norm() : 0.0;
    sum += radius;
    squares += radius * radius;
    count += counts(i) ? 1.0 : 0.0;
  }
  return std::sqrt(std::max(0.0, squares / count - sum * sum / count / count));
}
}

TEST(FairFit, FindsASphereAmidNoise)
{
  const double noise = 0.005;
  const Noisy sphere(noise);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  Mesh mesh = sphere.Rough;
  const FairFitResult result = fairFit(samples, {}, mesh);
  const double unit = noise / samples.scale();
  EXPECT_NEAR(std::sqrt(result.Variance), unit, 0.05 * unit);
  EXPECT_LT(result.DegreesOfFreedom, 0.05 * static_cast<double>(mesh.Positions.rows()));
  EXPECT_LT(roughness(restored(mesh.Positions, samples)), 0.15 * noise);
  ASSERT_EQ(static_cast<Index>(result.StandardError.size()), mesh.Positions.rows());
  double square = 0.0;
  for (const double error : result.StandardError)
  {
    square += error * error / static_cast<double>(mesh.Positions.rows());
  }
  EXPECT_LT(std::sqrt(square), 0.2 * unit);
  EXPECT_GT(
    std::sqrt(square), 0.2 / samples.scale() * roughness(restored(mesh.Positions, samples)));
  // The flat triangles lie in the middle of the sphere.
  double volume = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0)),
                  b = mesh.Positions.row(mesh.Triangles(r, 1)),
                  c = mesh.Positions.row(mesh.Triangles(r, 2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  const double scale = samples.scale();
  EXPECT_NEAR(volume * scale * scale * scale, 4.0 / 3.0 * conformal::Pi, 0.002);
}

TEST(FairFit, SmoothsMoreWhereThereIsMoreNoise)
{
  const Noisy sphere(0.001, 8.0);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  Mesh mesh = sphere.Rough;
  const FairFitResult result = fairFit(samples, {}, mesh);
  double quiet = 0.0, loud = 0.0;
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    (mesh.Positions(i, 0) > 0.0 ? loud : quiet) += result.StandardError[i];
  }
  EXPECT_GT(loud, 1.1 * quiet);
  EXPECT_LT(roughness(restored(mesh.Positions, samples), -1.0), 0.0004);
  EXPECT_LT(roughness(restored(mesh.Positions, samples), 1.0), 0.002);
}

TEST(FairFit, SmoothnessIsAFactor)
{
  const Noisy sphere(0.01);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  double before = 1e300;
  for (const double smoothness : { 1e-4, 1.0, 100.0 })
  {
    conformal::FairFitOptions options;
    options.Smoothness = smoothness;
    Mesh mesh = sphere.Rough;
    const double freedom = fairFit(samples, options, mesh).DegreesOfFreedom;
    EXPECT_LT(freedom, before);
    before = freedom;
  }
}

TEST(FairFit, SameBitsOnTwoThreads)
{
  const Noisy sphere(0.003);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  Mesh one = sphere.Rough, two = sphere.Rough;
  const FairFitResult first = fairFit(samples, {}, one);
  const FairFitResult second = fairFit(samples, {}, two, runs::backwards());
  EXPECT_EQ(one.Positions, two.Positions);
  EXPECT_EQ(first.StandardError, second.StandardError);
}

TEST(FairFit, LeavesTheMeshWhereThereAreNoSamples)
{
  const Noisy sphere(0.003);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  conformal::FairFitOptions options;
  options.Belongs = [](const Vector3&) { return false; };
  Mesh mesh = sphere.Rough;
  EXPECT_THROW(fairFit(samples, options, mesh), conformal::NumericalFailure);
  EXPECT_EQ(mesh.Positions, sphere.Rough.Positions);
}

TEST(FairFit, ReportsProgressAndStops)
{
  const Noisy sphere(0.003);
  const TrainingSamples samples{ PointView(sphere.Cloud) };
  Mesh mesh = sphere.Rough;
  EXPECT_THROW(fairFit(samples, {}, mesh, runs::stoppingAt(0.5)), conformal::Aborted);
  EXPECT_EQ(mesh.Positions, sphere.Rough.Positions);
}
