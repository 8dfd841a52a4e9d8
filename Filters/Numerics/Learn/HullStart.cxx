#include "Learn/HullStart.h"

#include "Base/Steps.h"
#include "Learn/SurfaceStart.h"
#include "Sphere/Resampling.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
// Finer than the hull's default: pockets such as the hollow of an ear fold less often when the
// surface is drawn into them. Measured: 0.016 is faster by a third, 0.010 no better.
constexpr double FinestSpacing = 0.012;

// Of an object whose largest radius is 1. Few points lie far apart, and a grid finer than that
// would see gaps between them.
constexpr double TypicalArea = 5.0;

// More of the sphere for limbs, or better angles: measured, a middle.
constexpr double Balance = 0.18;

constexpr double WorkOfResampling = 15e6; // in nanoseconds as in Steps
}

double hullSpacing(const TrainingSamples& samples, HullIndicator indicator, double minimumSpacing)
{
  const double factor = indicator == HullIndicator::WindingNumbers ? 0.25 : 0.6;
  return std::clamp(factor * std::sqrt(TypicalArea / static_cast<double>(samples.totalSize())),
    std::clamp(minimumSpacing, FinestSpacing, GenusZeroHullLimits::MaximumSpacing),
    GenusZeroHullLimits::MaximumSpacing);
}

double workOfHull(const TrainingSamples& samples, double spacing, HullIndicator indicator)
{
  if (indicator == HullIndicator::WindingNumbers)
  {
    return workOfHullByWindingNumbers(samples, spacing);
  }
  return workOfGenusZeroHull(static_cast<double>(samples.totalSize()), spacing);
}

double verticesOfHull(double spacing)
{
  return 29.0 / (spacing * spacing);
}

GenusZeroHullResult makeHull(
  const TrainingSamples& samples, double minimumSpacing, HullIndicator indicator, const Run& run)
{
  const auto optionsFor = [&](HullIndicator by)
  {
    GenusZeroHullOptions options;
    options.Indicator = by;
    options.Spacing = hullSpacing(samples, by, minimumSpacing);
    return options;
  };
  return indicator == HullIndicator::Automatic
    ? chooseHull(samples, optionsFor(HullIndicator::Distance),
        optionsFor(HullIndicator::WindingNumbers), run)
    : makeGenusZeroHull(samples, optionsFor(indicator), run);
}

double workOfHullStart(const TrainingSamples& samples, HullIndicator indicator)
{
  const double spacing = hullSpacing(samples, indicator);
  return workOfHull(samples, spacing, indicator) + workOfThinAndMap(verticesOfHull(spacing));
}

std::optional<HullStart> startFromHull(
  const TrainingSamples& samples, const Points& directions, HullIndicator indicator, const Run& run)
{
  const double spacing = hullSpacing(samples, indicator);
  const double ofHull = workOfHull(samples, spacing, indicator);
  Steps steps(run, { ofHull, workOfHullStart(samples, indicator) - ofHull });
  const GenusZeroHullResult hull = makeHull(samples, 0.0, indicator, steps.next());
  const auto size = static_cast<double>(hull.Positions.rows());
  steps.replan({ workOfThinAndMap(size), WorkOfResampling });
  const std::optional<MappedMesh> mapped = thinAndMap(hull, Balance, steps.next());
  if (!mapped)
  {
    return {};
  }
  steps.next();
  HullStart start;
  start.Positions = resample(
    mapped->SpherePositions, mapped->Positions, mapped->Triangles, directions, run.unwatched());
  start.Data = hull.Data;
  if (hull.Indicator == HullIndicator::WindingNumbers)
  {
    start.Guide = std::make_shared<TriangleTree>(hull.Positions, hull.Triangles, run.unwatched());
  }
  start.Indicator = hull.Indicator;
  start.NormalsUsed = hull.NormalsUsed;
  start.Leaks = hull.Leaks;
  start.CutFraction = cutFraction(hull);
  start.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
  return start;
}
}
