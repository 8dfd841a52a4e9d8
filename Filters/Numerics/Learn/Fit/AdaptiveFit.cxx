#include "Learn/Fit/AdaptiveFit.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Learn/Fit/FairFit.h"
#include "Learn/Fit/LeastSquaresFit.h"
#include "Learn/Fit/NoiseEstimate.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Remeshing.h"
#include "Mesh/SharpEdges.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Measured on scans, 12,962 vertices: more iterations increase the cost without a gain.
constexpr int FirstIterations = 6, Iterations = 3; // of remeshing
constexpr Index SamplesOfTurn = 4;                 // in an iteration, for each vertex

// Meshes with more vertices than this number need less. Measured on the bunny with 60,000 vertices:
// the results are as close to the object as with the numbers above. Fewer samples in the final fit
// are not enough: they increase p2s by up to 9 %.
constexpr Index ManyVertices = 20000;
constexpr int FirstIterationsOfMany = 4, IterationsOfMany = 2; // of remeshing
constexpr Index SamplesOfTurnOfMany = 2;

constexpr double FirstSmoothness = 0.2; // of a turn, since remeshing moves vertices off the samples
// Iterations of the final fit that fairing replaces. If the points are noisy, more iterations make
// the surface rough, so that sharp edges are not found.
constexpr int IterationsOfFairing = 2, IterationsInNoise = 3;

// The noise is estimated beside a mesh of a quarter of the vertices.
constexpr Index Coarser = 4;
constexpr Index MinimumCoarse = 50; // vertices that are enough for an estimate
constexpr double LittleNoise = 0.5;

// The first of three turns determines the shape that the others refine. With more vertices than
// this number, it has a quarter of the vertices, at least this number. At 40,000 vertices, this
// would not save time. If the second turn had fewer vertices, too, the ends of thin limbs would be
// up to 18 % farther from the object.
constexpr Index CoarseVertices = 50000;

// Distance of vertices from the center of their neighbors, in squares of the edge length at maximum
// radius 1. Measured: on Igea and the bunny with noise of 0.002 to 0.01, this gives the best
// smoothness within a factor of two.
constexpr double TypicalBending = 4.0;

// Noise, in edge lengths, that crumples a surface that follows it. Fairing moves vertices along
// their normals, and cannot smooth a crumpled surface. With this noise, the smoothness is doubled.
// It increases by the fourth power of the noise, up to a maximum that keeps limbs.
constexpr double CrumplingNoise = 0.08, MaximumIncrease = 5.5;

// The residue of clean scans after a turn is smaller, in edge lengths, for any scan and number of
// vertices. It is larger if the noise exceeds a sixth of an edge.
constexpr double LargeResidue = 0.12;
constexpr double SmoothnessOfResidue = 5.0; // of its square
constexpr double SameResidue = 1.1;         // ratio
constexpr int StiffTurns = 6;

bool isLarge(Index vertices)
{
  return vertices > ManyVertices;
}

RemeshingOptions remeshingTo(Index vertices, bool first = false)
{
  RemeshingOptions options;
  options.NumberOfVertices = vertices;
  options.NumberOfIterations = isLarge(vertices)
    ? (first ? FirstIterationsOfMany : IterationsOfMany)
    : (first ? FirstIterations : Iterations);
  return options;
}

struct Noise
{
  double ToDetail = 0.0, Variance = 0.0;
};

/// Estimate the noise from the errors of a fitted mesh and of one of a quarter of its vertices.
Noise noiseBeside(const LearnedMesh& result, const TrainingSamples& samples,
  LeastSquaresFitOptions fitting, const Run& run)
{
  const Index vertices = result.Positions.rows() / Coarser;
  const Index count = fitting.SamplesPerIteration / Coarser;
  if (vertices < MinimumCoarse)
  {
    return {};
  }
  Steps steps(run, { 1.0, 4.0, 4.0, 1.0 });
  const auto error = [&](const LearnedMesh& surface) {
    return typicalSquareError(samples, surface.Positions, surface.Triangles, count, steps.next());
  };
  const double fine = error(result);
  LearnedMesh coarse = result;
  remesh(coarse, remeshingTo(vertices), steps.next());
  fitting.SamplesPerIteration = count;
  leastSquaresFit(samples, fitting, coarse, steps.next());
  const double rough = error(coarse);
  return { noiseToDetail(rough, fine), noiseVariance(rough, fine) };
}

/// Compute the smoothness, per sample of a vertex, at which noise and bending have equal weight. It
/// gives the most likely surface if both are Gaussian.
double smoothnessFor(const Noise& noise, const LearnedMesh& result, Index count)
{
  const auto vertices = static_cast<double>(result.Positions.rows());
  const double edge =
    equalEdgeLength(surfaceArea(result.Positions, result.Triangles), result.Positions.rows());
  const double bending = TypicalBending * edge * edge;
  const double crumpling = noise.Variance / (CrumplingNoise * CrumplingNoise * edge * edge);
  const double increase = std::min(1.0 + crumpling * crumpling, MaximumIncrease);
  return noise.Variance > 0.0
    ? increase * noise.Variance / (bending * bending * static_cast<double>(count) / vertices)
    : 0.0;
}

/// Compute the standard deviation of noise that explains the whole error of the surface, in edge
/// lengths.
double residue(const TrainingSamples& samples, const LeastSquaresFitOptions& fitting,
  const LearnedMesh& result, const Run& run)
{
  const double error = typicalSquareError(samples, result.Positions, result.Triangles,
    fitting.SamplesPerIteration / Coarser, run.unwatched());
  const double area = surfaceArea(result.Positions, result.Triangles);
  return std::sqrt(noiseVariance(error, error)) / equalEdgeLength(area, result.Positions.rows());
}

/// Fit the first turn. A surface that follows noise crumples, which hides the noise. If the residue
/// is large, repeat the turn with a stiffness for that residue, until the residue is as expected.
/// Later turns use that stiffness.
void firstFit(const TrainingSamples& samples, LeastSquaresFitOptions& fitting, LearnedMesh& result,
  const Run& run)
{
  const Points before = result.Positions;
  constexpr double share = 0.95; // of the progress; noise is rare
  leastSquaresFit(samples, fitting, result, run.part(0.0, share));
  double expected = 0.0, left = residue(samples, fitting, result, run);
  for (int i = 0; i < StiffTurns && left > std::max(LargeResidue, SameResidue * expected); ++i)
  {
    fitting.AutomaticPriority = false;
    fitting.FirstSmoothness = fitting.LastSmoothness = SmoothnessOfResidue * left * left;
    result.Positions = before;
    const auto reached = [&](int turns) { return share + (1.0 - share) * turns / StiffTurns; };
    leastSquaresFit(samples, fitting, result, run.part(reached(i), reached(i + 1)));
    expected = left;
    left = residue(samples, fitting, result, run);
  }
}

/// Move vertices onto sharp edges of the object. Return which vertices were moved.
std::vector<bool> sharpened(LearnedMesh& surface)
{
  const Points before = surface.Positions;
  sharpenEdges(surface);
  std::vector<bool> moved(before.rows());
  for (Index i = 0; i < before.rows(); ++i)
  {
    moved[i] = surface.Positions.row(i) != before.row(i);
  }
  return moved;
}

/// Make the surface fair, unless the samples are flat, and estimate the noise again. The variance
/// of the samples about a fair surface is that of the noise, unless there is more detail than
/// noise.
void fair(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Noise& noise, FittedMesh& result, const Run& run)
{
  if (samples.dimension() < 3 || options.Iterations == 0)
  {
    return;
  }
  constexpr double minimum = 1e-6, maximum = 1e6;
  FairFitOptions fairing;
  fairing.Smoothness = std::clamp(options.Smoothness, minimum, maximum);
  fairing.OutlierRatio = start.OutlierRatio;
  fairing.SamplesPerRound = options.SamplesPerVertex * options.NumberOfVertices;
  fairing.RandomSeed = options.RandomSeed;
  fairing.Belongs = start.Belongs;
  fairing.Creases = sharpened(result);
  try
  {
    FairFitResult faired = fairFit(samples, fairing, result, run);
    result.StandardError = std::move(faired.StandardError);
    result.DegreesOfFreedom = faired.DegreesOfFreedom;
    result.Noise = std::sqrt(std::min(1.0, noise.ToDetail) * faired.Variance);
  }
  catch (const NumericalFailure&)
  {
    // The surface of the least-squares fit is a result, too.
  }
}

/// Shares of the time, measured on scans: remeshing of the start, then for each turn the fit and
/// the remeshing, then the estimate of the noise, the last fit, fairing, sharp edges, and support.
Steps stepsOf(int turns, const Run& run)
{
  std::vector<double> shares = { 0.1 };
  for (int turn = 0; turn < turns; ++turn)
  {
    shares.insert(shares.end(), { 0.06, 0.05 });
  }
  shares.insert(shares.end(), { 0.03, 0.3, 0.3, 0.02, 0.02 });
  return { run, shares };
}
}

FittedMesh fitAdaptively(const TrainingSamples& samples, const AdaptiveFitOptions& options,
  const AdaptiveStart& start, const Run& run)
{
  const Index vertices = options.NumberOfVertices;
  LeastSquaresFitOptions fitting; // of a turn
  fitting.Iterations = start.IterationsPerTurn;
  fitting.LastSmoothness = FitOptions::UsualSmoothness * options.Smoothness;
  fitting.FirstSmoothness = std::max(fitting.LastSmoothness, FirstSmoothness);
  fitting.OutlierRatio = start.OutlierRatio;
  fitting.AutomaticPriority = options.AutomaticPriority;
  const Index samplesOfTurn =
    std::min(options.SamplesPerVertex, isLarge(vertices) ? SamplesOfTurnOfMany : SamplesOfTurn);
  fitting.SamplesPerIteration = samplesOfTurn * vertices;
  fitting.RandomSeed = options.RandomSeed;
  fitting.Guide = start.Guide;
  fitting.Belongs = start.Belongs;
  LeastSquaresFitOptions last = fitting;
  last.SamplesPerIteration = options.SamplesPerVertex * vertices;
  last.Iterations = options.Iterations -
    std::min(options.Iterations / 2, start.IterationsPerTurn + IterationsOfFairing);

  Steps steps = stepsOf(start.Turns, run);
  FittedMesh result;
  static_cast<LearnedMesh&>(result) = start;
  const double areaAtFirst = surfaceArea(result.Positions, result.Triangles);
  const auto observe = [&](const std::string& name)
  {
    if (options.Observer)
    {
      options.Observer(name, result);
    }
  };
  observe("start");
  const auto verticesOf = [&](int turn)
  {
    return turn + 2 < start.Turns ? std::min(vertices, std::max(CoarseVertices, vertices / Coarser))
                                  : vertices;
  };
  remesh(result, remeshingTo(verticesOf(0), true), steps.next());
  observe("remeshed");
  for (int turn = 0; turn < start.Turns; ++turn)
  {
    fitting.SamplesPerIteration = samplesOfTurn * verticesOf(turn);
    if (turn == 0 || verticesOf(turn) > verticesOf(turn - 1))
    {
      firstFit(samples, fitting, result, steps.next());
    }
    else
    {
      leastSquaresFit(samples, fitting, result, steps.next());
    }
    observe("turn " + std::to_string(turn + 1));
    RemeshingOptions remeshing = remeshingTo(verticesOf(turn + 1));
    remeshing.MeetNumber = turn + 1 == start.Turns;
    remesh(result, remeshing, steps.next());
  }
  const Noise noise = noiseBeside(result, samples, fitting, steps.next());
  result.NoiseToDetail = noise.ToDetail;
  result.Noise = std::sqrt(noise.Variance);
  last.LastSmoothness +=
    smoothnessFor(noise, result, std::min(last.SamplesPerIteration, samples.totalSize()));
  last.FirstSmoothness = last.LastSmoothness;
  const bool noisy = !(noise.ToDetail < LittleNoise);
  last.AutomaticPriority = options.AutomaticPriority && !noisy;
  last.Iterations -= noisy ? std::min(last.Iterations / 2, IterationsInNoise) : 0;
  const std::vector<double> masses = leastSquaresFit(samples, last, result, steps.next());
  fair(samples, options, start, noise, result, steps.next());
  sharpenEdges(result, steps.next());
  observe("fit");
  steps.next();
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / areaAtFirst;
  return result;
}
}
