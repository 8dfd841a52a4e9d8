#include "Learn/ConformalSOM.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Learn/BatchTraining.h"
#include "Learn/OnlineTraining.h"
#include "Mesh/GeodesicSphere.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
void require(bool good, const std::string& what)
{
  if (!good)
  {
    throw std::invalid_argument(what);
  }
}

bool positive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

/// From farther away all patterns would be drawn to one or two neurons.
void requireNear(const Points& start)
{
  constexpr double farthest = 4.0;
  const double reached = start.cwiseAbs().maxCoeff();
  std::ostringstream text;
  text << "the mesh to start from must lie near the points and be of their size, but reaches "
       << reached << " times as far from their middle as they do";
  require(reached <= farthest, text.str());
}

void check(const ConformalSOMOptions& options)
{
  require(options.NumberOfEpochs >= 0, "NumberOfEpochs must not be negative");
  require(options.SamplesPerEpoch >= 1, "SamplesPerEpoch must be at least 1");
  require(positive(options.InitialNeighborhoodRadius),
    "InitialNeighborhoodRadius must be a positive number");
  require(positive(options.NeighborhoodTimeConstant),
    "NeighborhoodTimeConstant must be a positive number");
  require(options.InitialLearningRate >= 0.0 && options.InitialLearningRate < 1.0,
    "InitialLearningRate must lie in [0, 1)");
  require(positive(options.LearningRateTimeConstant),
    "LearningRateTimeConstant must be a positive number");
  require(options.PassesPerLevel >= 0, "PassesPerLevel must not be negative");
  require(options.SamplesPerNeuron >= 1, "SamplesPerNeuron must be at least 1");
  require(options.NumberOfPolishRounds >= 0, "NumberOfPolishRounds must not be negative");
  require(std::isfinite(options.Smoothness) && options.Smoothness >= 0.0,
    "Smoothness must be a number that is not negative");
}
}

ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* start, const ParallelFor& parallelFor,
  const Progress& progress)
{
  require(!samples.empty(), "there is no point to learn from");
  check(options);
  report(progress, 0.0);
  const bool online = options.TrainingMode == TrainingMode::Online;
  ConformalSOMResult result;
  if (!online && !start)
  {
    result = trainBatch(samples, options, parallelFor, progress);
  }
  else
  {
    Steps steps(progress, { 1.0, 40.0 }); // parts of the polish
    const Mesh network = makeGeodesicSphere(options.Frequency, parallelFor);
    const Progress starting = steps.next();
    Points weights = network.Positions; // step 1
    if (start)
    {
      weights = resample(
        start->SpherePositions, start->Positions, start->Triangles, weights, parallelFor, starting);
      for (Index i = 0; i < weights.rows(); ++i)
      {
        weights.row(i) = samples.normalize(weights.row(i));
      }
      requireNear(weights);
    }
    result = online
      ? trainOnline(samples, network, weights, options, steps.next())
      : trainBatchFrom(std::move(weights), samples, options, parallelFor, steps.next());
  }
  for (Index i = 0; i < result.Positions.rows(); ++i)
  {
    result.Positions.row(i) = samples.restore(result.Positions.row(i));
  }
  report(progress, 1.0);
  return result;
}

std::vector<double> quantizationErrors(const TrainingSamples& samples,
  const ConformalSOMResult& result, const ParallelFor& parallelFor, const Progress& progress)
{
  Steps steps(progress,
    { 1000.0 * static_cast<double>(result.Positions.rows()),
      1000.0 * static_cast<double>(samples.size()) });
  Points weights(result.Positions.rows(), 3);
  for (Index i = 0; i < weights.rows(); ++i)
  {
    weights.row(i) = samples.normalize(result.Positions.row(i));
  }
  FixedPointSums squares(weights.rows()), counts(weights.rows());
  const TriangleTree tree(weights, result.Triangles, parallelFor, steps.next());
  forEachFoot(
    samples, tree, samples.size(), {},
    [&](Index, const Vector3& x, const FootPoint& foot)
    {
      int corner = 0;
      foot.Barycentric.maxCoeff(&corner);
      const int neuron = result.Triangles(foot.Triangle, corner);
      squares.add(neuron, (x - Vector3(weights.row(neuron))).squaredNorm());
      counts.add(neuron, 1.0);
    },
    parallelFor, steps.next());
  squares.reduce(samples.reduce());
  counts.reduce(samples.reduce());
  std::vector<double> errors(weights.rows(), 0.0);
  for (Index i = 0; i < weights.rows(); ++i)
  {
    errors[i] = counts[i] > 0.0 ? samples.scale() * std::sqrt(squares[i] / counts[i]) : 0.0;
  }
  return errors;
}
}
