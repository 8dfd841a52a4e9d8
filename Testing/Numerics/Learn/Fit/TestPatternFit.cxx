#include "Learn/Fit/PatternFit.h"

#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Columns;
using conformal::fitPatternValues;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
constexpr Index Size = 6000;

// Two values of each point: a smooth one, and a step across the plane x = 0.
Columns valuesOf(const Points& points)
{
  Columns values(2, points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    values(0, i) = 0.3 + 0.5 * points(i, 2);
    values(1, i) = points(i, 0) > 0.0 ? 1.0 : -1.0;
  }
  return values;
}

Mesh meshOf(const TrainingSamples& samples)
{
  Mesh mesh = conformal::makeGeodesicSphere(8);
  mesh.Positions = samples.normalizeAll(mesh.Positions);
  return mesh;
}
}

TEST(PatternFit, ReproducesSmoothValuesAndKeepsSteps)
{
  const Points points = sheets::pointsAbove(-1.0, Size, 3);
  const Columns values = valuesOf(points);
  TrainingSamples samples(points);
  samples.setPatternValues(values);
  const Columns fitted = fitPatternValues(samples, meshOf(samples));
  const Points vertices = conformal::makeGeodesicSphere(8).Positions;
  const double edge = 0.16;
  for (Index v = 0; v < vertices.rows(); ++v)
  {
    EXPECT_NEAR(fitted(v, 0), 0.3 + 0.5 * vertices(v, 2), 0.01);
    if (std::abs(vertices(v, 0)) > 2.0 * edge)
    {
      EXPECT_NEAR(fitted(v, 1), vertices(v, 0) > 0.0 ? 1.0 : -1.0, 0.05);
    }
    EXPECT_LE(std::abs(fitted(v, 1)), 1.0);
  }
}

TEST(PatternFit, VerticesWithoutSamplesGetValuesBetweenThoseAround)
{
  const Points points = sheets::pointsAbove(-0.6, Size, 3);
  Columns values(1, points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    values(0, i) = points(i, 0);
  }
  TrainingSamples samples(points);
  samples.setPatternValues(values);
  const Columns fitted = fitPatternValues(samples, meshOf(samples));
  const Points vertices = conformal::makeGeodesicSphere(8).Positions;
  for (Index v = 0; v < vertices.rows(); ++v)
  {
    if (vertices(v, 2) < -0.75)
    {
      EXPECT_LT(std::abs(fitted(v, 0)), 0.85); // the rim of the hole reaches 0.8
      EXPECT_GT(fitted(v, 0) * vertices(v, 0), -0.02);
    }
  }
}

// With noise of the values, cross-validation chooses a smoother fit.
TEST(PatternFit, NoiseIsSmoothed)
{
  const Points points = sheets::pointsAbove(-1.0, Size / 4, 3);
  Columns values = valuesOf(points).row(0);
  conformal::Random random(4);
  for (Index i = 0; i < values.cols(); ++i)
  {
    values(0, i) += random.uniform() + random.uniform() - 1.0;
  }
  TrainingSamples samples(points);
  samples.setPatternValues(values);
  const Columns fitted = fitPatternValues(samples, meshOf(samples));
  const Points vertices = conformal::makeGeodesicSphere(8).Positions;
  const double rms =
    std::sqrt((fitted.col(0).array() - 0.3 - 0.5 * vertices.col(2).array()).square().mean());
  EXPECT_LT(rms, 0.2); // the noise has 0.41
}

TEST(PatternFit, UnitsThreadsAndRanksChangeNoBit)
{
  const Points points = sheets::pointsAbove(-1.0, Size, 3);
  const Columns values = valuesOf(points), large = 512.0 * values;
  TrainingSamples samples(points);
  samples.setPatternValues(values);
  const Mesh mesh = meshOf(samples);
  const Columns expected = fitPatternValues(samples, mesh);
  EXPECT_EQ(fitPatternValues(samples, mesh, runs::backwards()), expected);
  TrainingSamples other(points);
  other.setPatternValues(large);
  EXPECT_EQ(fitPatternValues(other, mesh), Columns(512.0 * expected));
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = Size / 3 * reduce.Rank, last = Size / 3 * (reduce.Rank + 1);
      const Points own = points.middleRows(first, last - first);
      const Columns ownValues = values.middleCols(first, last - first);
      TrainingSamples part(own, {}, {}, reduce);
      part.setPatternValues(ownValues);
      EXPECT_EQ(fitPatternValues(part, mesh), expected);
    });
}

TEST(PatternFit, ReportsProgressAndCanBeAborted)
{
  const Points points = sheets::pointsAbove(-1.0, Size, 3);
  const Columns values = valuesOf(points);
  TrainingSamples samples(points);
  samples.setPatternValues(values);
  runs::Watch watch;
  fitPatternValues(samples, meshOf(samples), watch.run());
  EXPECT_GE(watch.calls(), 5);
  EXPECT_THROW(
    fitPatternValues(samples, meshOf(samples), runs::stoppingAt(0.6)), conformal::Aborted);
}
