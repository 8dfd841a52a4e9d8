#include "Learn/Fit/PatternFit.h"

#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Search/TriangleTree.h"
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

// Vertices move toward the step, along the surface; without a step, they hardly move.
TEST(PatternFit, AlignmentMovesVerticesToSteps)
{
  const Points points = sheets::pointsAbove(-1.0, Size, 3);
  TrainingSamples samples(points);
  const Mesh before = meshOf(samples);
  const auto aligned = [&](Index row)
  {
    const Columns values = 0.2 * valuesOf(points).row(row);
    samples.setPatternValues(values);
    Mesh mesh = before;
    conformal::alignWithPatternValues(samples, mesh);
    return mesh;
  };
  // Mean error of the step at other points
  const Points others = sheets::pointsAbove(-1.0, Size, 5);
  const auto error = [&](const Mesh& mesh)
  {
    const Columns values = valuesOf(points).row(1), wanted = valuesOf(others).row(1);
    samples.setPatternValues(values);
    const Columns fitted = fitPatternValues(samples, mesh);
    const conformal::TriangleTree tree(mesh.Positions, mesh.Triangles);
    double sum = 0.0;
    for (Index i = 0; i < others.rows(); ++i)
    {
      const conformal::FootPoint foot = tree.closestPoint(samples.normalize(others.row(i)));
      double value = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        value += foot.Barycentric[k] * fitted(mesh.Triangles(foot.Triangle, k), 0);
      }
      sum += std::abs(value - wanted(0, i));
    }
    return sum;
  };
  const Mesh smooth = aligned(0), stepped = aligned(1);
  EXPECT_LT((smooth.Positions - before.Positions).rowwise().norm().maxCoeff(), 0.03);
  EXPECT_GT((stepped.Positions - before.Positions).rowwise().norm().maxCoeff(), 0.04);
  EXPECT_LT(error(stepped), 0.6 * error(before));
  EXPECT_LT(
    (samples.restoreAll(stepped.Positions).rowwise().norm().array() - 1.0).abs().maxCoeff(), 0.02);
  EXPECT_EQ(aligned(1).Positions, stepped.Positions);
  const Columns values = 0.2 * valuesOf(points).row(1);
  samples.setPatternValues(values);
  Mesh backwards = before;
  conformal::alignWithPatternValues(samples, backwards, runs::backwards());
  EXPECT_EQ(backwards.Positions, stepped.Positions);
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
  Mesh aligned = mesh;
  conformal::alignWithPatternValues(samples, aligned);
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const Index first = Size / 3 * reduce.Rank, last = Size / 3 * (reduce.Rank + 1);
      const Points own = points.middleRows(first, last - first);
      const Columns ownValues = values.middleCols(first, last - first);
      TrainingSamples part(own, {}, {}, reduce);
      part.setPatternValues(ownValues);
      EXPECT_EQ(fitPatternValues(part, mesh), expected);
      Mesh moved = mesh;
      conformal::alignWithPatternValues(part, moved);
      EXPECT_EQ(moved.Positions, aligned.Positions);
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
