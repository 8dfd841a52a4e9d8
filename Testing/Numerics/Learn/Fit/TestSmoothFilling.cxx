#include "Learn/Fit/SmoothFilling.h"

#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::fillSmoothly;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::TrainingSamples;

namespace
{
constexpr double Lowest = -0.85; // samples are above this height
constexpr Index NumberOfSamples = 20000;

const Points& samplesWithHole()
{
  static const Points points = sheets::pointsAbove(Lowest, NumberOfSamples, 3);
  return points;
}

// A sphere that is flat where there are no samples, in the unit of the samples.
Mesh flattened(const TrainingSamples& samples)
{
  Mesh mesh = conformal::makeGeodesicSphere(20);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    mesh.Positions(i, 2) = std::max(mesh.Positions(i, 2), Lowest);
  }
  mesh.Positions = samples.normalizeAll(mesh.Positions);
  return mesh;
}

double farthestFromSphere(const TrainingSamples& samples, const Points& positions)
{
  return (samples.restoreAll(positions).rowwise().norm().array() - 1.0).abs().maxCoeff();
}
}

TEST(SmoothFilling, AHoleGetsTheCurvatureAroundIt)
{
  const TrainingSamples samples(samplesWithHole());
  Mesh mesh = flattened(samples);
  const double before = farthestFromSphere(samples, mesh.Positions);
  EXPECT_NEAR(before, 1.0 + Lowest, 0.01);
  EXPECT_GT(fillSmoothly(samples, 0.0, mesh.Positions, mesh.Triangles), 100);
  EXPECT_LT(farthestFromSphere(samples, mesh.Positions), 0.45 * before);
}

TEST(SmoothFilling, WithoutGapsNothingMoves)
{
  const Points all = sheets::pointsAbove(-1.0, NumberOfSamples, 3);
  const TrainingSamples samples(all);
  Mesh mesh = conformal::makeGeodesicSphere(20);
  mesh.Positions = samples.normalizeAll(mesh.Positions);
  const Points before = mesh.Positions;
  EXPECT_EQ(fillSmoothly(samples, 0.0, mesh.Positions, mesh.Triangles), 0);
  EXPECT_EQ(mesh.Positions, before);
}

TEST(SmoothFilling, GapsNarrowerThanTheNoiseStay)
{
  const TrainingSamples samples(samplesWithHole());
  Mesh mesh = flattened(samples);
  EXPECT_EQ(fillSmoothly(samples, 0.2, mesh.Positions, mesh.Triangles), 0);
}

TEST(SmoothFilling, ThreadsAndRanksChangeNoBit)
{
  const Points& points = samplesWithHole();
  const TrainingSamples samples(points);
  Mesh expected = flattened(samples), backwards = expected;
  const Mesh before = expected;
  fillSmoothly(samples, 0.0, expected.Positions, expected.Triangles);
  fillSmoothly(samples, 0.0, backwards.Positions, backwards.Triangles, runs::backwards());
  EXPECT_EQ(backwards.Positions, expected.Positions);
  ranks::run(2,
    [&](const conformal::Reduce& reduce)
    {
      const Index half = points.rows() / 2;
      const Points own = reduce.Rank == 0 ? Points(points.topRows(half))
                                          : Points(points.bottomRows(points.rows() - half));
      Points positions = before.Positions;
      fillSmoothly(TrainingSamples(own, {}, {}, reduce), 0.0, positions, before.Triangles);
      EXPECT_EQ(positions, expected.Positions);
    });
}
