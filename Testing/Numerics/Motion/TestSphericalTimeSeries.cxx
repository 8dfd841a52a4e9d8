#include "Motion/SphericalTimeSeries.h"

#include "Heads.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using conformal::Index;
using conformal::KnownRegistrations;
using conformal::Points;
using conformal::registerTimeSeries;
using conformal::SphericalRegistrationResult;
using conformal::SphericalTimeSeriesOptions;
using conformal::TimeStep;
using conformal::Vector3;

namespace
{
// Return a body of revolution that grows and bends over time. Its shape does not tell how the body
// is turned about its axis. The map of each time step is turned and warped.
TimeStep bodyAt(int step, int frequency = 16)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  TimeStep result;
  result.Name = "step " + std::to_string(step);
  result.Time = step;
  conformal::MappedMesh& mesh = result.Surface.Surface;
  mesh.Triangles = sphere.Triangles;
  mesh.SpherePositions = sphere.Positions;
  const double bend = 0.12 * step, growth = 1.0 + 0.04 * step;
  mesh.Positions = shapes::over(sphere.Positions,
    [&](const Vector3& n) -> Vector3
    {
      const double width = 0.6 - 0.2 * n.z();
      return growth * Vector3(width * n.x() + bend * n.z() * n.z(), width * n.y(), 1.5 * n.z());
    });
  result.Surface = heads::withWarpedMap(result.Surface, 0.9 * step);
  return result;
}

std::vector<TimeStep> bodies(int count)
{
  std::vector<TimeStep> steps;
  for (int t = 0; t < count; ++t)
  {
    steps.push_back(bodyAt(t));
  }
  return steps;
}

SphericalTimeSeriesOptions quick()
{
  SphericalTimeSeriesOptions options;
  options.Registration.Frequency = 8;
  return options;
}

// Return the mean distance on the unit sphere between the positions of equal points of the body.
double meanSlip(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().mean();
}
}

TEST(SphericalTimeSeries, KeepsPointsOfABodyOfRevolutionInPlace)
{
  const std::vector<TimeStep> steps = bodies(4);
  KnownRegistrations known;
  SphericalTimeSeriesOptions options = quick();
  const auto results = registerTimeSeries(steps, known, options);
  EXPECT_EQ(results[0].SpherePositions, steps[0].Surface.Surface.SpherePositions);
  for (const SphericalRegistrationResult& result : results)
  {
    EXPECT_EQ(result.NumberOfFolds, 0);
    EXPECT_LT(meanSlip(result.SpherePositions, results[0].SpherePositions), 0.05);
  }
  // Without positions, the turn about the axis is arbitrary.
  KnownRegistrations other;
  options.Registration.PositionWeight = 0.0;
  const auto without = registerTimeSeries(steps, other, options);
  EXPECT_GT(meanSlip(without[3].SpherePositions, results[0].SpherePositions), 0.1);
}

TEST(SphericalTimeSeries, ReducesDriftBySweeps)
{
  std::vector<TimeStep> steps = bodies(6);
  Points shape = steps[0].Surface.Surface.Positions;
  const Points rest = conformal::makeGeodesicSphere(16).Positions;
  for (Index v = 0; v < rest.rows(); ++v) // a ridge makes the turn about the axis visible
  {
    shape.row(v) *= 1.0 + 0.15 * std::exp(4.0 * (rest(v, 1) - 1.0));
  }
  for (TimeStep& step : steps) // the shape is constant, the maps differ
  {
    step.Surface.Surface.Positions = shape;
  }
  SphericalTimeSeriesOptions options = quick();
  double slips[2];
  for (int sweeps = 0; sweeps < 2; ++sweeps)
  {
    KnownRegistrations known;
    options.NumberOfSweeps = sweeps;
    const auto results = registerTimeSeries(steps, known, options);
    slips[sweeps] = meanSlip(results[5].SpherePositions, results[0].SpherePositions);
    EXPECT_EQ(results[5].NumberOfFolds, 0);
  }
  EXPECT_LT(slips[1], 0.6 * slips[0]) << slips[0];
}

TEST(SphericalTimeSeries, KeepsLandmarksThatTheReferenceDoesNotHave)
{
  std::vector<TimeStep> steps = bodies(3);
  for (const int t : { 1, 2 })
  {
    steps[t].Landmarks = { { 4, 100 }, { 7, 500 } };
  }
  KnownRegistrations known;
  const auto results = registerTimeSeries(steps, known, quick());
  for (const int vertex : { 100, 500 })
  {
    EXPECT_LT(
      (results[2].SpherePositions.row(vertex) - results[1].SpherePositions.row(vertex)).norm(),
      1e-6);
  }
}

TEST(SphericalTimeSeries, ContinuesAfterAnAbortAndWithMoreSteps)
{
  std::vector<TimeStep> steps = bodies(3);
  KnownRegistrations known, fresh;
  SphericalTimeSeriesOptions options = quick();
  options.NumberOfSweeps = 0;
  EXPECT_THROW(
    registerTimeSeries(steps, known, options, runs::stoppingAt(0.7)), conformal::Aborted);
  EXPECT_EQ(known.size(), 1U);
  const auto continued = registerTimeSeries(steps, known, options),
             whole = registerTimeSeries(steps, fresh, options, runs::backwards());
  EXPECT_EQ(known.size(), 2U);
  for (std::size_t t = 0; t < steps.size(); ++t)
  {
    EXPECT_EQ(continued[t].SpherePositions, whole[t].SpherePositions);
  }
  steps.push_back(bodyAt(3));
  EXPECT_EQ(registerTimeSeries(steps, known, options)[1].SpherePositions, whole[1].SpherePositions);
  EXPECT_EQ(known.size(), 3U);
}

TEST(SphericalTimeSeries, MeetsLandmarksOfSomeSteps)
{
  std::vector<TimeStep> steps = bodies(3);
  for (const int t : { 0, 1 })
  {
    steps[t].Landmarks = { { 4, 100 }, { 7, 500 }, { 9, 900 } };
  }
  steps[1].Landmarks[11] = 30; // a landmark that only this step has
  KnownRegistrations known;
  SphericalTimeSeriesOptions options = quick();
  options.NumberOfSweeps = 0;
  const auto results = registerTimeSeries(steps, known, options);
  EXPECT_LT(results[1].LandmarkError, 1e-6);
  for (const int vertex : { 100, 500, 900 })
  {
    EXPECT_LT(
      (results[1].SpherePositions.row(vertex) - results[0].SpherePositions.row(vertex)).norm(),
      1e-6);
  }
}

TEST(SphericalTimeSeries, TakesAnyReferenceAndRejectsBadTimes)
{
  std::vector<TimeStep> steps = bodies(3);
  KnownRegistrations known;
  SphericalTimeSeriesOptions options = quick();
  options.NumberOfSweeps = 0;
  options.Reference = 2;
  const auto results = registerTimeSeries(steps, known, options);
  EXPECT_EQ(results[2].SpherePositions, steps[2].Surface.Surface.SpherePositions);
  EXPECT_LT(meanSlip(results[0].SpherePositions, results[2].SpherePositions), 0.05);
  options.Reference = 3;
  EXPECT_THROW(registerTimeSeries(steps, known, options), std::invalid_argument);
  options.Reference = 0;
  steps[2].Time = steps[1].Time;
  EXPECT_THROW(registerTimeSeries(steps, known, options), std::invalid_argument);
}
