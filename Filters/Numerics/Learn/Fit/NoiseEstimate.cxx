#include "Learn/Fit/NoiseEstimate.h"

#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double Fall = 6.0;     // of the error, where the vertices are four times as many
constexpr double LogUnit = 64.0; // no logarithm of a square distance is larger
}

double noiseToDetail(double coarseError, double fineError)
{
  constexpr double MaximumNoise = 10.0;
  const double ratio = coarseError / fineError;
  return ratio > 1.0 ? std::clamp((Fall - 1.0) / (ratio - 1.0) - 1.0, 0.0, MaximumNoise)
                     : MaximumNoise;
}

double noiseVariance(double coarseError, double fineError)
{
  constexpr double geometricMean = 0.2807; // of squares of normal deviates
  const double detail = std::max(0.0, coarseError - fineError) / (Fall - 1.0);
  return std::max(0.0, fineError - detail) / geometricMean;
}

void TypicalSquare::add(double square)
{
  constexpr double minimum = 1e-16;
  this->Logarithms.add(0, std::log(std::max(square, minimum)) / LogUnit);
}

double TypicalSquare::mean(const Reduce& reduce, Index count)
{
  this->Logarithms.reduce(reduce);
  return std::exp(LogUnit * this->Logarithms[0] / static_cast<double>(count));
}

double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const Run& run)
{
  const TriangleTree surface(positions, triangles, run.unwatched());
  SampleRotation rotation(samples, 1);
  rotation.turn(wanted);
  TypicalSquare typical;
  forEachFoot(
    samples, surface, rotation.count(), [&](Index i) { return rotation.id(i); },
    [&](Index, const Vector3&, const FootPoint& foot) { typical.add(foot.SquareDistance); }, run);
  return typical.mean(samples.reduce(), rotation.totalCount());
}
}
