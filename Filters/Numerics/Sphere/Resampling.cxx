#include "Sphere/Resampling.h"

#include "Base/Steps.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereLocator.h"

#include <stdexcept>
#include <string>

namespace conformal
{
Points resample(const Points& spherePositions, const Points& values, const Triangles& triangles,
  const Points& directions, const Run& run)
{
  Steps steps(run, { 0.1, 0.7, 0.2 }); // cover, locator, values
  steps.next();
  Points sphere = spherePositions;
  SphereCoverage coverage = measureSphereCoverage(sphere, triangles, run);
  if (coverage.Degree == -1)
  {
    sphere.col(0) *= -1.0;
    coverage = measureSphereCoverage(sphere, triangles, run);
  }
  if (coverage.Degree != 1 || coverage.NumberOfFolds > 0)
  {
    throw std::invalid_argument("the map to the sphere covers it " +
      std::to_string(coverage.Degree) + " times with " + std::to_string(coverage.NumberOfFolds) +
      " folded triangles, but must cover it once without folds");
  }
  const SphereLocator locator(sphere, triangles, steps.next());
  Points resampled(directions.rows(), 3);
  forBlocksReporting(steps.next(), directions.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const SphereLocation location = locator.locate(directions.row(i));
        if (location.Triangle < 0)
        {
          throw std::invalid_argument("the map to the sphere has a hole");
        }
        const auto ids = triangles.row(location.Triangle);
        resampled.row(i) = location.Barycentric[0] * values.row(ids[0]) +
          location.Barycentric[1] * values.row(ids[1]) +
          location.Barycentric[2] * values.row(ids[2]);
      }
    });
  return resampled;
}
}
