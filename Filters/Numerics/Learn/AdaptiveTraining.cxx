#include "Learn/AdaptiveTraining.h"

#include "Base/Steps.h"
#include "Learn/HullStart.h"
#include "Learn/LeastSquaresPolish.h"
#include "Learn/NoiseEstimate.h"
#include "Learn/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Remeshing.h"
#include "Mesh/SharpEdges.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
// Measured on scans, 12,962 neurons: more of these cost time and gain nothing.
constexpr int FirstIterations = 6, Iterations = 3; // of remeshing
constexpr int Turns = 3, RoundsPerTurn = 2;        // of polish and remeshing

// The hull is no finer than half an edge on an object of usual area.
constexpr double SpacingForEdge = 0.5, TypicalArea = 5.0;

constexpr double FirstSmoothness = 0.2; // of a turn: what was remeshed lies beside the patterns

// A tip lies far from a surface that has not come to it yet. Where the hull leaves patterns out,
// there are others like them near it.
constexpr double OutlierRatio = 10.0, OutlierRatioAmongStrays = 4.0, ManyStrays = 0.001;

// Noise shows beside a surface of a quarter of the vertices.
constexpr Index Coarser = 4;
constexpr Index LeastCoarse = 50; // vertices that can tell
constexpr double LittleNoise = 0.5;

// By how much vertices of objects lie off the middle of their neighbors, in squares of the edge
// length where the largest radius is 1. Measured: on Igea and the bunny with noise of 0.002 to 0.01
// this gives the best smoothness within a factor of two.
constexpr double TypicalBending = 4.0;

RemeshingOptions remeshingTo(Index neurons, int iterations)
{
  RemeshingOptions options;
  options.NumberOfVertices = neurons;
  options.NumberOfIterations = iterations;
  return options;
}

double edgeFor(double area, Index neurons)
{
  return std::sqrt(2.0 / std::sqrt(3.0) * area / static_cast<double>(neurons));
}

double spacingFor(const TrainingSamples& samples, Index neurons)
{
  return std::min(std::max(hullSpacing(samples), SpacingForEdge * edgeFor(TypicalArea, neurons)),
    GenusZeroHullLimits::LargestSpacing);
}

/// The surface to begin with, in the samples' unit.
ConformalSOMResult firstSurface(const TrainingSamples& samples, const Mesh* start, double spacing,
  HullIndicator indicator, PolishOptions& polishing, const ParallelFor& parallelFor,
  const Progress& progress)
{
  ConformalSOMResult result;
  if (start)
  {
    requireGenusZero(start->Triangles, start->Positions.rows(), progress);
    static_cast<Mesh&>(result) = *start;
    if (signedVolume(result.Positions, result.Triangles) < 0.0)
    {
      result.Triangles.col(1).swap(result.Triangles.col(2));
    }
    return result;
  }
  GenusZeroHullResult hull = makeHull(samples, spacing, indicator, parallelFor, progress);
  static_cast<Mesh&>(result) = hull;
  result.Hulled = true;
  result.HullLeaks = hull.Leaks;
  result.CutFraction = cutFraction(hull);
  result.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
  // Over what nobody has seen, winding numbers know better where the surface is than the points
  // across from there.
  polishing.DrawsIdle = hull.Indicator == HullIndicator::Distance;
  const auto strays = static_cast<double>(hull.NumberOfSamplesOutside);
  if (strays > ManyStrays * static_cast<double>(samples.totalSize()))
  {
    polishing.OutlierRatio = OutlierRatioAmongStrays;
  }
  polishing.Belongs = [data = std::move(hull.Data)](const Vector3& x) { return data.contains(x); };
  return result;
}

struct Noise
{
  double ToDetail = 0.0, Variance = 0.0;
};

/// From what the surface, polished, leaves of the patterns, beside what one of a quarter of its
/// vertices does.
Noise noiseBeside(const ConformalSOMResult& result, const TrainingSamples& samples,
  PolishOptions polishing, const ParallelFor& parallelFor, const Progress& progress)
{
  const Index neurons = result.Positions.rows() / Coarser;
  const Index patterns = polishing.SamplesPerRound / Coarser;
  if (neurons < LeastCoarse)
  {
    return {};
  }
  Steps steps(progress, { 1.0, 4.0, 4.0, 1.0 });
  const auto error = [&](const ConformalSOMResult& surface)
  {
    return typicalSquareError(
      samples, surface.Positions, surface.Triangles, patterns, parallelFor, steps.next());
  };
  const double fine = error(result);
  ConformalSOMResult coarse = result;
  remesh(coarse, remeshingTo(neurons, Iterations), parallelFor, steps.next());
  polishing.SamplesPerRound = patterns;
  polish(samples, polishing, parallelFor, steps.next(), coarse);
  const double rough = error(coarse);
  return { noiseToDetail(rough, fine), noiseVariance(rough, fine) };
}

/// How stiff, for each pattern of a neuron, the surface has to be for the noise to weigh as much as
/// its bending: the likeliest surface where both are Gaussian.
double smoothnessFor(const Noise& noise, const ConformalSOMResult& result, Index patterns)
{
  const auto neurons = static_cast<double>(result.Positions.rows());
  const double edge =
    edgeFor(surfaceArea(result.Positions, result.Triangles), result.Positions.rows());
  const double bending = TypicalBending * edge * edge;
  return noise.Variance > 0.0
    ? noise.Variance / (bending * bending * static_cast<double>(patterns) / neurons)
    : 0.0;
}
}

ConformalSOMResult trainAdaptive(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const Mesh* start, const ParallelFor& parallelFor, const Progress& progress)
{
  const Index neurons = options.NumberOfNeurons;
  PolishOptions polishing; // of a turn
  polishing.NumberOfRounds = RoundsPerTurn;
  polishing.FirstSmoothness = std::max(options.Smoothness, FirstSmoothness);
  polishing.LastSmoothness = options.Smoothness;
  polishing.OutlierRatio = OutlierRatio;
  polishing.AutomaticPriority = options.AutomaticPriority;
  polishing.SamplesPerRound = options.SamplesPerNeuron * neurons;
  polishing.RandomSeed = options.RandomSeed;
  PolishOptions last = polishing;
  last.NumberOfRounds = options.NumberOfPolishRounds;

  RemeshingOptions remeshing = remeshingTo(neurons, Iterations);
  const double ofPolish = workOfPolish(samples, polishing, neurons),
               ofRemeshing = workOfRemeshing(remeshing, neurons),
               ofLast = workOfPolish(samples, last, neurons);
  const auto workFrom = [&](double vertices)
  {
    std::vector<double> work = { workOfRemeshing(
      remeshingTo(neurons, FirstIterations), static_cast<Index>(vertices)) };
    for (int turn = 0; turn < Turns; ++turn)
    {
      work.insert(work.end(), { ofPolish, ofRemeshing });
    }
    work.insert(work.end(),
      { (ofPolish + ofRemeshing) / Coarser, ofLast, workOfSharpEdges(neurons), 0.01 * ofLast });
    return work;
  };
  const double spacing = spacingFor(samples, neurons);
  std::vector<double> work = workFrom(verticesOfHull(spacing));
  work.insert(work.begin(),
    start ? 300.0 * start->Positions.rows() : workOfHull(samples, spacing, options.HullIndicator));
  Steps steps(progress, work);
  ConformalSOMResult result = firstSurface(
    samples, start, spacing, options.HullIndicator, polishing, parallelFor, steps.next());
  last.OutlierRatio = polishing.OutlierRatio;
  last.Belongs = polishing.Belongs;
  last.DrawsIdle = polishing.DrawsIdle;
  steps.replan(workFrom(static_cast<double>(result.Positions.rows())));

  remesh(result, remeshingTo(neurons, FirstIterations), parallelFor, steps.next());
  for (int turn = 0; turn < Turns; ++turn)
  {
    polish(samples, polishing, parallelFor, steps.next(), result);
    remeshing.MeetNumber = turn + 1 == Turns;
    remesh(result, remeshing, parallelFor, steps.next());
  }
  const Noise noise = noiseBeside(result, samples, polishing, parallelFor, steps.next());
  result.NoiseToDetail = noise.ToDetail;
  last.LastSmoothness +=
    smoothnessFor(noise, result, std::min(last.SamplesPerRound, samples.totalSize()));
  last.FirstSmoothness = last.LastSmoothness;
  last.AutomaticPriority = options.AutomaticPriority && noise.ToDetail < LittleNoise;
  const std::vector<double> masses = polish(samples, last, parallelFor, steps.next(), result);
  sharpenEdges(result, parallelFor, steps.next());
  steps.next();
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
  return result;
}
}
