#include "Learn/BatchTraining.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
#include "Learn/HullStart.h"
#include "Learn/LeastSquaresPolish.h"
#include "Learn/NoiseEstimate.h"
#include "Learn/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"
#include "TriangleMap/NetworkShapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr int CoarsestFrequency = 4;
constexpr Index BlockSize = 1024;
// Measured on Igea with Gaussian noise of 0.005: noise 6, best smoothness 1.
constexpr double SmoothnessForNoise = 0.03, LittleNoise = 0.5;

/// Learning leaves the lattice well spread, and evening it further costs little fit. Over the
/// hollows of a hull it would leave lids.
constexpr double EvennessFromSphere = 3.0;

constexpr int WidestDiffusion = 5; ///< steps over the lattice in the first pass of a level

std::vector<int> frequencies(int finest)
{
  std::vector<int> levels = { finest };
  while (levels.back() / 2 >= CoarsestFrequency)
  {
    levels.push_back(levels.back() / 2);
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

/// For each neuron the mass C of its patterns, then their sum S.
using Shares = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// One step of diffusion over the lattice: every neuron keeps half and hands half to its
/// neighbors in equal parts.
void diffuse(const Adjacency& neighbors, Shares& shares, const Run& run)
{
  Shares spread(shares.rows(), 4);
  forBlocks(run, shares.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        spread.row(i) = 0.5 * shares.row(i);
        for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        {
          spread.row(i) += 0.5 / neighbors.size(*j) * shares.row(*j);
        }
      }
    });
  shares.swap(spread);
}

/// The width of so many steps of diffusion as a radius sigma on the unit sphere: a step's variance
/// in one direction is a quarter of the square edge length, half of the neighbors' half share.
double diffusionRadius(int steps, Index triangles)
{
  const double area = 4.0 * Pi / static_cast<double>(triangles);
  const double squareEdge = 4.0 / std::sqrt(3.0) * area;
  return std::sqrt(0.25 * steps * squareEdge);
}

/// S / C. A neuron without patterns follows its neighbors.
Points means(
  const Shares& shares, const Adjacency& neighbors, const Points& weights, const Run& run)
{
  const double negligible = 1e-6 * shares.col(0).mean();
  Points moved(weights.rows(), 3);
  forBlocks(run, moved.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        Vector3 around = Vector3::Zero();
        for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        {
          around += Vector3(weights.row(*j)) / neighbors.size(i);
        }
        moved.row(i) =
          (shares.row(i).tail<3>() + negligible * around.transpose()) / (shares(i, 0) + negligible);
      }
    });
  return moved;
}

/// What is to be smoothed more the more noise there is; far patterns are noise then, not tips.
PolishOptions polishFor(const ConformalSOMOptions& options, double noise)
{
  const Index numberOfNeurons = geodesicSphereSize(options.Frequency);
  PolishOptions polish;
  polish.NumberOfRounds = options.NumberOfPolishRounds;
  polish.LastSmoothness = options.Smoothness + SmoothnessForNoise * noise * noise;
  polish.FirstSmoothness = polish.LastSmoothness;
  polish.Evenness = EvennessFromSphere;
  polish.AutomaticPriority = options.AutomaticPriority && noise < LittleNoise;
  polish.SamplesPerRound = options.SamplesPerNeuron * numberOfNeurons;
  polish.RandomSeed = options.RandomSeed;
  return polish;
}

/// What steps of learning take, in nanoseconds as in Steps.
double workOfWinners(const TrainingSamples& samples, Index wanted)
{
  return 650.0 * static_cast<double>(std::min(wanted, samples.totalSize()));
}

double workOfLattice(int frequency)
{
  return 1400.0 * static_cast<double>(geodesicSphereSize(frequency));
}

double workOfPass(const TrainingSamples& samples, const ConformalSOMOptions& options, int frequency)
{
  const auto neurons = static_cast<double>(geodesicSphereSize(frequency));
  return workOfWinners(samples, static_cast<Index>(options.SamplesPerNeuron * neurons)) +
    500.0 * neurons;
}

/// Of the levels from this frequency on: for each its network, then its passes.
std::vector<double> workOfLevels(
  const TrainingSamples& samples, const ConformalSOMOptions& options, int first)
{
  std::vector<double> work;
  for (int f : frequencies(options.Frequency))
  {
    if (f >= first)
    {
      work.insert(
        work.end(), { workOfLattice(f), options.PassesPerLevel * workOfPass(samples, options, f) });
    }
  }
  return work;
}

/// Of the patterns in each triangle, about: each neuron's, shared out to the triangles around it.
std::vector<double> massesOf(
  const Shares& shares, const Triangles& triangles, const Adjacency& neighbors)
{
  std::vector<double> masses(triangles.rows(), 0.0);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      masses[r] += shares(triangles(r, k), 0) / neighbors.size(triangles(r, k));
    }
  }
  return masses;
}

/// How a pattern is shared out to the corners of the triangle that it is projected on: the
/// barycentric weights of its reference point.
class CornerShares
{
public:
  /// @param[in] model  the weights, which may move
  CornerShares(ReferencePoint reference, const Points& network, const Points& model,
    const Triangles& triangles)
    : Reference(reference)
    , Model(model)
    , Corners(triangles)
  {
    if (reference == ReferencePoint::Conformal)
    {
      this->Shapes = NetworkShapes(network, triangles);
    }
  }

  Vector3 operator()(const FootPoint& foot) const
  {
    if (this->Reference == ReferencePoint::Winner)
    {
      int largest = 0;
      foot.Barycentric.maxCoeff(&largest);
      return Vector3::Unit(largest);
    }
    if (this->Reference == ReferencePoint::Conformal)
    {
      const auto ids = this->Corners.row(foot.Triangle);
      const TriangleShape simplex(
        this->Model.row(ids[0]), this->Model.row(ids[1]), this->Model.row(ids[2]));
      return this->Shapes.toNetwork(foot.Triangle, simplex, foot.Barycentric);
    }
    return foot.Barycentric;
  }

private:
  ReferencePoint Reference;
  const Points& Model;
  const Triangles& Corners;
  NetworkShapes Shapes;
};

/// The work that is left after the last level, as a level's mesh and the patterns in each of its
/// triangles make likely; or nothing, to stop at this level.
using Forecast =
  std::function<std::optional<double>(const ConformalSOMResult&, const std::vector<double>&)>;

/// Learning passes from the unit sphere, coarse to fine.
/// @param[in] rest      the work that is expected after the last level, before anything is known
/// @param[in] forecast  what is expected when a level is done
ConformalSOMResult learnFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const Run& run, double rest, const Forecast& forecast,
  Steps& steps)
{
  const std::vector<int> levels = frequencies(options.Frequency);
  ConformalSOMResult result;
  double typicalErrors[2] = {}; // of the last passes of the coarser lattice and of this one
  SampleRotation rotation(samples, options.RandomSeed);
  for (int f : levels)
  {
    std::vector<double> work = workOfLevels(samples, options, f);
    work.push_back(rest);
    steps.replan(work);
    Steps preparing(steps.next(), { 25.0, 700.0, 65.0, 620.0 }); // for each neuron
    {
      Mesh finer = makeGeodesicSphere(f, preparing.next());
      const Run resampling = preparing.next();
      result.Positions = f == levels.front() ? finer.Positions
                                             : resample(result.SpherePositions, result.Positions,
                                                 result.Triangles, finer.Positions, resampling);
      result.SpherePositions = std::move(finer.Positions);
      result.Triangles = std::move(finer.Triangles);
    }
    preparing.next();
    const Points& positions = result.SpherePositions;
    const Triangles& triangles = result.Triangles;
    const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
    TriangleTree surface(result.Positions, triangles, preparing.next());
    std::vector<double> masses(triangles.rows(), 0.0);
    const CornerShares sharesOf(options.ReferencePoint, positions, result.Positions, triangles);

    const Run level = steps.next();
    const double passes = options.PassesPerLevel;
    for (int pass = 0; pass < options.PassesPerLevel; ++pass)
    {
      const Run passing = level.part(pass / passes, (pass + 1) / passes);
      rotation.turn(options.SamplesPerNeuron * positions.rows());
      FixedPointSums sums(4 * positions.rows());
      FixedPointSums errors(1);
      TypicalSquare typical;
      forEachFoot(
        samples, surface, rotation.count(), [&](Index i) { return rotation.id(i); },
        [&](Index i, const Vector3& x, const FootPoint& foot)
        {
          errors.add(0, foot.SquareDistance);
          typical.add(foot.SquareDistance);
          const double weight = samples.weight(rotation.id(i));
          const Vector3 corners = sharesOf(foot);
          for (int k = 0; k < 3; ++k)
          {
            const double share = weight * corners[k];
            const Index neuron = 4 * Index(triangles(foot.Triangle, k));
            sums.add(neuron, share);
            for (int c = 0; c < 3; ++c)
            {
              sums.add(neuron + 1 + c, share * x[c]);
            }
          }
        },
        passing.part(0.0, 0.9));
      sums.reduce(samples.reduce());
      errors.reduce(samples.reduce());
      const double count = static_cast<double>(rotation.totalCount());
      Shares shares(positions.rows(), 4);
      for (Index i = 0; i < shares.size(); ++i)
      {
        shares.data()[i] = sums[i];
      }
      if (pass + 1 == options.PassesPerLevel)
      {
        masses = massesOf(shares, triangles, neighbors);
      }
      const int diffusions =
        std::max(1, WidestDiffusion - pass * WidestDiffusion / options.PassesPerLevel);
      for (int step = 0; step < diffusions; ++step)
      {
        diffuse(neighbors, shares, run);
        passing.report(0.9);
      }
      const Points moved = means(shares, neighbors, result.Positions, run);

      TrainingRecord record;
      record.Frequency = f;
      record.NeighborhoodRadius = diffusionRadius(diffusions, triangles.rows());
      record.LearningRate = 1.0;
      record.MeanSquareError = errors[0] / count;
      record.MeanDisplacement = (moved - result.Positions).rowwise().norm().mean();
      result.History.push_back(record);
      result.Positions = moved;
      surface.refit(result.Positions, triangles, run);
      typicalErrors[1] = typical.mean(samples.reduce(), rotation.totalCount());
    }
    if (f != levels.front() && options.PassesPerLevel > 0)
    {
      result.NoiseToDetail = noiseToDetail(typicalErrors[0], typicalErrors[1]);
      result.Noise = std::sqrt(noiseVariance(typicalErrors[0], typicalErrors[1]));
    }
    typicalErrors[0] = typicalErrors[1];
    const std::optional<double> left = forecast(result, masses);
    if (!left)
    {
      break;
    }
    rest = *left;
  }
  return result;
}

/// The polish, and how much of the surface then has no patterns.
void polishAndCheck(const TrainingSamples& samples, const PolishOptions& options,
  ConformalSOMResult& result, const Run& run)
{
  Steps steps(run, { 0.97, 0.03 });
  const double before = surfaceArea(result.Positions, result.Triangles);
  const std::vector<double> masses = polish(samples, options, result, steps.next());
  steps.next();
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / before;
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
}

double stretchedFraction(const ConformalSOMResult& result)
{
  return obtuseFraction(result.Positions, result.Triangles);
}

/// Smaller webs are not worth another start; nor are fewer stretched triangles.
constexpr double ToleratedArea = 0.001, ToleratedTriangles = 0.2;

/// Whether a level's mesh, with the patterns in each of its triangles, will not do when it is
/// polished. It has most of the webs and stretched triangles that there will be at the end; the
/// polish adds a quarter to those, measured.
constexpr double ByPolish = 1.25;

bool needsHull(const ConformalSOMResult& result, const std::vector<double>& masses,
  const TrainingSamples& samples)
{
  return ByPolish * stretchedFraction(result) > ToleratedTriangles ||
    unsupportedFraction(samples, result.Positions, result.Triangles, masses) > ToleratedArea;
}

/// What is kept of the progress for a hull that may be needed after all, as a share of the work
/// from the sphere. Whether it is shows for certain only when all of that has been done, which is
/// the smaller part of the work if it is: a fifth, mostly.
///
/// But a level's mesh tells mostly. Where it is close to the limit, so much is kept that progress
/// is even within a factor of 3 either way.
double hullReserve(const ConformalSOMResult& result, const std::vector<double>& masses,
  const TrainingSamples& samples, double ofSphere, double ofHull)
{
  constexpr double closeToLimit = 0.65, ifUnlikely = 0.12, ifPossible = 0.43;
  if (needsHull(result, masses, samples))
  {
    return ofHull;
  }
  const double stretched = ByPolish * stretchedFraction(result) / ToleratedTriangles;
  return std::min(ofHull, ofSphere * (stretched > closeToLimit ? ifPossible : ifUnlikely));
}

/// A hull or mesh is near all of the surface, and at first at one distance.
constexpr double OutlierRatioFromSurface = 4.0;

constexpr double SmoothnessFromMesh = 0.05; ///< at first: nothing is rough

ConformalSOMResult placedNetwork(int frequency, const NeuronPlaces& place, const Run& run)
{
  ConformalSOMResult result;
  Mesh network = makeGeodesicSphere(frequency, run.unwatched());
  result.Positions = place(network.Positions);
  result.SpherePositions = std::move(network.Positions);
  result.Triangles = std::move(network.Triangles);
  return result;
}

/// From a start that is rough, from smooth to fine.
/// @param[in] hull  what the weights come from; may be null
ConformalSOMResult polishFrom(Points weights, double noise, const HullStart* hull,
  const TrainingSamples& samples, const ConformalSOMOptions& options, const Run& run)
{
  ConformalSOMResult result;
  Mesh network = makeGeodesicSphere(options.Frequency, run.unwatched());
  result.SpherePositions = std::move(network.Positions);
  result.Triangles = std::move(network.Triangles);
  result.Positions = std::move(weights);
  result.NoiseToDetail = noise;
  PolishOptions polish = polishFor(options, noise);
  polish.NumberOfRounds *= 2;
  polish.Evenness = 1.0;
  polish.OutlierRatio = OutlierRatioFromSurface;
  polish.FirstSmoothness = std::max(polish.LastSmoothness, 0.2);
  if (hull)
  {
    polish.Belongs = [=](const Vector3& x) { return hull->Data.contains(x); };
    polish.Guide = hull->Guide;
  }
  polishAndCheck(samples, polish, result, run);
  return result;
}
}

ConformalSOMResult trainBatchFrom(Points weights, const TrainingSamples& samples,
  const ConformalSOMOptions& options, const Run& run)
{
  return polishFrom(std::move(weights), 0.0, nullptr, samples, options, run);
}

ConformalSOMResult trainBatchFromMesh(const NeuronPlaces& place, const TrainingSamples& samples,
  const ConformalSOMOptions& options, std::shared_ptr<const TriangleTree> mesh, const Run& run)
{
  // Half of the rounds tell how much noise there is, beside those of a lattice of half the
  // frequency; the others smooth it.
  PolishOptions polishing = polishFor(options, 0.0);
  polishing.Guide = std::move(mesh);
  polishing.Evenness = 1.0;
  polishing.OutlierRatio = OutlierRatioFromSurface;
  polishing.FirstSmoothness = std::max(polishing.LastSmoothness, SmoothnessFromMesh);
  const int rounds = polishing.NumberOfRounds;
  polishing.NumberOfRounds = rounds / 2;
  const double half = workOfPolish(samples, polishing, geodesicSphereSize(options.Frequency));
  Steps steps(run, { 0.35 * half, half, 0.1 * half, half });

  double errors[2] = {}; // of the coarser lattice and of this one
  double areaAtFirst = 0.0;
  const bool measures = polishing.NumberOfRounds > 0 && options.Frequency / 2 >= CoarsestFrequency;
  const auto polished = [&](int frequency, Index patterns)
  {
    ConformalSOMResult result = placedNetwork(frequency, place, run);
    areaAtFirst = surfaceArea(result.Positions, result.Triangles);
    polishing.SamplesPerRound = patterns;
    polish(samples, polishing, result, steps.next());
    return result;
  };
  const auto error = [&](const ConformalSOMResult& result)
  {
    return typicalSquareError(
      samples, result.Positions, result.Triangles, polishing.SamplesPerRound, run.unwatched());
  };
  const Index patterns = polishing.SamplesPerRound;
  if (measures)
  {
    errors[0] = error(polished(options.Frequency / 2, patterns / 4));
  }
  else
  {
    steps.next();
  }
  ConformalSOMResult result = polished(options.Frequency, patterns);
  steps.next();
  if (measures)
  {
    errors[1] = error(result);
    result.NoiseToDetail = noiseToDetail(errors[0], errors[1]);
    result.Noise = std::sqrt(noiseVariance(errors[0], errors[1]));
  }
  PolishOptions last = polishFor(options, result.NoiseToDetail);
  last.NumberOfRounds = rounds - rounds / 2;
  last.Guide = polishing.Guide;
  last.Evenness = polishing.Evenness;
  last.OutlierRatio = polishing.OutlierRatio;
  polishAndCheck(samples, last, result, steps.next());
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / areaAtFirst;
  return result;
}

std::optional<ConformalSOMResult> learnWithoutPolish(
  const TrainingSamples& samples, const ConformalSOMOptions& options, const Run& run)
{
  const bool anyway = options.StartingShape == StartingShape::Sphere;
  bool good = true;
  Steps steps(run, {});
  ConformalSOMResult result = learnFromSphere(
    samples, options, run, 0.0,
    [&](const ConformalSOMResult& level, const std::vector<double>& masses) -> std::optional<double>
    {
      good = anyway || !needsHull(level, masses, samples);
      return good ? std::optional<double>(0.0) : std::nullopt;
    },
    steps);
  return good ? std::optional<ConformalSOMResult>(std::move(result)) : std::nullopt;
}

double workWithoutPolish(const TrainingSamples& samples, const ConformalSOMOptions& options)
{
  const std::vector<double> levels = workOfLevels(samples, options, 1);
  return std::accumulate(levels.begin(), levels.end(), 0.0);
}

ConformalSOMResult trainBatch(
  const TrainingSamples& samples, const ConformalSOMOptions& options, const Run& run)
{
  const bool mayHull = options.StartingShape != StartingShape::Sphere && samples.dimension() == 3;
  const bool mustHull = mayHull && options.StartingShape == StartingShape::Hull;
  PolishOptions polishing = polishFor(options, 0.0);
  const auto neurons = geodesicSphereSize(options.Frequency);
  const double ownPolish = workOfPolish(samples, polishing, neurons);
  polishing.NumberOfRounds *= 2;
  const double ofHull = workOfHullStart(samples, options.HullIndicator);
  const double hullPolish = workOfPolish(samples, polishing, neurons);
  ConformalSOMResult fromSphere;
  Steps steps(run, {});
  if (!mustHull)
  {
    const std::vector<double> levels = workOfLevels(samples, options, 1);
    const double ofSphere = std::accumulate(levels.begin(), levels.end(), ownPolish);
    const double hulling = ofHull + hullPolish;
    double reserve = mayHull ? std::sqrt(ofSphere * (ofSphere + hulling)) - ofSphere : 0.0;
    fromSphere = learnFromSphere(
      samples, options, run, ownPolish + reserve,
      [&](const ConformalSOMResult& result, const std::vector<double>& masses)
      {
        reserve = mayHull ? hullReserve(result, masses, samples, ofSphere, hulling) : 0.0;
        return ownPolish + reserve;
      },
      steps);
    steps.replan({ ownPolish, reserve });
    polishAndCheck(samples, polishFor(options, fromSphere.NoiseToDetail), fromSphere, steps.next());
  }
  const bool webs = fromSphere.UnsupportedFraction > ToleratedArea;
  if (!mayHull || (!mustHull && !webs && stretchedFraction(fromSphere) <= ToleratedTriangles))
  {
    return fromSphere;
  }
  steps.replan({ ofHull, hullPolish });
  const std::optional<HullStart> start =
    startFromHull(samples, makeGeodesicSphere(options.Frequency, run.unwatched()).Positions,
      options.HullIndicator, steps.next());
  if (!start && mustHull)
  {
    throw std::runtime_error(
      "the hull of the points winds too much to be mapped to the sphere, as "
      "those of long thin curves do: let StartingShape be Sphere or Automatic");
  }
  if (!start)
  {
    return fromSphere;
  }
  ConformalSOMResult fromHull =
    polishFrom(start->Positions, fromSphere.NoiseToDetail, &*start, samples, options, steps.next());
  fromHull.History.insert(
    fromHull.History.begin(), fromSphere.History.begin(), fromSphere.History.end());
  fromHull.Hulled = true;
  fromHull.Noise = fromSphere.Noise;
  fromHull.Indicator = start->Indicator;
  fromHull.NormalsUsed = start->NormalsUsed;
  fromHull.NumberOfStarts = mustHull ? 1 : 2;
  fromHull.HullLeaks = start->Leaks;
  fromHull.CutFraction = start->CutFraction;
  fromHull.NumberOfSamplesOutside = start->NumberOfSamplesOutside;

  // Where there was no web to be rid of, the hull has to be worth it.
  const bool clean = !start->Leaks && fromHull.UnsupportedFraction <= ToleratedArea &&
    stretchedFraction(fromHull) < stretchedFraction(fromSphere) &&
    fromHull.History.back().MeanSquareError <= 2.0 * fromSphere.History.back().MeanSquareError;
  return mustHull || webs || clean ? fromHull : fromSphere;
}
}
