// Learning: against a brute-force reference, against points, neurons and threads.
//
// The figures to read are ratios within one run. PointToSurface is the mean square distance of the
// points to the mesh in units of the cloud's largest radius, so that speed cannot be bought with
// quality unseen.

#include "BenchmarkFixtures.h"
#include "BruteForceTraining.h"
#include "Learn/ConformalSOM.h"
#include "Mesh/GeodesicSphere.h"
#include "Search/TriangleTree.h"

#include <benchmark/benchmark.h>

using conformal::ConformalSOMOptions;
using conformal::Index;
using conformal::Points;
using conformal::TrainingSamples;

namespace
{
constexpr Index PaperCloud = 12963; // X_few
constexpr int PaperFrequency = 36;

double pointToSurface(const TrainingSamples& samples, const Points& weights, int frequency)
{
  const conformal::TriangleTree tree(weights, conformal::makeGeodesicSphere(frequency).Triangles);
  double sum = 0.0;
  for (Index i = 0; i < samples.size(); ++i)
  {
    sum += tree.closestPoint(samples[i]).SquareDistance;
  }
  return sum / static_cast<double>(samples.size());
}

Points normalized(const TrainingSamples& samples, Points weights)
{
  for (Index i = 0; i < weights.rows(); ++i)
  {
    weights.row(i) = samples.normalize(weights.row(i));
  }
  return weights;
}

// The paper's 640,000 presentations.
void Online(benchmark::State& state)
{
  const Points points = fixtures::bumpyCloud(PaperCloud);
  const TrainingSamples samples(points);
  ConformalSOMOptions options;
  options.TrainingMode = conformal::TrainingMode::Online;
  options.NumberOfNeurons = conformal::geodesicSphereSize(PaperFrequency);
  Points weights;
  for (auto _ : state)
  {
    weights = trainConformalSOM(samples, options).Positions;
  }
  state.counters["PointToSurface"] =
    pointToSurface(samples, normalized(samples, weights), PaperFrequency);
}
BENCHMARK(Online)->Unit(benchmark::kSecond)->Iterations(3);

void OnlineByBruteForce(benchmark::State& state)
{
  const Points points = fixtures::bumpyCloud(PaperCloud);
  const TrainingSamples samples(points);
  ConformalSOMOptions options;
  options.TrainingMode = conformal::TrainingMode::Online;
  options.NumberOfNeurons = conformal::geodesicSphereSize(PaperFrequency);
  conformal::OnlineTrainingOptions paper;
  paper.Frequency = PaperFrequency;
  Points weights;
  for (auto _ : state)
  {
    weights = reference::trainByBruteForce(samples, paper);
  }
  state.counters["PointToSurface"] = pointToSurface(samples, weights, PaperFrequency);
  const Points fast = normalized(samples, trainConformalSOM(samples, options).Positions);
  state.counters["MeanDifference"] = (fast - weights).rowwise().norm().mean();
  state.counters["MaximumDifference"] = (fast - weights).rowwise().norm().maxCoeff();
}
BENCHMARK(OnlineByBruteForce)->Unit(benchmark::kSecond)->Iterations(1);

void batch(benchmark::State& state, Index size, int frequency, int threads)
{
  const Points points = fixtures::bumpyCloud(size);
  const conformal::Run run = fixtures::threads(threads);
  ConformalSOMOptions options;
  options.MeshType = conformal::MeshType::Geodesic;
  options.NumberOfNeurons = conformal::geodesicSphereSize(frequency);
  Points weights;
  for (auto _ : state)
  {
    const TrainingSamples samples(points, {}, {}, {}, run);
    weights = trainConformalSOM(samples, options, nullptr, run).Positions;
  }
  const TrainingSamples samples(points);
  state.counters["PointToSurface"] =
    pointToSurface(samples, normalized(samples, weights), frequency);
}

void BatchAgainstPoints(benchmark::State& state)
{
  batch(state, state.range(0), PaperFrequency, 1);
}
BENCHMARK(BatchAgainstPoints)
  ->RangeMultiplier(4)
  ->Range(1 << 14, 1 << 20)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void BatchAgainstNeurons(benchmark::State& state)
{
  batch(state, 200000, static_cast<int>(state.range(0)), 1);
}
BENCHMARK(BatchAgainstNeurons)
  ->Arg(9)
  ->Arg(18)
  ->Arg(36)
  ->Arg(72)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void BatchAgainstThreads(benchmark::State& state)
{
  batch(state, 200000, PaperFrequency, static_cast<int>(state.range(0)));
}
BENCHMARK(BatchAgainstThreads)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
}
