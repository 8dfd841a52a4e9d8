#include "OnlineTraining.h"

#include "MeshTopology.h"
#include "NeuronBlocks.h"
#include "Random.h"
#include "SchwarzChristoffel.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
/// Step 2: every pattern with equal probability, or in proportion to its priority.
class Sampler
{
public:
  Sampler(const TrainingSamples& samples, unsigned int seed)
    : Size(samples.size())
    , Numbers(seed)
  {
    if (samples.weighted())
    {
      this->Cumulative.resize(this->Size);
      double sum = 0.0;
      for (Index i = 0; i < this->Size; ++i)
      {
        this->Cumulative[i] = sum += samples.weight(i);
      }
    }
  }

  Index next()
  {
    if (this->Cumulative.empty())
    {
      return this->Numbers.index(this->Size);
    }
    const double target = this->Numbers.uniform() * this->Cumulative.back();
    const auto found = std::upper_bound(this->Cumulative.begin(), this->Cumulative.end(), target);
    return std::min(static_cast<Index>(found - this->Cumulative.begin()), this->Size - 1);
  }

private:
  Index Size;
  Random Numbers;
  std::vector<double> Cumulative;
};
}

ConformalSOMResult trainOnline(const TrainingSamples& samples, const GeodesicSphere& network,
  const Points& start, const ConformalSOMOptions& options, const Progress& progress)
{
  const Adjacency around = vertexTriangles(network.Faces, network.Positions.rows());
  NeuronBlocks neurons(network.Positions, start); // step 1
  const NetworkShapes shapes(network.Positions, network.Faces);
  Sampler sampler(samples, options.RandomSeed);

  // Step 3: the simplex around the winner that x is projected on.
  const auto project = [&](const Vector3& x, int winner)
  {
    FootPoint best;
    for (const int* r = around.begin(winner); r != around.end(winner); ++r)
    {
      const auto ids = network.Faces.row(*r);
      const FootPoint foot = closestPointOfTriangle(
        x, neurons.weight(ids[0]), neurons.weight(ids[1]), neurons.weight(ids[2]));
      if (foot.SquareDistance < best.SquareDistance)
      {
        best = foot;
        best.Triangle = *r;
      }
    }
    return best;
  };

  ConformalSOMResult result;
  result.Network = network;
  Points before = start;
  const int reportEvery = std::max(1, options.SamplesPerEpoch / 16);
  for (int t = 0; t < options.NumberOfEpochs; ++t)
  {
    TrainingRecord record;
    record.Frequency = options.Frequency;
    record.NeighborhoodRadius =
      options.InitialNeighborhoodRadius * std::exp(-t / options.NeighborhoodTimeConstant);
    record.LearningRate =
      options.InitialLearningRate * std::exp(-t / options.LearningRateTimeConstant);
    for (int step = 0; step < options.SamplesPerEpoch; ++step)
    {
      if (step % reportEvery == 0)
      {
        report(progress,
          (t + static_cast<double>(step) / options.SamplesPerEpoch) / options.NumberOfEpochs);
      }
      const Vector3 x = samples[sampler.next()];
      const int winner = neurons.findWinner(x);
      const FootPoint foot = project(x, winner);
      record.MeanSquareError += foot.SquareDistance / options.SamplesPerEpoch;

      Vector3 r = network.Positions.row(winner);
      if (options.ReferencePoint == ReferencePoint::Conformal)
      {
        const auto ids = network.Faces.row(foot.Triangle);
        const TriangleShape simplex(
          neurons.weight(ids[0]), neurons.weight(ids[1]), neurons.weight(ids[2]));
        const Vector3 image = shapes.toNetwork(foot.Triangle, simplex, foot.Barycentric);
        r = image[0] * Vector3(network.Positions.row(ids[0])) +
          image[1] * Vector3(network.Positions.row(ids[1])) +
          image[2] * Vector3(network.Positions.row(ids[2]));
        r.normalize(); // |r| = |n_i| = 1, as the paper allows
      }
      neurons.update(x, r, record.LearningRate, record.NeighborhoodRadius);
    }
    const Points after = neurons.weights();
    record.MeanDisplacement = (after - before).rowwise().norm().mean();
    before = after;
    result.History.push_back(record);
  }
  result.Weights = before;
  return result;
}
}
