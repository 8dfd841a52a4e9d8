#include "Learn/Batch/BatchTraining.h"

#include "Base/FixedPointSums.h"
#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
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
constexpr Index BlockSize = 1024;
// Measured on Igea with Gaussian noise of 0.005: noise 6, best smoothness 1.
constexpr double SmoothnessForNoise = 0.03, LittleNoise = 0.5;

/// Learning spreads the network evenly, so that more evenness hardly affects the fit.
constexpr double Evenness = 3.0;

constexpr int WidestDiffusion = 5; ///< steps over the network in the first pass of a level

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

/// For each neuron, the mass C of its patterns, then their sum S.
using Shares = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Diffuse by one step: every neuron keeps half and distributes half equally to its neighbors.
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

/// Return the radius sigma on the unit sphere of a number of diffusion steps. The variance of a
/// step in one direction is a quarter of the square edge length, half of the neighbors' share.
double diffusionRadius(int steps, Index triangles)
{
  const double area = 4.0 * Pi / static_cast<double>(triangles);
  const double squareEdge = 4.0 / std::sqrt(3.0) * area;
  return std::sqrt(0.25 * steps * squareEdge);
}

/// Compute S / C. A neuron without patterns follows its neighbors.
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

/// Estimate the mass of patterns in each triangle: the mass of each neuron is distributed to its
/// triangles.
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

/// Shares of a pattern for the corners of the triangle of its projection: the barycentric weights
/// of its reference point.
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

/// Levels have progress in proportion to their numbers of neurons; a fifth of each is for its
/// preparation.
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

/// Replace the network by a geodesic sphere of a frequency, with the weights interpolated.
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

/// Sums of a pass over the samples.
struct PassResult
{
  conformal::Shares Shares;
  double SumOfSquareErrors = 0.0, TypicalSquareError = 0.0;
};

/// Passes of one level, all on one network.
class Level
{
public:
  Level(const TrainingSamples& samples, const BatchTrainingOptions& options,
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

  /// Move the network by the means of the samples of a pass, and record it.
  /// @return typical square error before the move
  double pass(int number, int frequency, const Run& run)
  {
    PassResult found = this->shareOut(run.part(0.0, 0.9));
    if (number + 1 == this->Options.PassesPerLevel)
    {
      this->Masses = massesOf(found.Shares, this->Network.Triangles, this->Neighbors);
    }
    const int diffusions =
      std::max(1, WidestDiffusion - number * WidestDiffusion / this->Options.PassesPerLevel);
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
    this->Surface.refit(positions, this->Network.Triangles, run);
    return found.TypicalSquareError;
  }

  /// Masses of the triangles in the last pass; 0 without one.
  const std::vector<double>& masses() const { return this->Masses; }

private:
  /// Distribute the next samples to the corners of the triangles of their projections.
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
  const std::vector<int> levels = frequencies(options.Frequency);
  FittedMesh result;
  double typicalErrors[2] = {}; // of the last passes of the coarser network and of this one
  SampleRotation rotation(samples, options.RandomSeed);
  Steps steps = stepsOf(levels, run);
  for (int f : levels)
  {
    const bool isFirst = f == levels.front();
    const Run preparing = steps.next();
    refine(result, f, isFirst, preparing.part(0.0, 0.5));
    Level level(samples, options, rotation, result, preparing.part(0.5, 1.0));
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
  Steps steps(run, { 0.3, 0.68, 0.02 }); // learning, fit, support
  FittedMesh result = learnFromSphere(samples, options, nullptr, steps.next());
  const double noise = result.NoiseToDetail;
  LeastSquaresFitOptions fit;
  fit.Iterations = options.Fit.Iterations;
  // Increase the smoothness with the noise; distant samples are then noise, not limb ends.
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
