// The curved seamless surface: against points, triangles and threads, and its parts.

#include "BenchmarkFixtures.h"
#include "CurvedSeamlessSurface.h"
#include "GeodesicSphere.h"
#include "NetworkShapes.h"
#include "SphereLocator.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

using conformal::GeodesicSphere;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Points;
using conformal::TriangleShape;
using conformal::Vector3;

namespace
{
constexpr int PaperFrequency = 36;
constexpr int PaperSurfaceFrequency = 80; // 64,002 points

/// Triangles of many shapes, none of them a needle.
Points lumpyModel(const Points& sphere)
{
  Points model = sphere;
  for (Index i = 0; i < model.rows(); ++i)
  {
    const Vector3 n = sphere.row(i);
    model.row(i) *= 1.0 + 0.2 * std::sin(20.0 * n[0]) * std::sin(17.0 * n[1] + 1.0);
  }
  return model;
}

void surface(benchmark::State& state, int frequency, int surfaceFrequency, int threads)
{
  const GeodesicSphere network = makeGeodesicSphere(frequency);
  const Points model = lumpyModel(network.Positions);
  const Points directions = makeGeodesicSphere(surfaceFrequency).Positions;
  const conformal::ParallelFor parallelFor = fixtures::threads(threads);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(conformal::buildCurvedSeamlessSurface(
      network.Positions, model, network.Faces, directions, {}, nullptr, parallelFor));
  }
  state.counters["Points"] = static_cast<double>(directions.rows());
}

void AgainstPoints(benchmark::State& state)
{
  surface(state, PaperFrequency, static_cast<int>(state.range(0)), 1);
}
BENCHMARK(AgainstPoints)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(benchmark::kMillisecond);

void AgainstTriangles(benchmark::State& state)
{
  surface(state, static_cast<int>(state.range(0)), PaperSurfaceFrequency, 1);
}
BENCHMARK(AgainstTriangles)
  ->Arg(9)
  ->Arg(18)
  ->Arg(36)
  ->Arg(72)
  ->Arg(144)
  ->Unit(benchmark::kMillisecond);

void AgainstThreads(benchmark::State& state)
{
  surface(state, PaperFrequency, PaperSurfaceFrequency, static_cast<int>(state.range(0)));
}
BENCHMARK(AgainstThreads)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The parts, in time for one triangle or one point.
class Parts : public benchmark::Fixture
{
public:
  void SetUp(const benchmark::State&) override
  {
    this->Network = makeGeodesicSphere(PaperFrequency);
    const Points model = lumpyModel(this->Network.Positions);
    this->Shapes = conformal::NetworkShapes(this->Network.Positions, this->Network.Faces);
    this->Simplices.clear();
    for (Index r = 0; r < this->Network.Faces.rows(); ++r)
    {
      const auto ids = this->Network.Faces.row(r);
      this->Simplices.push_back({ model.row(ids[0]), model.row(ids[1]), model.row(ids[2]) });
    }
    conformal::Random random(1);
    for (std::size_t i = 0; i < this->Simplices.size(); ++i)
    {
      const double x = random.uniform(), y = (1.0 - x) * random.uniform();
      this->Barycentrics.emplace_back(x, y, 1.0 - x - y);
    }
  }

protected:
  TriangleShape shape(std::size_t r) const
  {
    const auto& simplex = this->Simplices[r];
    return TriangleShape(simplex[0], simplex[1], simplex[2]);
  }

  GeodesicSphere Network;
  conformal::NetworkShapes Shapes;
  std::vector<std::array<Vector3, 3>> Simplices;
  std::vector<Vector3> Barycentrics;
};

BENCHMARK_F(Parts, ToModel)(benchmark::State& state)
{
  std::vector<TriangleShape> shapes;
  for (std::size_t r = 0; r < this->Simplices.size(); ++r)
  {
    shapes.push_back(this->shape(r));
  }
  std::size_t r = 0;
  for (auto _ : state)
  {
    r = r + 1 < shapes.size() ? r + 1 : 0;
    benchmark::DoNotOptimize(
      this->Shapes.toModel(static_cast<Index>(r), shapes[r], this->Barycentrics[r]));
  }
}

// What online learning does once for each pattern.
BENCHMARK_F(Parts, ShapeAndToNetwork)(benchmark::State& state)
{
  std::size_t r = 0;
  for (auto _ : state)
  {
    r = r + 1 < this->Simplices.size() ? r + 1 : 0;
    benchmark::DoNotOptimize(
      this->Shapes.toNetwork(static_cast<Index>(r), this->shape(r), this->Barycentrics[r]));
  }
}

BENCHMARK_F(Parts, Locate)(benchmark::State& state)
{
  const conformal::SphereLocator locator(this->Network.Positions, this->Network.Faces);
  const Points directions = makeGeodesicSphere(PaperSurfaceFrequency).Positions;
  Index i = 0;
  for (auto _ : state)
  {
    i = i + 1 < directions.rows() ? i + 1 : 0;
    benchmark::DoNotOptimize(locator.locate(directions.row(i)));
  }
}
}
