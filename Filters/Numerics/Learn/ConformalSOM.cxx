#include "Learn/ConformalSOM.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Learn/AdaptiveTraining.h"
#include "Learn/BatchTraining.h"
#include "Learn/OnlineTraining.h"
#include "Learn/SurfaceStart.h"
#include "Learn/SurfaceSupport.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"
#include "SphereMap/GlobalConformalMap.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
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

/// From the points' own unit to that of training.
Points normalized(Points points, const TrainingSamples& samples)
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = samples.normalize(points.row(i));
  }
  return points;
}

/// And back.
Points restored(Points points, const TrainingSamples& samples)
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = samples.restore(points.row(i));
  }
  return points;
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

/// Whether this process has the first of the samples.
bool isFirst(const TrainingSamples& samples)
{
  return samples.size() > 0 && samples.firstOfTotal() == 0;
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

Mesh normalized(const Mesh& start, const TrainingSamples& samples)
{
  Mesh mesh = { normalized(start.Positions, samples), start.Triangles };
  requireNear(mesh.Positions);
  return mesh;
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

// The middle of what learning takes for each neuron, or pattern.
double workOfLearning(const ConformalSOMOptions& options)
{
  return options.TrainingMode == TrainingMode::Online
    ? 5000.0 * options.NumberOfEpochs * options.SamplesPerEpoch
    : 150000.0 * static_cast<double>(numberOfNeurons(options));
}

std::shared_ptr<const TriangleTree> treeOf(const Mesh& mesh, const Run& run)
{
  return std::make_shared<TriangleTree>(mesh.Positions, mesh.Triangles, run);
}

/// Of the sphere for limbs. Measured on the armadillo: 0.2 has twenty times the webs, 0.35
/// fourteen times the folds.
constexpr double BalanceOfMesh = 0.25;

constexpr double WorkOfTree = 1300.0; // in nanoseconds as in Steps, for each vertex

/// In the samples' unit: from a surface that has no map to the sphere yet.
ConformalSOMResult trainGeodesicFrom(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const Mesh& start, const Run& run)
{
  const auto size = static_cast<double>(start.Positions.rows());
  Steps steps(run, { workOfThinAndMap(size), WorkOfTree * size, workOfLearning(options) });
  const std::optional<MappedMesh> mapped = thinAndMap(start, BalanceOfMesh, steps.next());
  if (!mapped && options.StartingShape == StartingShape::Mesh)
  {
    throw std::runtime_error(
      "the input's polygons wind too much to be mapped to the sphere, as those of long thin curves "
      "do: let StartingShape be Sphere or Automatic, or Lattice be Adaptive");
  }
  const std::shared_ptr<const TriangleTree> tree = treeOf(start, steps.next());
  if (!mapped)
  {
    return trainBatch(samples, options, steps.next());
  }
  ConformalSOMResult result = trainBatchFromMesh(
    [&](const Points& directions)
    {
      return resample(
        mapped->SpherePositions, mapped->Positions, mapped->Triangles, directions, run.unwatched());
    },
    samples, options, tree, steps.next());
  result.FromMesh = true;
  return result;
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
  if (start && start->SpherePositions.rows() == 0)
  {
    require(!online, "to start from in Online mode, a mesh must have its place on the sphere");
    return trainGeodesicFrom(samples, options, normalized(*start, samples), run);
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
  ConformalSOMResult result = online
    ? trainOnline(samples, network, weights, options, steps.next())
    : trainBatchFrom(std::move(weights), samples, options, steps.next());
  result.FromMesh = start;
  return result;
}

/// In the samples' unit, and not mapped yet.
ConformalSOMResult trainAdaptiveFrom(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* start, const Run& run)
{
  if (!start)
  {
    return trainAdaptive(samples, options, nullptr, nullptr, run);
  }
  const Mesh own = normalized(*start, samples);
  const bool isOfSamples = start->SpherePositions.rows() == 0;
  constexpr double workOfRemeshing = 4800.0; // for each vertex, down to the network's
  const auto size = static_cast<double>(own.Positions.rows());
  Steps steps(run,
    { isOfSamples ? WorkOfTree * size : 0.0, workOfLearning(options) + workOfRemeshing * size });
  const Run growing = steps.next();
  return trainAdaptive(
    samples, options, &own, isOfSamples ? treeOf(own, growing) : nullptr, steps.next());
}

/// In the samples' unit, judged, and not mapped yet where it is to be mapped anew.
ConformalSOMResult learn(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const MappedMesh* start, const Run& run)
{
  Steps steps(run, { workOfLearning(options), workOfSupport(numberOfNeurons(options)) });
  ConformalSOMResult result = (isAdaptive(options) ? trainAdaptiveFrom : trainGeodesic)(
    samples, options, start, steps.next());
  if (!isAdaptive(options) && options.TrainingMode == TrainingMode::Batch)
  {
    result.Verdict =
      judgeSurface(samples, result.Positions, result.Triangles, result.Noise, run.unwatched());
  }
  result.Supported = supportOfVertices(samples, result.Positions, result.Triangles, steps.next());
  return result;
}

/// From one frame to another.
Points moved(Points points, const TrainingSamples& from, const TrainingSamples& to)
{
  return normalized(restored(std::move(points), from), to);
}

/// What the vertices and normals of the samples' own mesh say of a surface in the samples' unit.
/// The samples may be corners of a polygon soup, many at one place.
SurfaceVerdict judgeByMesh(const ConformalSOMResult& result, const TrainingSamples& samples,
  const MappedMesh& mesh, const Run& run)
{
  const Points normals = vertexNormals(mesh.Positions, mesh.Triangles);
  const bool here = isFirst(samples);
  TrainingSamples vertices(
    here ? PointView(mesh.Positions) : PointView(), {}, {}, samples.reduce());
  vertices.setNormals(here ? PointView(normals) : PointView());
  return judgeSurface(vertices, moved(result.Positions, samples, vertices), result.Triangles,
    result.Noise * samples.scale() / vertices.scale(), run.unwatched());
}

/// The same from a mesh that has the samples as its vertices. Where these are sparse its triangles
/// say what lies between them. A mesh that is no surface of the samples shows in the verdict: then
/// it is another start that is wanted, unless it was asked for by name.
ConformalSOMResult learnFromOwnMesh(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh& mesh, const Run& run)
{
  constexpr double share = 0.95; // of the progress; other starts are rare
  const Run learning = run.part(0.0, share);
  ConformalSOMResult result;
  if (samples.weighted() || samples.dimension() < 3)
  {
    result = learn(samples, options, &mesh, learning);
  }
  else
  {
    const Points dense =
      withPointsBetween(mesh, options.SamplesPerNeuron * numberOfNeurons(options));
    const TrainingSamples denser(
      isFirst(samples) ? PointView(dense) : PointView(), {}, {}, samples.reduce());
    result = learn(denser, options, &mesh, learning);
    result.Positions = moved(std::move(result.Positions), denser, samples);
    result.Noise *= denser.scale() / samples.scale();
  }
  result.Verdict = judgeByMesh(result, samples, mesh, run);
  if (!result.FromMesh || options.StartingShape == StartingShape::Mesh ||
    badness(result.Verdict) <= 1.0)
  {
    return result;
  }
  ConformalSOMResult other = learn(samples, options, nullptr, run.part(share, 1.0));
  const int starts = result.NumberOfStarts + other.NumberOfStarts;
  if (badness(other.Verdict) < badness(result.Verdict))
  {
    result = std::move(other);
  }
  result.NumberOfStarts = starts;
  return result;
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
  require(start || options.StartingShape != StartingShape::Mesh ||
      options.TrainingMode == TrainingMode::Online,
    "there is no mesh to start from");
  run.report(0.0);
  Steps steps(run, { workOfLearning(options), workOfMap(options) });
  const bool isOwn = start && start->SpherePositions.rows() == 0;
  require(!start || start->Triangles.rows() >= 4,
    "the mesh to start from is two triangles back to back, which enclose nothing");
  ConformalSOMResult result = isOwn ? learnFromOwnMesh(samples, options, *start, steps.next())
                                    : learn(samples, options, start, steps.next());
  if (mapsAnew(options))
  {
    const GlobalConformalMapOptions wanted = mapOptions(options);
    GlobalConformalMapResult map = globalConformalMap(result, wanted, steps.next());
    result.SpherePositions = std::move(map.Positions);
    result.ConformalMapFits =
      wanted.AreaBalance > 0.0 || map.Tier != GlobalConformalTier::Progressive;
  }
  result.Positions = restored(std::move(result.Positions), samples);
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
