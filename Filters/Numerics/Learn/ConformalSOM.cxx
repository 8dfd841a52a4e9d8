#include "Learn/ConformalSOM.h"

#include "Base/FixedPointSums.h"
#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/Outliers.h"
#include "Cloud/SampleRotation.h"
#include "Learn/FirstSurface.h"
#include "Learn/Fit/PatternFit.h"
#include "Learn/Fit/Slivers.h"
#include "Learn/Fit/Untangling.h"
#include "Learn/Fit/VertexSupport.h"
#include "Learn/NeuronSearch.h"
#include "Learn/Online/OnlineTraining.h"
#include "Learn/OpenSurface.h"
#include "Learn/StartSearch.h"
#include "Measure/Distortion.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"
#include "SphereMap/GlobalConformalMap.h"
#include "SphereMap/SheetMap.h"

#include <algorithm>
#include <cmath>
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

Index neuronsOf(const ConformalSOMOptions& options)
{
  return options.NumberOfNeurons == AutomaticNeurons ? UsualNeurons : options.NumberOfNeurons;
}

bool positive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

void check(const OnlineOptions& options)
{
  require(options.NumberOfEpochs >= 0, "NumberOfEpochs must not be negative");
  require(options.SamplesPerEpoch >= 1, "SamplesPerEpoch must be at least 1");
  require(positive(options.InitialNeighborhoodRadius),
    "the initial neighborhood radius, sigma_0, must be a positive number");
  require(positive(options.NeighborhoodTimeConstant),
    "the time constant of the neighborhood, tau_1, must be a positive number");
  require(options.InitialLearningRate >= 0.0 && options.InitialLearningRate < 1.0,
    "the initial learning rate, alpha_0, must lie in [0, 1)");
  require(positive(options.LearningRateTimeConstant),
    "the time constant of the learning rate, tau_2, must be a positive number");
}

void check(const ConformalSOMOptions& options)
{
  const bool online = options.TrainingMode == TrainingMode::Online;
  require(!online || options.MeshType != MeshType::Adaptive,
    "an adaptive mesh is learned in Batch mode only; set TrainingMode to Batch, or MeshType to "
    "Geodesic or Automatic");
  require(options.NumberOfNeurons == AutomaticNeurons || options.NumberOfNeurons >= MinimumNeurons,
    "NumberOfNeurons must be 0 (automatic) or at least " + std::to_string(MinimumNeurons));
  check(options.Online);
  require(options.Batch.PassesPerLevel >= 0, "PassesPerLevel must not be negative");
  require(options.Batch.SamplesPerNeuron >= 1, "SamplesPerNeuron must be at least 1");
  require(options.Fit.Iterations >= 0, "FitIterations must not be negative");
  require(std::isfinite(options.Fit.Smoothness) && options.Fit.Smoothness >= 0.0,
    "Smoothness must be a number that is not negative");
  require(std::isfinite(options.Opening.HoleSize) && options.Opening.HoleSize >= 0.0,
    "HoleSize must be a number that is not negative");
  require(
    options.Opening.Border != Border::Open || (!online && options.MeshType != MeshType::Geodesic),
    "only an adaptive mesh has a border; set Border to Automatic or Closed, or TrainingMode to "
    "Batch and MeshType to Automatic or Adaptive");
}

void checkStart(const ConformalSOMOptions& options, const MappedMesh* mesh)
{
  const bool online = options.TrainingMode == TrainingMode::Online;
  const bool isGeodesic = online || options.MeshType == MeshType::Geodesic;
  const bool isSphere = options.StartingShape == StartingShape::Automatic ||
    options.StartingShape == StartingShape::Sphere;
  const std::string instead = online ? "TrainingMode to Batch" : "MeshType to Adaptive";
  require(!isGeodesic || isSphere,
    "a geodesic mesh is learned from the sphere; set StartingShape to Automatic or Sphere, or " +
      instead);
  const bool isMapped = mesh && mesh->SpherePositions.rows() > 0;
  require(!isGeodesic || !mesh || (online && isMapped),
    "a geodesic mesh is learned from the sphere; remove the starting mesh, or set " + instead);
  require(options.Genus == HullGenus::Zero ||
      (!isGeodesic && options.StartingShape != StartingShape::Sphere),
    "a mesh that is learned from the sphere has no handles; set Genus to Zero, or TrainingMode to "
    "Batch, MeshType to Automatic or Adaptive, and StartingShape to Automatic or Hull");
  require(mesh || options.StartingShape != StartingShape::Mesh, "there is no starting mesh");
  require(!mesh || mesh->Triangles.rows() >= 4,
    "the starting mesh is two triangles back to back, which enclose nothing");
}

/// Return the initial weights. Without a given mesh, they are the network positions. Otherwise,
/// they are the points of the mesh in the directions of the network positions.
Points firstWeights(
  const TrainingSamples& samples, const Points& network, const MappedMesh* mesh, const Run& run)
{
  if (!mesh)
  {
    return network;
  }
  Points weights = samples.normalizeAll(
    resample(mesh->SpherePositions, mesh->Positions, mesh->Triangles, network, run));
  requireNear(weights);
  return weights;
}

/// Pass a surface in the samples' unit to options.Observer, without evaluating its quality.
void observe(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const std::string& start, const std::string& name, const Mesh& surface)
{
  if (!options.Observer)
  {
    return;
  }
  LearningStage stage;
  stage.Start = start;
  stage.Name = name;
  stage.Surface = surface;
  stage.Surface.Positions = samples.restoreAll(std::move(stage.Surface.Positions));
  options.Observer(stage);
}

ConformalSOMResult learnOnline(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const MappedMesh* mesh, const Run& run)
{
  OnlineTrainingOptions online;
  static_cast<OnlineOptions&>(online) = options.Online;
  online.Frequency = geodesicFrequencyFor(neuronsOf(options));
  online.ReferencePoint = options.ReferencePoint;
  online.RandomSeed = options.RandomSeed;
  Steps steps(run, { 0.02, 0.96, 0.02 }); // progress: first weights, learning, support
  const Mesh network = makeGeodesicSphere(online.Frequency, run.unwatched());
  const Points weights = firstWeights(samples, network.Positions, mesh, steps.next());
  const std::string start = mesh ? "given mesh" : "sphere";
  observe(samples, options, start, "start", { weights, network.Triangles });
  ConformalSOMResult result;
  static_cast<LearnedMesh&>(result) = trainOnline(samples, network, weights, online, steps.next());
  result.FromMesh = mesh;
  observe(samples, options, start, "kept", result);
  result.Supported = supportOfVertices(samples, result.Positions, result.Triangles, steps.next());
  return result;
}
}

namespace
{
/// Open the surface where the samples end, and map the sheet to the sphere. Return false, without a
/// change, if no part is left open.
bool openedAndMapped(const TrainingSamples& samples, const BorderOptions& opening,
  ConformalSOMResult& result, const Run& run)
{
  BorderOptions scaled = opening;
  scaled.HoleSize /= samples.scale();
  ConformalSOMResult opened = result;
  Steps steps(run, { 0.5, 0.5 }); // progress: cut, map
  if (!openSurface(samples, scaled, opened, steps.next()))
  {
    return false;
  }
  try
  {
    if (opened.NumberOfBorders > 0)
    {
      opened.SpherePositions = mapSheet(opened, steps.next()).Positions;
      result = std::move(opened);
      return true;
    }
  }
  catch (const NumericalFailure&)
  {
    // The sheet has narrow bridges. The closed surface is mapped.
  }
  result.BorderFailed = true;
  return false;
}

/// Remove slivers, which maps to the sphere distort. A vertex made from two others gets the larger
/// standard error, and the smaller support.
void removeSliversOf(ConformalSOMResult& result, const Run& run)
{
  const SliverRemoval removal = removeSlivers(result, run);
  const auto renew = [&](std::vector<double>& values, const auto& choose)
  {
    const std::vector<double> old = values;
    for (std::size_t v = 0; v < std::min(values.size(), removal.Sources.size()); ++v)
    {
      const auto [a, b] = removal.Sources[v];
      values[v] = choose(old[a], old[b]);
    }
  };
  renew(result.StandardError, [](double a, double b) { return std::max(a, b); });
  renew(result.Supported, [](double a, double b) { return std::min(a, b); });
}

/// Number of samples for each neuron up to which all samples are sorted. With more samples, an
/// iteration of the fit uses few of them.
constexpr Index ManyForOne = 100;

/// Map the surface to the sphere, after it was opened where the samples end.
void openAndMap(const TrainingSamples& samples, const BorderOptions& opening,
  ConformalSOMResult& result, const Run& run)
{
  Steps steps(run, { 0.3, 0.7 }); // progress: sheet, closed surface
  if (openedAndMapped(samples, opening, result, steps.next()))
  {
    return;
  }
  GlobalConformalMapResult map = globalConformalMap(result, {}, steps.next());
  result.SpherePositions = std::move(map.Positions);
  result.ConformalMapFits = map.Tier != GlobalConformalTier::Progressive;
}
}

ConformalSOMResult trainConformalSOM(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run)
{
  require(!samples.empty(), "there is no point to learn from");
  check(options);
  checkStart(options, mesh);
  run.report(0.0);
  const bool isGeodesic = meshTypeFor(options, samples) == MeshType::Geodesic;
  // The vertices of the samples' own mesh are no outliers.
  const bool mayHaveOutliers = !isGeodesic && !(mesh && mesh->SpherePositions.rows() == 0);
  const bool fitsValues =
    samples.numberOfPatternValues() > 0 && options.TrainingMode == TrainingMode::Batch;
  Steps parts(run, { fitsValues ? 0.9 : 1.0, fitsValues ? 0.1 : 0.0 }); // mesh, pattern values
  // Progress: outliers, learning, alignment with pattern values, removal of slivers and
  // self-intersections, conformal map.
  std::vector<double> shares =
    isGeodesic ? std::vector<double>{ 0.0, 1.0 } : std::vector<double>{ 0.02, 0.77 };
  if (fitsValues)
  {
    shares.push_back(0.3);
  }
  if (!isGeodesic)
  {
    shares.insert(shares.end(), { 0.01, 0.2 });
  }
  Steps steps(parts.next(), shares);
  const Run cleaning = steps.next();
  TrainingSamples kept = mayHaveOutliers ? withoutOutliers(samples, cleaning) : samples;
  if (!isGeodesic && kept.size() <= ManyForOne * neuronsOf(options))
  {
    kept.sortAlongCurve(cleaning.unwatched());
  }
  ConformalSOMResult result = options.TrainingMode == TrainingMode::Online
    ? learnOnline(kept, options, mesh, steps.next())
    : learnWithNeurons(kept, options, mesh, steps.next());
  if (fitsValues)
  {
    alignWithPatternValues(kept, result, steps.next());
  }
  if (!isGeodesic)
  {
    const bool isOwnMesh = result.FromMesh && mesh->SpherePositions.rows() == 0;
    if (result.NumberOfSamplesOutside > 0)
    {
      result.NumberOfSamplesOutside = std::min(result.NumberOfSamplesOutside,
        countBeyondReach(kept, result.Positions, result.Triangles, result.Noise, run.unwatched()));
    }
    const Run untangling = steps.next();
    if (kept.dimension() == 3)
    {
      removeSliversOf(result, untangling.unwatched());
    }
    result.SelfIntersections = untangle(result.Positions, result.Triangles, untangling);
    BorderOptions opening = options.Opening;
    // The triangles of the input define the surface between its points. Flat points have no inside.
    if (isOwnMesh || kept.dimension() < 3)
    {
      opening.Border = Border::Closed;
    }
    result.NumberOfHandles =
      checkGenusZero(result.Triangles, result.Positions.rows()).numberOfHandles();
    const Run mapping = steps.next();
    if (result.NumberOfHandles == 0)
    {
      openAndMap(kept, opening, result, mapping);
    }
  }
  if (fitsValues)
  {
    result.PatternValues = fitPatternValues(kept, result, parts.next());
  }
  result.NumberOfOutliers = samples.totalSize() - kept.totalSize();
  if (result.NumberOfHandles == 0)
  {
    const Distortion distortion = measureDistortion(
      result.Positions, result.Triangles, result.SpherePositions, run.unwatched());
    result.MeanQuasiConformalError = distortion.AreaMeanQuasiConformalError;
    result.MaximumQuasiConformalError = distortion.MaximumQuasiConformalError;
  }
  result.HasConformalMap = !isGeodesic && result.NumberOfHandles == 0;
  if (kept.dimension() == 0)
  {
    result.Positions.setZero(); // points that are all equal have a place, and no size
  }
  result.Positions = kept.restoreAll(std::move(result.Positions));
  run.report(1.0);
  return result;
}

std::vector<double> quantizationErrors(const TrainingSamples& samples,
  const ConformalSOMResult& result, const ConformalSOMOptions& options, const Run& run)
{
  Steps steps(run, { 0.1, 0.9 }); // progress: tree, foot points
  const Points weights = samples.normalizeAll(result.Positions);
  FixedPointSums squares(weights.rows()), counts(weights.rows());
  const TriangleTree tree(weights, result.Triangles, steps.next());
  SampleRotation rotation(samples, options.RandomSeed);
  rotation.turn(options.Batch.SamplesPerNeuron * weights.rows());
  forEachFoot(
    samples, tree, rotation.count(), [&](Index i) { return rotation.id(i); },
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
