#include "Learn/Online/OnlineTraining.h"

#include "Base/Random.h"
#include "Learn/Online/NeuronBlocks.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleInSpace.h"
#include "Search/TriangleTree.h"
#include "TriangleMap/NetworkShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace conformal
{
namespace
{
/// Draw patterns, as in step 2 of \cite Liou2008, with equal probability. After drawByPriority(),
/// the probability is proportional to the priority. All ranks draw the same patterns, although each
/// pattern is stored on a single rank.
class Sampler
{
public:
  Sampler(const TrainingSamples& samples, unsigned int seed)
    : Samples(samples)
    , Numbers(seed)
  {
    if (samples.weighted())
    {
      // Priorities are summed as integers, so that the result is equal for any distribution of
      // points over ranks.
      std::int64_t sum = 0;
      this->Cumulative.resize(samples.size());
      for (Index i = 0; i < samples.size(); ++i)
      {
        this->Cumulative[i] = sum += std::llround(samples.weight(i) * Unit);
      }
      this->OfAll = shareOf(samples.reduce(), sum);
    }
  }

  /// From the next pattern on, draw patterns with probabilities proportional to their priorities.
  void drawByPriority() { this->ByPriority = this->Samples.weighted(); }

  /// Return the next `count` patterns, 3 + D by #count: coordinates and pattern values.
  Columns next(Index count)
  {
    const Index values = this->Samples.numberOfPatternValues(), size = 3 + values;
    Columns patterns(size, count);
    std::vector<std::int64_t> bits(patterns.size(), 0);
    for (Index i = 0; i < count; ++i)
    {
      const Index id = this->draw();
      if (id >= 0 && id < this->Samples.size())
      {
        const Vector3 x = this->Samples[id];
        std::memcpy(bits.data() + size * i, x.data(), sizeof(x));
        if (values > 0)
        {
          std::memcpy(
            bits.data() + size * i + 3, this->Samples.patternValues(id), values * sizeof(double));
        }
      }
    }
    this->Samples.reduce().sum(bits.data(), static_cast<Index>(bits.size()));
    std::memcpy(patterns.data(), bits.data(), bits.size() * sizeof(double));
    return patterns;
  }

private:
  /// Draw a pattern. If this rank has the pattern, return its id, else an id out of range.
  Index draw()
  {
    if (!this->ByPriority)
    {
      return this->Numbers.index(this->Samples.totalSize()) - this->Samples.firstOfTotal();
    }
    const auto target =
      static_cast<std::int64_t>(this->Numbers.uniform() * static_cast<double>(this->OfAll.Total)) -
      this->OfAll.Before;
    const auto found = std::upper_bound(this->Cumulative.begin(), this->Cumulative.end(), target);
    return target < 0 ? -1 : static_cast<Index>(found - this->Cumulative.begin());
  }

  static constexpr double Unit = 0x1p32;
  const TrainingSamples& Samples;
  Random Numbers;
  bool ByPriority = false;
  std::vector<std::int64_t> Cumulative; ///< cumulative priorities of the patterns of this rank
  Share OfAll;                          ///< sums of the priorities on lower ranks, and on all ranks
};

bool hasLowerNeurons(const Triangles& triangles, int triangle, int than)
{
  const auto sorted = [&](int r)
  {
    std::array<int, 3> ids = { triangles(r, 0), triangles(r, 1), triangles(r, 2) };
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  return sorted(triangle) < sorted(than);
}

/// Project a pattern onto the model, and find its image on the network, as in step 3 of
/// \cite Liou2008. The model is the mesh of the weight vectors.
class ImageOnNetwork
{
public:
  /// @param[in] neurons  neurons whose weight vectors may change later
  /// @param[in] numberOfValues  number of further dimensions of patterns and weight vectors
  ImageOnNetwork(const Mesh& network, const NeuronBlocks& neurons, ReferencePoint reference,
    Index numberOfValues)
    : Network(network)
    , Neurons(neurons)
    , NumberOfValues(numberOfValues)
    , Reference(reference)
    , Around(vertexTriangles(network.Triangles, network.Positions.rows()))
    , Shapes(network.Positions, network.Triangles)
  {
  }

  /// Find the triangle around the winner that contains the projection of x. If the projection is on
  /// an edge or corner, several triangles contain it. Each of these triangles has a different image
  /// of the projection. Therefore, the triangle with the lowest neuron ids is selected.
  /// @param[in] x  pattern: coordinates and pattern values
  FootPoint project(const double* x, int winner) const
  {
    constexpr double rounding = 4e-15; // rounding error of coordinates
    FootPoint best;
    for (const int* r = this->Around.begin(winner); r != this->Around.end(winner); ++r)
    {
      const TriangleInSpace simplex = this->simplexOf(*r, x);
      FootPoint foot = closestPointOfTriangle(simplex.X, simplex.A, simplex.B, simplex.C);
      foot.Triangle = *r;
      const double nearer = foot.SquareDistance - best.SquareDistance;
      const bool shared = std::abs(nearer) <= rounding * std::sqrt(foot.SquareDistance);
      if (shared ? hasLowerNeurons(this->Network.Triangles, *r, best.Triangle) : nearer < 0.0)
      {
        best = foot;
      }
    }
    return best;
  }

  /// Return the reference point on the unit sphere: the position of the winner, or the image of the
  /// projection.
  /// @param[in] x  pattern: coordinates and pattern values
  Vector3 referencePoint(const double* x, const FootPoint& foot, int winner) const
  {
    const Points& positions = this->Network.Positions;
    if (this->Reference == ReferencePoint::Winner)
    {
      return positions.row(winner);
    }
    const auto ids = this->Network.Triangles.row(foot.Triangle);
    Vector3 image = foot.Barycentric;
    if (this->Reference != ReferencePoint::Affine)
    {
      const TriangleInSpace simplex = this->simplexOf(foot.Triangle, x);
      image = this->Shapes.toNetwork(
        foot.Triangle, TriangleShape(simplex.A, simplex.B, simplex.C), foot.Barycentric);
    }
    Vector3 r = image[0] * Vector3(positions.row(ids[0])) +
      image[1] * Vector3(positions.row(ids[1])) + image[2] * Vector3(positions.row(ids[2]));
    r.normalize(); // |r| = |n_i| = 1, as the paper allows
    return r;
  }

private:
  /// Return the simplex of a triangle and a pattern. In more than three dimensions, return an
  /// isometric copy: projections and angles are those of all dimensions.
  TriangleInSpace simplexOf(int triangle, const double* x) const
  {
    const auto ids = this->Network.Triangles.row(triangle);
    if (this->NumberOfValues == 0)
    {
      return { Vector3(x), this->Neurons.weight(ids[0]), this->Neurons.weight(ids[1]),
        this->Neurons.weight(ids[2]) };
    }
    const Eigen::VectorXd a = this->Neurons.fullWeight(ids[0]),
                          b = this->Neurons.fullWeight(ids[1]),
                          c = this->Neurons.fullWeight(ids[2]);
    return toSpace(x, a.data(), b.data(), c.data(), a.size());
  }

  const Mesh& Network;
  const NeuronBlocks& Neurons;
  const Index NumberOfValues;
  const ReferencePoint Reference;
  const Adjacency Around;
  const NetworkShapes Shapes;
};
}

LearnedMesh trainOnline(const TrainingSamples& samples, const Mesh& network, const Points& start,
  const OnlineTrainingOptions& options, const Run& run)
{
  const Index numberOfValues = samples.numberOfPatternValues();
  NeuronBlocks neurons(network.Positions, start, numberOfValues); // step 1
  Sampler sampler(samples, options.RandomSeed);
  const ImageOnNetwork image(network, neurons, options.ReferencePoint, numberOfValues);

  LearnedMesh result;
  result.Triangles = network.Triangles;
  result.SpherePositions = network.Positions;
  Points before = start;
  constexpr int maximumBetweenReports = 4096; // number of steps that last some milliseconds
  const int reportEvery = std::clamp(options.SamplesPerEpoch / 16, 1, maximumBetweenReports);
  for (int t = 0; t < options.NumberOfEpochs; ++t)
  {
    TrainingRecord record;
    record.Frequency = options.Frequency;
    record.NeighborhoodRadius =
      options.InitialNeighborhoodRadius * std::exp(-t / options.NeighborhoodTimeConstant);
    record.LearningRate =
      options.InitialLearningRate * std::exp(-t / options.LearningRateTimeConstant);
    if (2 * (t + 1) > options.NumberOfEpochs)
    {
      sampler.drawByPriority();
    }
    Columns patterns;
    for (int step = 0; step < options.SamplesPerEpoch; ++step)
    {
      if (step % reportEvery == 0)
      {
        run.report(
          (t + static_cast<double>(step) / options.SamplesPerEpoch) / options.NumberOfEpochs);
      }
      constexpr int AtATime = 8192;
      if (step % AtATime == 0)
      {
        patterns = sampler.next(std::min(AtATime, options.SamplesPerEpoch - step));
      }
      const double* pattern = patterns.data() + (step % AtATime) * patterns.rows();
      const Vector3 x(pattern);
      const int winner = neurons.findWinner(x, pattern + 3);
      const FootPoint foot = image.project(pattern, winner);
      record.MeanSquareError += foot.SquareDistance / options.SamplesPerEpoch;
      neurons.update(x, image.referencePoint(pattern, foot, winner), record.LearningRate,
        record.NeighborhoodRadius, pattern + 3);
    }
    const Points after = neurons.weights();
    record.MeanDisplacement = (after - before).rowwise().norm().mean();
    before = after;
    result.History.push_back(record);
  }
  result.Positions = before;
  result.PatternValues.resize(before.rows(), numberOfValues);
  for (Index i = 0; i < before.rows() && numberOfValues > 0; ++i)
  {
    result.PatternValues.row(i) =
      neurons.fullWeight(static_cast<int>(i)).tail(numberOfValues).transpose();
  }
  return result;
}
}
