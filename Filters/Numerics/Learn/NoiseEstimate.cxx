#include "Learn/NoiseEstimate.h"

#include "Base/FixedPointSums.h"
#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double Fall = 6.0; // of the error, where the vertices are four times as many
}

double noiseToDetail(double coarseError, double fineError)
{
  constexpr double MostNoise = 10.0;
  const double ratio = coarseError / fineError;
  return ratio > 1.0 ? std::clamp((Fall - 1.0) / (ratio - 1.0) - 1.0, 0.0, MostNoise) : MostNoise;
}

double noiseVariance(double coarseError, double fineError)
{
  constexpr double geometricMean = 0.2807; // of squares of normal deviates
  const double detail = std::max(0.0, coarseError - fineError) / (Fall - 1.0);
  return std::max(0.0, fineError - detail) / geometricMean;
}

double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const ParallelFor& parallelFor,
  const Progress& progress)
{
  constexpr double least = 1e-16, logUnit = 64.0; // no logarithm of a square distance is larger
  const TriangleTree surface(positions, triangles, parallelFor);
  SampleRotation rotation(samples, 1);
  rotation.turn(wanted);
  FixedPointSums logarithms(1);
  forEachFoot(
    samples, surface, rotation.count(), [&](Index i) { return rotation.id(i); },
    [&](Index, const Vector3&, const FootPoint& foot)
    { logarithms.add(0, std::log(std::max(foot.SquareDistance, least)) / logUnit); },
    parallelFor, progress);
  logarithms.reduce(samples.reduce());
  return std::exp(logUnit * logarithms[0] / static_cast<double>(rotation.totalCount()));
}
}
