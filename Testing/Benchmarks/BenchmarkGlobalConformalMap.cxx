// The global conformal map: against vertices, threads and the balance of areas; and its linear
// equations by Eigen's factorization and by ours.

#include "BenchmarkFixtures.h"
#include "Linear/EdgeWeights.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/GeodesicSphere.h"
#include "SphereMap/GlobalConformalMap.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <vector>

using conformal::Columns;
using conformal::EdgeWeights;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
constexpr int ScanFrequency = 116; // 134,562 vertices, as many as Igea

/// A smooth surface without symmetry, its triangles of many shapes; 10 f^2 + 2 vertices.
Mesh lumpySurface(int frequency)
{
  Mesh mesh = makeGeodesicSphere(frequency);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    const Vector3 n = mesh.Positions.row(i);
    mesh.Positions.row(i) *= 1.0 + 0.2 * std::sin(4.0 * n[0]) * std::sin(3.0 * n[1] + 1.0);
  }
  return mesh;
}

void map(benchmark::State& state, int frequency, double balance, int threads)
{
  const Mesh mesh = lumpySurface(frequency);
  conformal::GlobalConformalMapOptions options;
  options.AreaBalance = balance;
  const conformal::Run run = fixtures::threads(threads);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(conformal::globalConformalMap(mesh, options, run));
  }
  state.counters["Vertices"] = static_cast<double>(mesh.Positions.rows());
}

void AgainstVertices(benchmark::State& state)
{
  map(state, static_cast<int>(state.range(0)), 0.0, 1);
}
BENCHMARK(AgainstVertices)->Arg(17)->Arg(58)->Arg(116)->Arg(232)->Unit(benchmark::kMillisecond);

void AgainstThreads(benchmark::State& state)
{
  map(state, ScanFrequency, 0.0, static_cast<int>(state.range(0)));
}
BENCHMARK(AgainstThreads)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void Balanced(benchmark::State& state)
{
  map(state, static_cast<int>(state.range(0)), 0.5, 1);
}
BENCHMARK(Balanced)->Arg(17)->Arg(58)->Arg(116)->Unit(benchmark::kMillisecond);

/// A mesh's Laplacian, its first vertex held.
class Factor : public benchmark::Fixture
{
public:
  void SetUp(const benchmark::State& state) override
  {
    const Mesh mesh = lumpySurface(static_cast<int>(state.range(0)));
    const EdgeWeights all = conformal::harmonicStrings(mesh.Positions, mesh.Triangles).Strings;
    const Index size = mesh.Positions.rows() - 1;
    this->Places = mesh.Positions.bottomRows(size);
    this->Weights = {};
    this->Weights.Neighbors.Offsets = { 0 };
    this->Diagonal.clear();
    for (int v = 1; v <= size; ++v)
    {
      this->Diagonal.push_back(all.sumAt(v));
      for (int k = all.Neighbors.Offsets[v]; k < all.Neighbors.Offsets[v + 1]; ++k)
      {
        if (all.Neighbors.Ids[k] > 0)
        {
          this->Weights.Neighbors.Ids.push_back(all.Neighbors.Ids[k] - 1);
          this->Weights.Weights.push_back(all.Weights[k]);
        }
      }
      this->Weights.Neighbors.Offsets.push_back(
        static_cast<int>(this->Weights.Neighbors.Ids.size()));
    }
  }

protected:
  Eigen::SparseMatrix<double> matrix() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    const int size = static_cast<int>(this->Diagonal.size());
    for (int i = 0; i < size; ++i)
    {
      entries.emplace_back(i, i, this->Diagonal[i]);
      for (int k = this->Weights.Neighbors.Offsets[i]; k < this->Weights.Neighbors.Offsets[i + 1];
           ++k)
      {
        entries.emplace_back(i, this->Weights.Neighbors.Ids[k], -this->Weights.Weights[k]);
      }
    }
    Eigen::SparseMatrix<double> result(size, size);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  EdgeWeights Weights;
  std::vector<double> Diagonal;
  Points Places;
};

BENCHMARK_DEFINE_F(Factor, Eigen)(benchmark::State& state)
{
  for (auto _ : state)
  {
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(this->matrix());
    benchmark::DoNotOptimize(factor.info());
  }
}
BENCHMARK_REGISTER_F(Factor, Eigen)->Arg(17)->Arg(58)->Arg(116)->Unit(benchmark::kMillisecond);

BENCHMARK_DEFINE_F(Factor, Multifrontal)(benchmark::State& state)
{
  const conformal::Run run = fixtures::threads(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    const conformal::MultifrontalCholesky factor(this->Weights, this->Diagonal, this->Places, run);
    benchmark::DoNotOptimize(&factor);
  }
}
BENCHMARK_REGISTER_F(Factor, Multifrontal)
  ->Args({ 17, 1 })
  ->Args({ 58, 1 })
  ->Args({ 116, 1 })
  ->Args({ 116, 2 })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
}
