#include "Learn/AdaptiveTraining.h"

#include "Base/Steps.h"
#include "Learn/BatchTraining.h"
#include "Learn/HullStart.h"
#include "Learn/LeastSquaresPolish.h"
#include "Learn/NoiseEstimate.h"
#include "Learn/SurfaceSupport.h"
#include "Learn/SurfaceVerdict.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Remeshing.h"
#include "Mesh/SharpEdges.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Measured on scans, 12,962 neurons: more of these cost time and gain nothing. What was learned
// from the sphere meets the patterns already.
constexpr int FirstIterations = 6, Iterations = 3;    // of remeshing
constexpr int TurnsFromSphere = 1, TurnsFromHull = 3; // of polish and remeshing
constexpr int TurnsFromMesh = 1;
constexpr int RoundsFromSphere = 4, RoundsFromHull = 2; // of a turn of polish
constexpr Index SamplesOfTurn = 4;                      // in a round, for each neuron

// The hull is no finer than half an edge on an object of usual area.
constexpr double SpacingForEdge = 0.5, TypicalArea = 5.0;

constexpr double FirstSmoothness = 0.2; // of a turn: what was remeshed lies beside the patterns

// A tip lies far from a surface that has not come to it yet. Where the hull leaves patterns out,
// there are others like them near it.
constexpr double OutlierRatio = 10.0, OutlierRatioAmongStrays = 4.0, ManyStrays = 0.001;

// Noise shows beside a surface of a quarter of the vertices.
constexpr Index Coarser = 4;
constexpr int MinimumFrequency = 4; // of the lattice that is learned from the sphere
constexpr Index MinimumCoarse = 50; // vertices that can tell
constexpr double LittleNoise = 0.5;

// By how much vertices of objects lie off the middle of their neighbors, in squares of the edge
// length where the largest radius is 1. Measured: on Igea and the bunny with noise of 0.002 to 0.01
// this gives the best smoothness within a factor of two.
constexpr double TypicalBending = 4.0;

// What is left of the patterns of clean scans after a turn is less than this in edges, whatever
// the scan and the number of neurons; what noise leaves is more, once it is a sixth of an edge.
constexpr double LargeResidue = 0.12;
constexpr double SmoothnessOfResidue = 5.0; // of its square
constexpr double SameResidue = 1.1;         // ratio
constexpr int StiffTurns = 6;

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

/// Learning from the sphere on a lattice of a quarter of the vertices: what it leaves to the
/// polish is less than their distance.
ConformalSOMOptions coarseLattice(const ConformalSOMOptions& options)
{
  ConformalSOMOptions coarse = options;
  const Index neurons = options.NumberOfNeurons / Coarser;
  coarse.Frequency =
    std::max(MinimumFrequency, static_cast<int>(std::sqrt(0.1 * static_cast<double>(neurons))));
  return coarse;
}

/// The surface to begin with, in the samples' unit.
class FirstSurface
{
public:
  FirstSurface(const TrainingSamples& samples, const ConformalSOMOptions& options)
    : Samples(samples)
    , Options(coarseLattice(options))
    , MinimumSpacing(SpacingForEdge * edgeFor(TypicalArea, options.NumberOfNeurons))
  {
  }

  double work() const { return this->workFromSphere() + this->workFromHull(); }
  double vertices() const { return verticesOfHull(this->spacing()); }

  ConformalSOMResult fromMesh(const Mesh& start, const Run& run) const
  {
    requireGenusZero(start.Triangles, start.Positions.rows(), run);
    ConformalSOMResult result;
    static_cast<Mesh&>(result) = start;
    result.FromMesh = true;
    if (signedVolume(result.Positions, result.Triangles) < 0.0)
    {
      result.Triangles.col(1).swap(result.Triangles.col(2));
    }
    return result;
  }

  ConformalSOMResult fromSphereOrHull(PolishOptions& polishing, const Run& run) const
  {
    Steps steps(run, { this->workFromSphere(), this->workFromHull() });
    const Run learning = steps.next();
    if (this->mayStartFromSphere())
    {
      std::optional<ConformalSOMResult> learned =
        learnWithoutPolish(this->Samples, this->Options, learning);
      if (learned)
      {
        polishing.NumberOfRounds = RoundsFromSphere;
        polishing.OutlierRatio = OutlierRatioAmongStrays; // it has come to all tips
        return *std::move(learned);
      }
    }
    return this->fromHull(polishing, steps.next());
  }

private:
  bool mayStartFromSphere() const
  {
    return this->Options.StartingShape != StartingShape::Hull && this->Samples.dimension() == 3;
  }

  double workFromSphere() const
  {
    return this->mayStartFromSphere() ? workWithoutPolish(this->Samples, this->Options) : 0.0;
  }

  double spacing() const
  {
    return hullSpacing(this->Samples, this->Options.HullIndicator, this->MinimumSpacing);
  }

  double workFromHull() const
  {
    return workOfHull(this->Samples, this->spacing(), this->Options.HullIndicator);
  }

  ConformalSOMResult fromHull(PolishOptions& polishing, const Run& run) const
  {
    ConformalSOMResult result;
    GenusZeroHullResult hull =
      makeHull(this->Samples, this->MinimumSpacing, this->Options.HullIndicator, run);
    static_cast<Mesh&>(result) = hull;
    result.Hulled = true;
    result.Indicator = hull.Indicator;
    result.NormalsUsed = hull.NormalsUsed;
    result.HullLeaks = hull.Leaks;
    result.CutFraction = cutFraction(hull);
    result.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
    // Over what nobody has seen, winding numbers know better where the surface is than the points
    // across from there.
    if (hull.Indicator == HullIndicator::WindingNumbers)
    {
      polishing.Guide =
        std::make_shared<TriangleTree>(hull.Positions, hull.Triangles, run.unwatched());
    }
    const auto strays = static_cast<double>(hull.NumberOfSamplesOutside);
    if (strays > ManyStrays * static_cast<double>(this->Samples.totalSize()))
    {
      polishing.OutlierRatio = OutlierRatioAmongStrays;
    }
    polishing.Belongs = [data = std::move(hull.Data)](const Vector3& x)
    { return data.contains(x); };
    return result;
  }

  const TrainingSamples& Samples;
  const ConformalSOMOptions Options; ///< of the lattice that is learned from the sphere
  const double MinimumSpacing;       ///< of the hull
};

struct Noise
{
  double ToDetail = 0.0, Variance = 0.0;
};

/// From what the surface, polished, leaves of the patterns, beside what one of a quarter of its
/// vertices does.
Noise noiseBeside(const ConformalSOMResult& result, const TrainingSamples& samples,
  PolishOptions polishing, const Run& run)
{
  const Index neurons = result.Positions.rows() / Coarser;
  const Index patterns = polishing.SamplesPerRound / Coarser;
  if (neurons < MinimumCoarse)
  {
    return {};
  }
  Steps steps(run, { 1.0, 4.0, 4.0, 1.0 });
  const auto error = [&](const ConformalSOMResult& surface)
  {
    return typicalSquareError(
      samples, surface.Positions, surface.Triangles, patterns, steps.next());
  };
  const double fine = error(result);
  ConformalSOMResult coarse = result;
  remesh(coarse, remeshingTo(neurons, Iterations), steps.next());
  polishing.SamplesPerRound = patterns;
  polish(samples, polishing, coarse, steps.next());
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

/// The deviation of noise that would leave of the patterns what the surface does, in edges.
double residue(const TrainingSamples& samples, const PolishOptions& polishing,
  const ConformalSOMResult& result, const Run& run)
{
  const double error = typicalSquareError(samples, result.Positions, result.Triangles,
    polishing.SamplesPerRound / Coarser, run.unwatched());
  const double area = surfaceArea(result.Positions, result.Triangles);
  return std::sqrt(noiseVariance(error, error)) / edgeFor(area, result.Positions.rows());
}

/// The first turn of polish. A surface that follows noise crumples, and hides how large the noise
/// is. So where much is left of the patterns, the turn is repeated with a surface as stiff as that
/// asks for, until no more is left than was expected; those that follow are as stiff.
void firstPolish(const TrainingSamples& samples, PolishOptions& polishing,
  ConformalSOMResult& result, const Run& run)
{
  const Points before = result.Positions;
  constexpr double share = 0.95; // of the progress; noise is rare
  polish(samples, polishing, result, run.part(0.0, share));
  double expected = 0.0, left = residue(samples, polishing, result, run);
  for (int i = 0; i < StiffTurns && left > std::max(LargeResidue, SameResidue * expected); ++i)
  {
    polishing.AutomaticPriority = false;
    polishing.FirstSmoothness = polishing.LastSmoothness = SmoothnessOfResidue * left * left;
    result.Positions = before;
    const auto reached = [&](int turns) { return share + (1.0 - share) * turns / StiffTurns; };
    polish(samples, polishing, result, run.part(reached(i), reached(i + 1)));
    expected = left;
    left = residue(samples, polishing, result, run);
  }
}

ConformalSOMResult trainFrom(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const Mesh* start, const std::shared_ptr<const TriangleTree>& mesh, const Run& run)
{
  const Index neurons = options.NumberOfNeurons;
  PolishOptions polishing; // of a turn
  polishing.NumberOfRounds = RoundsFromHull;
  polishing.FirstSmoothness = std::max(options.Smoothness, FirstSmoothness);
  polishing.LastSmoothness = options.Smoothness;
  polishing.OutlierRatio = OutlierRatio;
  polishing.AutomaticPriority = options.AutomaticPriority;
  polishing.SamplesPerRound = std::min<Index>(options.SamplesPerNeuron, SamplesOfTurn) * neurons;
  polishing.RandomSeed = options.RandomSeed;
  polishing.Guide = mesh;
  PolishOptions last = polishing;
  last.SamplesPerRound = options.SamplesPerNeuron * neurons;
  last.NumberOfRounds = options.NumberOfPolishRounds;

  RemeshingOptions remeshing = remeshingTo(neurons, Iterations);
  const double ofPolish = workOfPolish(samples, polishing, neurons),
               ofRemeshing = workOfRemeshing(remeshing, neurons),
               ofLast = workOfPolish(samples, last, neurons);
  const auto workFrom = [&](double vertices, int turns)
  {
    std::vector<double> work = { workOfRemeshing(
      remeshingTo(neurons, FirstIterations), static_cast<Index>(vertices)) };
    for (int turn = 0; turn < turns; ++turn)
    {
      work.insert(work.end(), { ofPolish, ofRemeshing });
    }
    work.insert(work.end(),
      { (ofPolish + ofRemeshing) / Coarser, ofLast, workOfSharpEdges(neurons), 0.01 * ofLast,
        workOfVerdict(neurons) });
    return work;
  };
  const FirstSurface first(samples, options);
  std::vector<double> work = workFrom(
    start ? static_cast<double>(start->Positions.rows()) : first.vertices(), TurnsFromHull);
  work.insert(work.begin(), start ? 300.0 * start->Positions.rows() : first.work());
  Steps steps(run, work);
  ConformalSOMResult result =
    start ? first.fromMesh(*start, steps.next()) : first.fromSphereOrHull(polishing, steps.next());
  last.NumberOfRounds = options.NumberOfPolishRounds -
    std::min(options.NumberOfPolishRounds / 2, polishing.NumberOfRounds);
  last.OutlierRatio = polishing.OutlierRatio;
  last.Belongs = polishing.Belongs;
  last.Guide = polishing.Guide;
  const double areaAtFirst = surfaceArea(result.Positions, result.Triangles);
  const int turns = mesh ? TurnsFromMesh : start || result.Hulled ? TurnsFromHull : TurnsFromSphere;
  steps.replan(workFrom(static_cast<double>(result.Positions.rows()), turns));

  remesh(result, remeshingTo(neurons, FirstIterations), steps.next());
  for (int turn = 0; turn < turns; ++turn)
  {
    if (turn == 0)
    {
      firstPolish(samples, polishing, result, steps.next());
    }
    else
    {
      polish(samples, polishing, result, steps.next());
    }
    remeshing.MeetNumber = turn + 1 == turns;
    remesh(result, remeshing, steps.next());
  }
  const Noise noise = noiseBeside(result, samples, polishing, steps.next());
  result.NoiseToDetail = noise.ToDetail;
  result.Noise = std::sqrt(noise.Variance);
  last.LastSmoothness +=
    smoothnessFor(noise, result, std::min(last.SamplesPerRound, samples.totalSize()));
  last.FirstSmoothness = last.LastSmoothness;
  last.AutomaticPriority = options.AutomaticPriority && noise.ToDetail < LittleNoise;
  const std::vector<double> masses = polish(samples, last, result, steps.next());
  sharpenEdges(result, steps.next());
  steps.next();
  result.UnsupportedFraction =
    unsupportedFraction(samples, result.Positions, result.Triangles, masses);
  result.AreaRatio = surfaceArea(result.Positions, result.Triangles) / areaAtFirst;
  result.Verdict =
    judgeSurface(samples, result.Positions, result.Triangles, result.Noise, steps.next());
  return result;
}

/// Whether another start may mend what is wrong.
bool isBad(const ConformalSOMResult& result, const TrainingSamples& samples)
{
  return badness(withoutLeftOut(
           result.Verdict, result.NumberOfSamplesOutside, samples.totalSize())) > 1.0;
}
}

ConformalSOMResult trainAdaptive(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const Mesh* start, std::shared_ptr<const TriangleTree> mesh, const Run& run)
{
  // Webs in deep folds show only when the surface is polished, and so does most of what is wrong
  // with a start; then it is learned anew. That is rare, and little of the progress is kept for it.
  constexpr double webs = 0.001, share = 0.95;
  ConformalSOMResult best = trainFrom(samples, options, start, mesh, run.part(0.0, share));
  if (start || samples.dimension() < 3)
  {
    return best;
  }
  HullIndicator tried = best.Indicator; // of the last hull
  double begin = share;
  const auto startAnew = [&](HullIndicator indicator, bool anyway)
  {
    const double end = 0.5 * (begin + 1.0);
    ConformalSOMOptions hulled = options;
    hulled.StartingShape = StartingShape::Hull;
    hulled.HullIndicator = indicator;
    ConformalSOMResult next = trainFrom(samples, hulled, nullptr, nullptr, run.part(begin, end));
    begin = end;
    tried = next.Indicator;
    const int starts = best.NumberOfStarts + 1;
    if (anyway || badness(next.Verdict) < badness(best.Verdict))
    {
      best = std::move(next);
    }
    best.NumberOfStarts = starts;
  };
  const bool webbed = best.UnsupportedFraction > webs;
  bool hulled = best.Hulled;
  if (!hulled && options.StartingShape == StartingShape::Automatic &&
    (webbed || isBad(best, samples)))
  {
    startAnew(options.HullIndicator, webbed);
    hulled = true;
  }
  if (hulled && options.HullIndicator == HullIndicator::Automatic && isBad(best, samples))
  {
    startAnew(
      tried == HullIndicator::Distance ? HullIndicator::WindingNumbers : HullIndicator::Distance,
      false);
  }
  return best;
}
}
