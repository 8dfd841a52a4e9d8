#include "Learn/Batch/BatchTraining.h"

#include "Base/FixedPointSums.h"
#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
#include "Learn/Batch/NetworkDiffusion.h"
#include "Learn/Fit/LeastSquaresFit.h"
#include "Learn/Fit/NoiseEstimate.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"
#include "Sphere/Resampling.h"
#include "TriangleMap/NetworkShapes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr int CoarsestFrequency = 4;
// Smoothness of the fit for noise, in units of the squared ratio of noise to detail. Measured on
// the scan Igea with Gaussian noise of 0.005: for a ratio of 6, a smoothness of 1 is best.
constexpr double SmoothnessForNoise = 0.03, LittleNoise = 0.5;

/// Evenness of the fit. Training already makes the triangles even, so the value hardly affects the
/// fit.
constexpr double Evenness = 3.0;

/// For each neuron, the total weight C of its patterns, then the weighted sum S of its patterns.
using Shares = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Return the neighborhood radius sigma on the unit sphere for a number of diffusion steps. The
/// variance of a step in one direction is a quarter of the squared edge length. Here half of the
/// sums moves by one edge, in two dimensions.
double diffusionRadius(int steps, Index triangles)
{
  const double area = 4.0 * Pi / static_cast<double>(triangles);
  const double squareEdge = 4.0 / std::sqrt(3.0) * area;
  return std::sqrt(0.25 * steps * squareEdge);
}

/// Compute S / C for each neuron. A neuron without patterns gets the mean of its neighbors.
Points means(
  const Shares& shares, const Adjacency& neighbors, const Points& weights, const Run& run)
{
  const double negligible = NegligibleShare * shares.col(0).mean();
  Points moved(weights.rows(), 3);
  forBlocks(run, moved.rows(), LightBlock,
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

/// Estimate the weight of the patterns in each triangle. The weight of each neuron is distributed
/// equally to the triangles around the neuron.
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

/// Fractions in which a pattern is divided among the corners of the triangle that contains its
/// projection. The fractions are the barycentric weights of the pattern's reference point.
class CornerShares
{
public:
  /// @param[in] model  weight vectors of the neurons, which may change later
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

/// Divide the progress between the networks, in proportion to their numbers of neurons. A fifth of
/// each part is for the preparation of the network.
Steps stepsOf(const std::vector<int>& levels, const Run& run)
{
  std::vector<double> shares;
  for (int f : levels)
  {
    const auto neurons = static_cast<double>(geodesicSphereSize(f));
    shares.insert(shares.end(), { 0.2 * neurons, 0.8 * neurons });
  }
  return { run, shares };
}

/// Replace the network by a geodesic sphere of a given frequency. Weight vectors are interpolated.
void refine(FittedMesh& network, int frequency, bool isFirst, const Run& run)
{
  Mesh finer = makeGeodesicSphere(frequency, run.part(0.0, 0.2));
  const Run resampling = run.part(0.2, 1.0);
  network.Positions = isFirst ? finer.Positions
                              : resample(network.SpherePositions, network.Positions,
                                  network.Triangles, finer.Positions, resampling);
  network.SpherePositions = std::move(finer.Positions);
  network.Triangles = std::move(finer.Triangles);
}

/// Sums over all samples of a pass.
struct PassResult
{
  conformal::Shares Shares;
  double SumOfSquareErrors = 0.0, TypicalSquareError = 0.0;
};

/// Training of one network, in several passes.
class TrainedLevel
{
public:
  TrainedLevel(const TrainingSamples& samples, const BatchTrainingOptions& options,
    SampleRotation& rotation, FittedMesh& network, const Run& run)
    : Samples(samples)
    , Options(options)
    , Rotation(rotation)
    , Network(network)
    , Neighbors(vertexNeighbors(network.Triangles, network.SpherePositions.rows()))
    , Surface(network.Positions, network.Triangles, run)
    , SharesOf(
        options.ReferencePoint, network.SpherePositions, network.Positions, network.Triangles)
  {
  }

  /// Move each neuron to the mean of its samples in one pass, and append a record of the pass.
  /// @return typical square error before the neurons were moved
  double pass(int number, int frequency, const Run& run)
  {
    PassResult found = this->shareOut(run.part(0.0, 0.9));
    if (number + 1 == this->Options.PassesPerLevel)
    {
      this->Masses = massesOf(found.Shares, this->Network.Triangles, this->Neighbors);
    }
    const int diffusions = diffusionsOf(number, this->Options.PassesPerLevel);
    for (int step = 0; step < diffusions; ++step)
    {
      diffuse(this->Neighbors, found.Shares, run);
      run.report(0.9);
    }
    Points& positions = this->Network.Positions;
    const Points moved = means(found.Shares, this->Neighbors, positions, run);

    TrainingRecord record;
    record.Frequency = frequency;
    record.NeighborhoodRadius = diffusionRadius(diffusions, this->Network.Triangles.rows());
    record.LearningRate = 1.0;
    record.MeanSquareError =
      found.SumOfSquareErrors / static_cast<double>(this->Rotation.totalCount());
    record.MeanDisplacement = (moved - positions).rowwise().norm().mean();
    this->Network.History.push_back(record);
    positions = moved;
    this->Surface.refit(positions, run);
    return found.TypicalSquareError;
  }

  /// Return the weight of the patterns in each triangle in the last pass, or 0 without a pass.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  /// Distribute the next samples to the corners of the triangles that contain their projections.
  PassResult shareOut(const Run& run)
  {
    const Index neurons = this->Network.SpherePositions.rows();
    this->Rotation.turn(this->Options.SamplesPerNeuron * neurons);
    FixedPointSums sums(4 * neurons);
    FixedPointSums errors(1);
    TypicalSquare typical;
    forEachFoot(
      this->Samples, this->Surface, this->Rotation.count(),
      [&](Index i) { return this->Rotation.id(i); },
      [&](Index i, const Vector3& x, const FootPoint& foot)
      {
        errors.add(0, foot.SquareDistance);
        typical.add(foot.SquareDistance);
        const double weight = this->Samples.weight(this->Rotation.id(i));
        const Vector3 corners = this->SharesOf(foot);
        for (int k = 0; k < 3; ++k)
        {
          const double share = weight * corners[k];
          const Index neuron = 4 * Index(this->Network.Triangles(foot.Triangle, k));
          sums.add(neuron, share);
          for (int c = 0; c < 3; ++c)
          {
            sums.add(neuron + 1 + c, share * x[c]);
          }
        }
      },
      run);
    sums.reduce(this->Samples.reduce());
    errors.reduce(this->Samples.reduce());
    PassResult result;
    result.Shares.resize(neurons, 4);
    for (Index i = 0; i < result.Shares.size(); ++i)
    {
      result.Shares.data()[i] = sums[i];
    }
    result.SumOfSquareErrors = errors[0];
    result.TypicalSquareError = typical.mean(this->Samples.reduce(), this->Rotation.totalCount());
    return result;
  }

  const TrainingSamples& Samples;
  const BatchTrainingOptions& Options;
  SampleRotation& Rotation;
  FittedMesh& Network;
  Adjacency Neighbors;
  TriangleTree Surface;
  CornerShares SharesOf;
  std::vector<double> Masses = std::vector<double>(Network.Triangles.rows(), 0.0);
};
}

FittedMesh learnFromSphere(const TrainingSamples& samples, const BatchTrainingOptions& options,
  const LevelTest& goesOn, const Run& run)
{
  const std::vector<int> levels = levelsOf(options.Frequency, CoarsestFrequency);
  FittedMesh result;
  // Typical errors of the last pass on the coarser network, and of the last pass on this network.
  double typicalErrors[2] = {};
  SampleRotation rotation(samples, options.RandomSeed);
  Steps steps = stepsOf(levels, run);
  for (int f : levels)
  {
    const bool isFirst = f == levels.front();
    const Run preparing = steps.next();
    refine(result, f, isFirst, preparing.part(0.0, 0.5));
    TrainedLevel level(samples, options, rotation, result, preparing.part(0.5, 1.0));
    const Run passing = steps.next();
    const double passes = options.PassesPerLevel;
    for (int pass = 0; pass < options.PassesPerLevel; ++pass)
    {
      typicalErrors[1] = level.pass(pass, f, passing.part(pass / passes, (pass + 1) / passes));
    }
    if (!isFirst && options.PassesPerLevel > 0)
    {
      result.NoiseToDetail = noiseToDetail(typicalErrors[0], typicalErrors[1]);
      result.Noise = std::sqrt(noiseVariance(typicalErrors[0], typicalErrors[1]));
    }
    typicalErrors[0] = typicalErrors[1];
    if (options.Observer)
    {
      options.Observer("level " + std::to_string(f), result);
    }
    if (goesOn && !goesOn(result, level.masses()))
    {
      throw NumericalFailure("learning was stopped after a level of the network");
    }
  }
  return result;
}

FittedMesh trainBatch(
  const TrainingSamples& samples, const BatchTrainingOptions& options, const Run& run)
{
  Steps steps(run, { 0.3, 0.68, 0.02 }); // progress: learning, fit, support
  FittedMesh result = learnFromSphere(samples, options, nullptr, steps.next());
  const double noise = result.NoiseToDetail;
  LeastSquaresFitOptions fit;
  fit.Iterations = options.Fit.Iterations;
  // With more noise, the fit is smoother. Distant samples are then noise, not limb ends.
  fit.LastSmoothness =
    options.Fit.Smoothness * (FitOptions::UsualSmoothness + SmoothnessForNoise * noise * noise);
  fit.FirstSmoothness = fit.LastSmoothness;
  fit.Evenness = Evenness;
  fit.AutomaticPriority = options.Fit.AutomaticPriority && noise < LittleNoise;
  fit.SamplesPerIteration = options.SamplesPerNeuron * result.Positions.rows();
  fit.RandomSeed = options.RandomSeed;
  const double areaAtFirst = surfaceArea(result.Positions, result.Triangles);
  const std::vector<double> masses = leastSquaresFit(samples, fit, result, steps.next());
  if (options.Observer)
  {
    options.Observer("fit", result);
  }
  steps.next();
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / areaAtFirst;
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
  return result;
}
}
