#include "Learn/Batch/BatchTraining.h"

#include "Base/FixedPointSums.h"
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
#include <optional>
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

/// Learning leaves the network well spread, and evening it further costs little fit.
constexpr double Evenness = 3.0;

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
/// Levels share the time by their numbers of neurons; a fifth of each prepares the level.
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
}

std::optional<FittedMesh> learnFromSphere(const TrainingSamples& samples,
  const BatchTrainingOptions& options, const LevelTest& goesOn, const Run& run)
{
  const std::vector<int> levels = frequencies(options.Frequency);
  FittedMesh result;
  double typicalErrors[2] = {}; // of the last passes of the coarser lattice and of this one
  SampleRotation rotation(samples, options.RandomSeed);
  Steps steps = stepsOf(levels, run);
  for (int f : levels)
  {
    const Run preparing = steps.next();
    {
      Mesh finer = makeGeodesicSphere(f, preparing.part(0.0, 0.1));
      const Run resampling = preparing.part(0.1, 0.5);
      result.Positions = f == levels.front() ? finer.Positions
                                             : resample(result.SpherePositions, result.Positions,
                                                 result.Triangles, finer.Positions, resampling);
      result.SpherePositions = std::move(finer.Positions);
      result.Triangles = std::move(finer.Triangles);
    }
    const Points& positions = result.SpherePositions;
    const Triangles& triangles = result.Triangles;
    const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
    TriangleTree surface(result.Positions, triangles, preparing.part(0.5, 1.0));
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
    if (goesOn && !goesOn(result, masses))
    {
      return std::nullopt;
    }
  }
  return result;
}

FittedMesh trainBatch(
  const TrainingSamples& samples, const BatchTrainingOptions& options, const Run& run)
{
  Steps steps(run, { 0.3, 0.68, 0.02 }); // learning, fit, support
  FittedMesh result = *learnFromSphere(samples, options, nullptr, steps.next());
  const double noise = result.NoiseToDetail;
  LeastSquaresFitOptions fit;
  fit.Iterations = options.Fit.Iterations;
  // The more noise, the smoother; far samples are noise then, not tips.
  fit.LastSmoothness =
    options.Fit.Smoothness * (FitOptions::UsualSmoothness + SmoothnessForNoise * noise * noise);
  fit.FirstSmoothness = fit.LastSmoothness;
  fit.Evenness = Evenness;
  fit.AutomaticPriority = options.Fit.AutomaticPriority && noise < LittleNoise;
  fit.SamplesPerIteration = options.SamplesPerNeuron * result.Positions.rows();
  fit.RandomSeed = options.RandomSeed;
  const double areaAtFirst = surfaceArea(result.Positions, result.Triangles);
  const std::vector<double> masses = leastSquaresFit(samples, fit, result, steps.next());
  steps.next();
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / areaAtFirst;
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
  return result;
}
}
