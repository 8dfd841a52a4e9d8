// The curved seamless surface: against points, triangles and threads, and its parts.

#include "BenchmarkFixtures.h"
#include "Mesh/GeodesicSphere.h"
#include "Sphere/SphereLocator.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "TriangleMap/NetworkShapes.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

using conformal::CurvedSeamlessSurface;
using conformal::CurvedSeamlessSurfaceOptions;
using conformal::DomeHeight;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::SeamMode;
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
    model.row(i) *= 1.0 + 0.06 * std::sin(9.0 * n[0]) * std::sin(7.0 * n[1] + 1.0);
  }
  return model;
}

CurvedSeamlessSurfaceOptions optionsOf(SeamMode seamMode, DomeHeight domeHeight)
{
  CurvedSeamlessSurfaceOptions options;
  options.SeamMode = seamMode;
  options.DomeHeight = domeHeight;
  return options;
}

/// From the mesh to the points of the surface, tables and all. CPU time is that of all threads.
void surface(benchmark::State& state, int frequency, int surfaceFrequency, int threads,
  const CurvedSeamlessSurfaceOptions& options = {})
{
  const Mesh network = makeGeodesicSphere(frequency);
  const Points model = lumpyModel(network.Positions);
  const Points directions = makeGeodesicSphere(surfaceFrequency).Positions;
  const conformal::Run run = fixtures::threads(threads);
  Points positions(directions.rows(), 3), normals(directions.rows(), 3);
  conformal::SurfaceSamples samples;
  samples.Positions = positions.data();
  samples.Normals = normals.data();
  for (auto _ : state)
  {
    const CurvedSeamlessSurface surface(
      { { model, network.Triangles }, network.Positions }, options, nullptr, run);
    conformal::evaluate(surface, directions, samples, run);
  }
  state.counters["Points"] = static_cast<double>(directions.rows());
}

void EdgeMatched(benchmark::State& state)
{
  surface(
    state, PaperFrequency, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
}
BENCHMARK(EdgeMatched)
  ->ArgNames({ "f", "threads" })
  ->ArgsProduct({ { 40, 80, 160, 316 }, { 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

void PerTriangle(benchmark::State& state)
{
  surface(state, PaperFrequency, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
    optionsOf(SeamMode::PerTriangle, DomeHeight::Curvature));
}
BENCHMARK(PerTriangle)
  ->ArgNames({ "f", "threads" })
  ->ArgsProduct({ { 40, 80, 160, 316 }, { 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

void Published(benchmark::State& state)
{
  surface(state, PaperFrequency, PaperSurfaceFrequency, static_cast<int>(state.range(0)),
    optionsOf(SeamMode::PerTriangle, DomeHeight::Published));
}
BENCHMARK(Published)
  ->ArgName("threads")
  ->Arg(1)
  ->Arg(2)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

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

/// Back from points of the surface to the sphere, the tree of the surface and all.
void ToSphere(benchmark::State& state)
{
  const Mesh network = makeGeodesicSphere(PaperFrequency);
  const Points model = lumpyModel(network.Positions);
  const Points directions = makeGeodesicSphere(PaperSurfaceFrequency).Positions;
  const CurvedSeamlessSurface surface({ { model, network.Triangles }, network.Positions });
  Points positions(directions.rows(), 3), back(directions.rows(), 3);
  conformal::SurfaceSamples samples;
  samples.Positions = positions.data();
  conformal::evaluate(surface, directions, samples);
  for (auto _ : state)
  {
    conformal::invert(surface, positions, back.data());
  }
}
BENCHMARK(ToSphere)->Unit(benchmark::kMillisecond);

/// The parts, in time for one triangle or one point.
class Parts : public benchmark::Fixture
{
public:
  void SetUp(const benchmark::State&) override
  {
    this->Network = makeGeodesicSphere(PaperFrequency);
    const Points model = lumpyModel(this->Network.Positions);
    this->Shapes = conformal::NetworkShapes(this->Network.Positions, this->Network.Triangles);
    this->Simplices.clear();
    for (Index r = 0; r < this->Network.Triangles.rows(); ++r)
    {
      const auto ids = this->Network.Triangles.row(r);
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

  Mesh Network;
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
  const conformal::SphereLocator locator(this->Network.Positions, this->Network.Triangles);
  const Points directions = makeGeodesicSphere(PaperSurfaceFrequency).Positions;
  Index i = 0;
  for (auto _ : state)
  {
    i = i + 1 < directions.rows() ? i + 1 : 0;
    benchmark::DoNotOptimize(locator.locate(directions.row(i)));
  }
}
}
