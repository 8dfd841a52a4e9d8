#include "Learn/NeuronSearch.h"

#include "Base/FixedPointSums.h"
#include "Cloud/FootPoints.h"
#include "Learn/Fit/NoiseEstimate.h"
#include "Learn/LearningStage.h"
#include "Learn/StartSearch.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Measured on six objects with 1,500 to 15,000 samples and noise of up to 0.01 of the radius. With
// noise of 0.01, a sixth as many neurons as samples is closest to the object, and the noise is
// known within 15 %. Without noise, the distance decreases up to 1.5 neurons per sample or more.
constexpr Index SamplesPerNeuron = 6, EnoughSamples = 3;
constexpr double LargestPerSample = 1.5;
constexpr double Finer = 3.0; // greatest ratio of two numbers that are tried one after the other
constexpr Index LeftOut = 5;  // one of so many samples

constexpr double NegligibleNoise = 1e-4; // of the radius

// A square distance counts at most this number of times the typical square distance, which is 0.28
// times the variance of Gaussian noise. Outliers thus do not decide.
constexpr double MaximumOfTypical = 1000.0;

/// Square distances of samples from a mesh that was learned without them.
struct Trial
{
  std::vector<double> Squares;
  double Typical = 0.0;
};

Trial trialOf(const TrainingSamples& leftOut, const Mesh& mesh, const Run& run)
{
  const TriangleTree tree(mesh.Positions, mesh.Triangles, run.unwatched());
  Trial trial;
  trial.Squares.resize(leftOut.size());
  TypicalSquare typical;
  forEachFoot(
    leftOut, tree, leftOut.size(), [](Index i) { return i; },
    [&](Index i, const Vector3&, const FootPoint& foot)
    {
      trial.Squares[i] = foot.SquareDistance;
      typical.add(foot.SquareDistance);
    },
    run);
  trial.Typical = typical.mean(leftOut.reduce(), leftOut.totalSize());
  return trial;
}

/// Return whether the distances of a trial are smaller than those of another one by more than the
/// standard error.
bool isCloser(const Trial& trial, const Trial& other, const Reduce& reduce)
{
  const double most = MaximumOfTypical * std::min(trial.Typical, other.Typical);
  enum
  {
    Sum,
    SumOfSquares,
    NumberOfSums
  };
  FixedPointSums sums(NumberOfSums);
  for (std::size_t i = 0; i < trial.Squares.size(); ++i)
  {
    const double gain =
      (std::min(most, other.Squares[i]) - std::min(most, trial.Squares[i])) / most;
    sums.add(Sum, gain);
    sums.add(SumOfSquares, gain * gain);
  }
  sums.reduce(reduce);
  return sums[Sum] > std::sqrt(sums[SumOfSquares]);
}

/// Return the numbers to try, in ascending sequence.
std::vector<Index> numbersFor(const TrainingSamples& samples)
{
  const auto size = static_cast<double>(samples.totalSize());
  const double first = std::max(size / SamplesPerNeuron, static_cast<double>(MinimumNeurons));
  const double last = std::clamp(LargestPerSample * size, static_cast<double>(MinimumNeurons),
    static_cast<double>(UsualNeurons));
  const int steps =
    std::max(1, static_cast<int>(std::ceil(std::log(last / first) / std::log(Finer))));
  std::vector<Index> numbers;
  for (int step = 0; step <= steps; ++step)
  {
    const double number = first * std::pow(last / first, static_cast<double>(step) / steps);
    numbers.push_back(static_cast<Index>(number));
  }
  return numbers;
}

class NeuronSearch
{
public:
  NeuronSearch(
    const TrainingSamples& samples, const ConformalSOMOptions& options, const MappedMesh* mesh)
    : Samples(samples)
    , Options(options)
    , Mesh(mesh)
    , Numbers(numbersFor(samples))
  {
  }

  ConformalSOMResult run(const Run& run) const
  {
    constexpr double first = 0.3, trials = 0.6; // progress at the end of a step
    const Index second = this->Numbers[this->Numbers.size() - 2];
    std::vector<LearningStage> stages;
    ConformalSOMResult result = this->learn(this->Samples, second, &stages, run.part(0.0, first));
    const double noise = result.Noise;
    const bool isNoisy = noise > NegligibleNoise;
    const double done = isNoisy ? trials : first;
    const Index best = isNoisy ? this->bestNumber(run.part(first, trials)) : this->Numbers.back();
    if (best != second)
    {
      stages.clear();
      result = this->learn(this->Samples, best, &stages, run.part(done, 1.0));
    }
    if (isNoisy && best > second)
    {
      result.Noise = noise; // about as many neurons as samples hide noise
    }
    for (const LearningStage& stage : stages)
    {
      this->Options.Observer(stage);
    }
    return result;
  }

private:
  ConformalSOMResult learn(const TrainingSamples& samples, Index neurons,
    std::vector<LearningStage>* stages, const Run& run) const
  {
    ConformalSOMOptions options = this->Options;
    options.NumberOfNeurons = neurons;
    options.Observer = {};
    if (this->Options.Observer && stages)
    {
      options.Observer = [&](const LearningStage& stage) { stages->push_back(stage); };
    }
    return learnFromBestStart(samples, options, this->Mesh, run);
  }

  /// Return the number of neurons whose mesh is closest to samples that were left out.
  Index bestNumber(const Run& run) const
  {
    const TrainingSamples used = this->Samples.selected([](Index i) { return i % LeftOut != 0; });
    const TrainingSamples leftOut =
      this->Samples.selected([](Index i) { return i % LeftOut == 0; });
    const auto trial = [&](std::size_t i)
    {
      const auto at = [&](std::size_t k)
      { return static_cast<double>(k) / static_cast<double>(this->Numbers.size()); };
      const Run own = run.part(at(i), at(i + 1));
      return trialOf(leftOut, this->learn(used, this->Numbers[i], nullptr, own), own.unwatched());
    };
    Trial best = trial(0);
    for (std::size_t i = 1; i < this->Numbers.size(); ++i)
    {
      Trial finer = trial(i);
      if (!isCloser(finer, best, this->Samples.reduce()))
      {
        return this->Numbers[i - 1];
      }
      best = std::move(finer);
    }
    return this->Numbers.back();
  }

  const TrainingSamples& Samples;
  const ConformalSOMOptions& Options;
  const MappedMesh* const Mesh;
  const std::vector<Index> Numbers;
};

/// Return whether the number of neurons depends on the samples.
bool dependsOnSamples(
  const TrainingSamples& samples, const ConformalSOMOptions& options, const MappedMesh* mesh)
{
  const bool startsFromSamples = mesh && mesh->SpherePositions.rows() == 0;
  return !startsFromSamples && samples.dimension() == 3 &&
    meshTypeFor(options, samples) == MeshType::Adaptive &&
    samples.totalSize() < EnoughSamples * UsualNeurons;
}
}

//------------------------------------------------------------------------------
ConformalSOMResult learnWithNeurons(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run)
{
  if (options.NumberOfNeurons != AutomaticNeurons)
  {
    return learnFromBestStart(samples, options, mesh, run);
  }
  ConformalSOMOptions usual = options;
  usual.NumberOfNeurons = UsualNeurons;
  return dependsOnSamples(samples, options, mesh) ? NeuronSearch(samples, usual, mesh).run(run)
                                                  : learnFromBestStart(samples, usual, mesh, run);
}
}
