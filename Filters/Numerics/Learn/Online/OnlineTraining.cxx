#include "Learn/Online/OnlineTraining.h"

#include "Base/Random.h"
#include "Learn/Online/NeuronBlocks.h"
#include "Mesh/MeshTopology.h"
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

  /// Return the next `count` patterns, #count by 3.
  Points next(Index count)
  {
    Points patterns(count, 3);
    std::vector<std::int64_t> bits(patterns.size(), 0);
    for (Index i = 0; i < count; ++i)
    {
      const Index id = this->draw();
      if (id >= 0 && id < this->Samples.size())
      {
        const Vector3 x = this->Samples[id];
        std::memcpy(bits.data() + 3 * i, x.data(), sizeof(x));
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
  ImageOnNetwork(const Mesh& network, const NeuronBlocks& neurons, ReferencePoint reference)
    : Network(network)
    , Neurons(neurons)
    , Reference(reference)
    , Around(vertexTriangles(network.Triangles, network.Positions.rows()))
    , Shapes(network.Positions, network.Triangles)
  {
  }

  /// Find the triangle around the winner that contains the projection of x. If the projection is on
  /// an edge or corner, several triangles contain it. Each of these triangles has a different image
  /// of the projection. Therefore, the triangle with the lowest neuron ids is selected.
  FootPoint project(const Vector3& x, int winner) const
  {
    constexpr double rounding = 4e-15; // rounding error of coordinates
    FootPoint best;
    for (const int* r = this->Around.begin(winner); r != this->Around.end(winner); ++r)
    {
      const auto ids = this->Network.Triangles.row(*r);
      FootPoint foot = closestPointOfTriangle(x, this->Neurons.weight(ids[0]),
        this->Neurons.weight(ids[1]), this->Neurons.weight(ids[2]));
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
  Vector3 referencePoint(const FootPoint& foot, int winner) const
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
      const TriangleShape simplex(
        this->Neurons.weight(ids[0]), this->Neurons.weight(ids[1]), this->Neurons.weight(ids[2]));
      image = this->Shapes.toNetwork(foot.Triangle, simplex, foot.Barycentric);
    }
    Vector3 r = image[0] * Vector3(positions.row(ids[0])) +
      image[1] * Vector3(positions.row(ids[1])) + image[2] * Vector3(positions.row(ids[2]));
    r.normalize(); // |r| = |n_i| = 1, as the paper allows
    return r;
  }

private:
  const Mesh& Network;
  const NeuronBlocks& Neurons;
  const ReferencePoint Reference;
  const Adjacency Around;
  const NetworkShapes Shapes;
};
}

LearnedMesh trainOnline(const TrainingSamples& samples, const Mesh& network, const Points& start,
  const OnlineTrainingOptions& options, const Run& run)
{
  NeuronBlocks neurons(network.Positions, start); // step 1
  Sampler sampler(samples, options.RandomSeed);
  const ImageOnNetwork image(network, neurons, options.ReferencePoint);

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
    Points patterns;
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
      const Vector3 x = patterns.row(step % AtATime);
      const int winner = neurons.findWinner(x);
      const FootPoint foot = image.project(x, winner);
      record.MeanSquareError += foot.SquareDistance / options.SamplesPerEpoch;
      neurons.update(
        x, image.referencePoint(foot, winner), record.LearningRate, record.NeighborhoodRadius);
    }
    const Points after = neurons.weights();
    record.MeanDisplacement = (after - before).rowwise().norm().mean();
    before = after;
    result.History.push_back(record);
  }
  result.Positions = before;
  return result;
}
}
