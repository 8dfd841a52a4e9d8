#include "HullStart.h"

#include "GenusZeroHull.h"
#include "MeshDecimation.h"
#include "ProgressiveSphereMap.h"
#include "Resampling.h"

namespace conformal
{
HullStart startFromHull(const TrainingSamples& samples, const Points& directions,
  const ParallelFor& parallelFor, const Progress& progress)
{
  constexpr Index HullVertices = 12000; // more do not show in the learned surface
  const GenusZeroHullResult hull =
    makeGenusZeroHull(samples, {}, parallelFor, partOf(progress, 0.0, 0.2));
  const DecimatedMesh thinned =
    decimate(hull.Points, hull.Triangles, HullVertices, partOf(progress, 0.2, 0.4));
  ProgressiveSphereMapOptions options;
  options.AreaBalance = 0.4; // more of the sphere for limbs, or better angles: measured, a middle
  const ProgressiveSphereMapResult map =
    mapToSphere(thinned.Points, thinned.Triangles, options, partOf(progress, 0.4, 1.0));

  HullStart start;
  start.Weights =
    resample(map.Positions, thinned.Points, thinned.Triangles, directions, parallelFor);
  start.Leaks = hull.Leaks;
  start.NumberOfCutNodes = hull.NumberOfCutNodes;
  start.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
  return start;
}
}
