#include "HullStart.h"

#include "MeshDecimation.h"
#include "ProgressiveSphereMap.h"
#include "Resampling.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr Index HullVertices = 12000; // more do not show in the learned surface

// Finer than the hull's default: pockets such as the hollow of an ear fold less often when the
// surface is drawn into them. Measured: 0.016 is faster by a third, 0.010 no better.
constexpr double FinestSpacing = 0.012;

// Of an object whose largest radius is 1. Few points lie far apart, and a lattice finer than that
// would see gaps between them.
constexpr double TypicalArea = 5.0;

// More of the sphere for limbs, or better angles: measured, a middle.
constexpr double Balance = 0.18;
}

HullStart startFromHull(const TrainingSamples& samples, const Points& directions,
  const ParallelFor& parallelFor, const Progress& progress)
{
  GenusZeroHullOptions hullOptions;
  hullOptions.Spacing = std::clamp(
    0.6 * std::sqrt(TypicalArea / static_cast<double>(samples.totalSize())), FinestSpacing, 0.2);
  const GenusZeroHullResult hull =
    makeGenusZeroHull(samples, hullOptions, parallelFor, partOf(progress, 0.0, 0.2));
  const DecimatedMesh thinned =
    decimate(hull.Points, hull.Triangles, HullVertices, partOf(progress, 0.2, 0.4));
  ProgressiveSphereMapOptions mapOptions;
  mapOptions.AreaBalance = Balance;
  const ProgressiveSphereMapResult map =
    mapToSphere(thinned.Points, thinned.Triangles, mapOptions, partOf(progress, 0.4, 1.0));

  HullStart start;
  start.Weights =
    resample(map.Positions, thinned.Points, thinned.Triangles, directions, parallelFor);
  start.Data = hull.Data;
  start.Leaks = hull.Leaks;
  start.NumberOfCutNodes = hull.NumberOfCutNodes;
  start.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
  return start;
}
}
