#include "Learn/ConformalSOM.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Learn/AdaptiveTraining.h"
#include "Learn/BatchTraining.h"
#include "Learn/OnlineTraining.h"
#include "Mesh/GeodesicSphere.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"
#include "SphereMap/GlobalConformalMap.h"

#include <algorithm>
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

bool isAdaptive(const ConformalSOMOptions& options)
{
  return options.Lattice == Lattice::Adaptive ||
    (options.Lattice == Lattice::Automatic && options.TrainingMode == TrainingMode::Batch);
}

/// Flat points have no surface that triangles could follow.
ConformalSOMOptions forSamples(ConformalSOMOptions options, const TrainingSamples& samples)
{
  if (options.Lattice == Lattice::Automatic && isAdaptive(options) && samples.dimension() < 3)
  {
    const double square = static_cast<double>(options.NumberOfNeurons - 2) / 10.0;
    options.Frequency = std::max(1, static_cast<int>(std::lround(std::sqrt(square))));
    options.Lattice = Lattice::Geodesic;
  }
  return options;
}

void check(const ConformalSOMOptions& options)
{
  const bool adaptive = isAdaptive(options);
  require(!adaptive || options.TrainingMode == TrainingMode::Batch,
    "the adaptive lattice can be learned in Batch mode only; in Online mode take the geodesic one");
  require(!adaptive || options.NumberOfNeurons >= MinimumNeurons,
    "NumberOfNeurons must be at least " + std::to_string(MinimumNeurons));
  require(
    options.AreaBalance >= 0.0 && options.AreaBalance <= 1.0, "AreaBalance must lie in [0, 1]");
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

/// From the points' own unit to that of training.
Points normalized(Points points, const TrainingSamples& samples)
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = samples.normalize(points.row(i));
  }
  return points;
}

/// In the samples' unit.
ConformalSOMResult trainGeodesic(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const MappedMesh* start, const Run& run)
{
  const bool online = options.TrainingMode == TrainingMode::Online;
  if (!online && !start)
  {
    return trainBatch(samples, options, run);
  }
  Steps steps(run, { 1.0, 40.0 }); // parts of the polish
  const Mesh network = makeGeodesicSphere(options.Frequency, run.unwatched());
  const Run starting = steps.next();
  Points weights = network.Positions; // step 1
  if (start)
  {
    weights = normalized(
      resample(start->SpherePositions, start->Positions, start->Triangles, weights, starting),
      samples);
    requireNear(weights);
  }
  return online ? trainOnline(samples, network, weights, options, steps.next())
                : trainBatchFrom(std::move(weights), samples, options, steps.next());
}

/// In the samples' unit, and not mapped yet.
ConformalSOMResult trainAdaptiveFrom(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* start, const Run& run)
{
  if (!start)
  {
    return trainAdaptive(samples, options, nullptr, run);
  }
  MappedMesh own = *start;
  own.Positions = normalized(std::move(own.Positions), samples);
  requireNear(own.Positions);
  return trainAdaptive(samples, options, &own, run);
}

/// Whether the learned surface is to be mapped to the sphere anew.
bool mapsAnew(const ConformalSOMOptions& options)
{
  return isAdaptive(options) || options.SphereMap != SphereMap::Lattice;
}

GlobalConformalMapOptions mapOptions(const ConformalSOMOptions& options)
{
  GlobalConformalMapOptions map;
  map.AreaBalance = options.SphereMap == SphereMap::Balanced ? options.AreaBalance : 0.0;
  return map;
}

// The middle of what learning takes for each neuron, or pattern.
double workOfLearning(const ConformalSOMOptions& options)
{
  return options.TrainingMode == TrainingMode::Online
    ? 5000.0 * options.NumberOfEpochs * options.SamplesPerEpoch
    : 150000.0 * static_cast<double>(numberOfNeurons(options));
}

double workOfMap(const ConformalSOMOptions& options)
{
  return mapsAnew(options) ? workOfGlobalConformalMap(mapOptions(options), numberOfNeurons(options))
                           : 0.0;
}
}

Index numberOfNeurons(const ConformalSOMOptions& options)
{
  return isAdaptive(options) ? options.NumberOfNeurons : geodesicSphereSize(options.Frequency);
}

double workOfConformalSOM(const ConformalSOMOptions& options)
{
  return workOfLearning(options) + workOfMap(options);
}

ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& requested, const MappedMesh* start, const Run& run)
{
  require(!samples.empty(), "there is no point to learn from");
  check(requested);
  const ConformalSOMOptions options = forSamples(requested, samples);
  run.report(0.0);
  Steps steps(run, { workOfLearning(options), workOfMap(options) });
  const auto learn = isAdaptive(options) ? trainAdaptiveFrom : trainGeodesic;
  ConformalSOMResult result = learn(samples, options, start, steps.next());
  if (!isAdaptive(options) && options.TrainingMode == TrainingMode::Batch)
  {
    result.Verdict =
      judgeSurface(samples, result.Positions, result.Triangles, result.Noise, run.unwatched());
  }
  if (mapsAnew(options))
  {
    const GlobalConformalMapOptions wanted = mapOptions(options);
    GlobalConformalMapResult map = globalConformalMap(result, wanted, steps.next());
    result.SpherePositions = std::move(map.Positions);
    result.ConformalMapFits =
      wanted.AreaBalance > 0.0 || map.Tier != GlobalConformalTier::Progressive;
  }
  for (Index i = 0; i < result.Positions.rows(); ++i)
  {
    result.Positions.row(i) = samples.restore(result.Positions.row(i));
  }
  run.report(1.0);
  return result;
}

std::vector<double> quantizationErrors(
  const TrainingSamples& samples, const ConformalSOMResult& result, const Run& run)
{
  Steps steps(run,
    { 1000.0 * static_cast<double>(result.Positions.rows()),
      1000.0 * static_cast<double>(samples.size()) });
  const Points weights = normalized(result.Positions, samples);
  FixedPointSums squares(weights.rows()), counts(weights.rows());
  const TriangleTree tree(weights, result.Triangles, steps.next());
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
    steps.next());
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
