#include "BatchTraining.h"

#include "FixedPointSums.h"
#include "LeastSquaresPolish.h"
#include "MeshTopology.h"
#include "Random.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 4096;
constexpr int CoarsestFrequency = 4;
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

/// Which patterns a pass takes: all where they are few, else the next stretch of a stride through
/// all of them that meets each once before it meets any again.
class Rotation
{
public:
  Rotation(Index size, unsigned int seed)
    : Size(size)
  {
    // A stride near the golden section spreads any stretch evenly over the scan's own order.
    this->Stride = std::max<Index>(1, static_cast<Index>(0.6180339887498949 * size));
    while (gcd(this->Stride, size) != 1)
    {
      ++this->Stride;
    }
    this->Next = Random(seed).index(size);
  }

  void take(Index count, std::vector<Index>& taken)
  {
    taken.resize(std::min(count, this->Size));
    for (Index& id : taken)
    {
      id = this->Next;
      this->Next = (this->Next + this->Stride) % this->Size;
    }
    // In the scan's order: neighbours in memory are often neighbours in space.
    std::sort(taken.begin(), taken.end());
  }

private:
  static Index gcd(Index a, Index b) { return b == 0 ? a : gcd(b, a % b); }

  Index Size, Stride, Next;
};

/// One step of diffusion over the lattice: every neuron keeps half and hands half to its
/// neighbours in equal parts.
void diffuse(
  const Adjacency& neighbors, Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>& sums)
{
  auto spread = (0.5 * sums).eval();
  for (Index i = 0; i < sums.rows(); ++i)
  {
    const double part = 0.5 / neighbors.size(i);
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      spread.row(*j) += part * sums.row(i);
    }
  }
  sums.swap(spread);
}

/// The weights of a finer lattice: the coarser surface at the finer lattice's directions.
Points interpolate(const GeodesicSphere& coarse, const Points& weights, const Points& directions,
  const ParallelFor& parallelFor)
{
  const TriangleTree sphere(coarse.Positions, coarse.Faces);
  Points fine(directions.rows(), 3);
  forBlocks(parallelFor, fine.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = sphere.closestPoint(directions.row(i));
        const auto ids = coarse.Faces.row(foot.Triangle);
        fine.row(i) = foot.Barycentric[0] * weights.row(ids[0]) +
          foot.Barycentric[1] * weights.row(ids[1]) + foot.Barycentric[2] * weights.row(ids[2]);
      }
    });
  return fine;
}
}

ConformalSOMResult trainBatch(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const ParallelFor& parallelFor, const Progress& progress)
{
  const std::vector<int> levels = frequencies(options.Frequency);
  double work = 0.0, done = 0.0;
  const auto passWork = [](int f) { return static_cast<double>(f) * f; };
  for (int f : levels)
  {
    work += passWork(f) * options.PassesPerLevel;
  }
  work += passWork(options.Frequency) * options.NumberOfPolishRounds;

  ConformalSOMResult result;
  Rotation rotation(samples.size(), options.RandomSeed);
  std::vector<Index> taken;
  std::vector<FootPoint> feet;
  for (int f : levels)
  {
    const GeodesicSphere coarse = std::move(result.Network);
    result.Network = makeGeodesicSphere(f);
    const Points& positions = result.Network.Positions;
    const Triangles& faces = result.Network.Faces;
    result.Weights =
      f == levels.front() ? positions : interpolate(coarse, result.Weights, positions, parallelFor);
    const Adjacency neighbors = vertexNeighbors(faces, positions.rows());
    TriangleTree tree(result.Weights, faces);

    for (int pass = 0; pass < options.PassesPerLevel; ++pass)
    {
      rotation.take(options.SamplesPerNeuron * positions.rows(), taken);
      const Index size = static_cast<Index>(taken.size());
      feet.resize(size);
      forBlocks(parallelFor, size, BlockSize,
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            feet[i] = tree.closestPoint(samples[taken[i]], i > begin ? feet[i - 1].Triangle : -1);
          }
        });

      TrainingRecord record;
      FixedPointSums sums(4 * positions.rows());
      FixedPointSums error(1);
      for (Index i = 0; i < size; ++i)
      {
        const Vector3 x = samples[taken[i]];
        const double weight = samples.weight(taken[i]);
        error.add(0, feet[i].SquareDistance);
        for (int k = 0; k < 3; ++k)
        {
          const double share = weight * feet[i].Barycentric[k];
          const Index neuron = 4 * Index(faces(feet[i].Triangle, k));
          sums.add(neuron, share);
          for (int c = 0; c < 3; ++c)
          {
            sums.add(neuron + 1 + c, share * x[c]);
          }
        }
      }
      Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> shares(positions.rows(), 4);
      for (Index i = 0; i < shares.size(); ++i)
      {
        shares.data()[i] = sums[i];
      }
      const int steps =
        std::max(1, WidestDiffusion - pass * WidestDiffusion / std::max(1, options.PassesPerLevel));
      for (int step = 0; step < steps; ++step)
      {
        diffuse(neighbors, shares);
      }

      // A neuron without patterns follows its neighbours; in doubt the old weight is as good.
      const double negligible = 1e-6 * shares.col(0).mean();
      Points moved = result.Weights;
      for (Index i = 0; i < moved.rows(); ++i)
      {
        Vector3 pull = Vector3::Zero();
        for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        {
          pull += Vector3(result.Weights.row(*j)) / neighbors.size(i);
        }
        moved.row(i) =
          (shares.row(i).tail<3>() + negligible * pull.transpose()) / (shares(i, 0) + negligible);
      }
      record.Frequency = f;
      record.NeighborhoodRadius = std::sqrt(0.5 * steps) * 2.0 / std::sqrt(3.0) *
        std::sqrt(4.0 * std::acos(-1.0) / (2.0 * faces.rows()));
      record.LearningRate = 1.0;
      record.MeanSquareError = error[0] / static_cast<double>(size);
      record.MeanDisplacement = (moved - result.Weights).rowwise().norm().mean();
      result.History.push_back(record);
      result.Weights = moved;
      tree.refit(result.Weights);
      done += passWork(f);
      report(progress, done / work);
    }
  }
  polish(
    samples, options, parallelFor,
    [&](double fraction)
    { return !progress || progress((done + fraction * (work - done)) / work); },
    result);
  return result;
}
}
