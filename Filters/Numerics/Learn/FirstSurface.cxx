#include "Learn/FirstSurface.h"

#include "Learn/Batch/BatchTraining.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Numbers of turns of the fit. Measured on scans with 12,962 neurons: more turns increase the cost
// without improving the result. A surface learned from the sphere needs one turn, since it already
// fits the samples.
constexpr int TurnsFromSphere = 1, TurnsFromHull = 3, TurnsFromOwnMesh = 1;
constexpr int IterationsFromSphere = 4, IterationsFromHull = 2;

// Distance from the surface at which a sample is an outlier, relative to the usual distance nearby.
// The limit is high for a hull that may not reach limb ends. If the hull left out many samples
// (strays), further outliers are nearby, and the limit is low. A surface learned from the sphere
// has reached all limb ends, so its limit is also low.
constexpr double OutlierRatio = 10.0, OutlierRatioAmongStrays = 4.0, ManyStrays = 0.001;

// Tolerances for a coarse network: fraction of unsupported area, and fraction of obtuse triangles.
// The coarse network already has most of the webs and stretched triangles of the fitted mesh.
// Smaller defects are tolerated, since a start from a hull has a higher cost. The fit increases the
// number of obtuse triangles by a quarter (measured).
constexpr double ToleratedArea = 0.001, ToleratedTriangles = 0.2, ObtuseByFit = 1.25;

constexpr Index Coarser = 4;        // factor of fewer neurons while learning from the sphere
constexpr int MinimumFrequency = 4; // minimum frequency of the network with fewer neurons

// Finest spacing of the hull's grid, below the default spacing of hulls. With this spacing, pockets
// such as the hollow of an ear fold less often when the surface is pulled into them. Measured: with
// 0.016 learning is faster by a third; with 0.010 the result is no better.
constexpr double FinestSpacing = 0.012;

// The spacing is chosen for an object of this area, with a maximum radius of 1. Sparse samples
// would have gaps on a finer grid. The spacing is at least half an edge of the mesh.
constexpr double TypicalArea = 5.0, SpacingForEdge = 0.5;

bool spansGapsOrLimbs(
  const LearnedMesh& mesh, const std::vector<double>& masses, const TrainingSamples& samples)
{
  return ObtuseByFit * obtuseFraction(mesh.Positions, mesh.Triangles) > ToleratedTriangles ||
    unsupportedFraction(samples, mesh.Positions, mesh.Triangles, masses) > ToleratedArea;
}

/// Compute the spacing of the hull's grid, in units of the maximum radius. If the hull is made by
/// winding numbers, the grid may be finer than the spacing of the samples.
double hullSpacing(const TrainingSamples& samples, Index neurons, HullMethod method)
{
  constexpr double coarsest = GenusZeroHullLimits::MaximumSpacing;
  const double factor = method == HullMethod::WindingNumbers ? 0.25 : 0.6;
  const double forMesh = SpacingForEdge * equalEdgeLength(TypicalArea, neurons);
  return std::clamp(factor * std::sqrt(TypicalArea / static_cast<double>(samples.totalSize())),
    std::clamp(forMesh, FinestSpacing, coarsest), coarsest);
}

GenusZeroHullResult makeHull(
  const TrainingSamples& samples, Index neurons, HullMethod method, HullGenus genus, const Run& run)
{
  const auto optionsFor = [&](HullMethod by)
  {
    GenusZeroHullOptions options;
    options.Method = by;
    options.Genus = genus;
    options.Spacing = hullSpacing(samples, neurons, by);
    return options;
  };
  return method == HullMethod::Automatic ? chooseHull(samples, optionsFor(HullMethod::Distance),
                                             optionsFor(HullMethod::WindingNumbers), run)
                                         : makeGenusZeroHull(samples, optionsFor(method), run);
}
}

void requireNear(const Points& mesh)
{
  constexpr double farthest = 4.0;
  const double reached = mesh.cwiseAbs().maxCoeff();
  if (!(reached <= farthest))
  {
    std::ostringstream text;
    text
      << "the starting mesh extends " << reached
      << " times as far from the middle of the points as the points do; move and scale it to them";
    throw std::invalid_argument(text.str());
  }
}

FirstSurface firstSurfaceFromSphere(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MeshObserver& observer, const Run& run)
{
  BatchTrainingOptions coarse;
  static_cast<BatchOptions&>(coarse) = options.Batch;
  const Index neurons = options.NumberOfNeurons / Coarser;
  coarse.Frequency =
    std::max(MinimumFrequency, static_cast<int>(std::sqrt(0.1 * static_cast<double>(neurons))));
  coarse.ReferencePoint = options.ReferencePoint;
  coarse.RandomSeed = options.RandomSeed;
  coarse.Observer = observer;
  const bool anyway = options.StartingShape == StartingShape::Sphere;
  FittedMesh learned = learnFromSphere(
    samples, coarse,
    [&](const LearnedMesh& mesh, const std::vector<double>& masses)
    { return anyway || !spansGapsOrLimbs(mesh, masses, samples); },
    run);
  FirstSurface first;
  static_cast<LearnedMesh&>(first) = std::move(static_cast<LearnedMesh&>(learned));
  first.Turns = TurnsFromSphere;
  first.IterationsPerTurn = IterationsFromSphere;
  first.OutlierRatio = OutlierRatioAmongStrays;
  return first;
}

FirstSurface firstSurfaceFromHull(const TrainingSamples& samples,
  const ConformalSOMOptions& options, HullMethod method, const Run& run)
{
  GenusZeroHullResult hull = makeHull(samples, options.NumberOfNeurons, method, options.Genus, run);
  FirstSurface first;
  static_cast<Mesh&>(first) = hull;
  first.Report.FromHull = true;
  first.Report.Hull = hull.Method;
  first.Report.NormalsUsed = hull.NormalsUsed;
  first.Report.HullLeaks = hull.Leaks;
  first.Report.CutFraction = cutFraction(hull);
  first.Report.NumberOfSamplesOutside = hull.NumberOfSamplesOutside;
  first.Turns = TurnsFromHull;
  first.IterationsPerTurn = IterationsFromHull;
  const auto strays = static_cast<double>(hull.NumberOfSamplesOutside);
  first.OutlierRatio = strays > ManyStrays * static_cast<double>(samples.totalSize())
    ? OutlierRatioAmongStrays
    : OutlierRatio;
  // In regions without samples, keep the hull: its winding-number surface extrapolates better than
  // projection onto distant samples.
  if (hull.Method == HullMethod::WindingNumbers)
  {
    first.Guide = std::make_shared<TriangleTree>(hull.Positions, hull.Triangles, run.unwatched());
  }
  first.Belongs = [data = std::move(hull.Data)](const Vector3& x) { return data.contains(x); };
  return first;
}

FirstSurface firstSurfaceFromMesh(
  const Mesh& mesh, std::shared_ptr<const TriangleTree> guide, const Run& run)
{
  requireNear(mesh.Positions);
  requireGenusZero(mesh.Triangles, mesh.Positions.rows(), run);
  FirstSurface first;
  static_cast<Mesh&>(first) = mesh;
  if (signedVolume(first.Positions, first.Triangles) < 0.0)
  {
    first.Triangles.col(1).swap(first.Triangles.col(2));
  }
  first.Report.FromMesh = true;
  first.Turns = guide ? TurnsFromOwnMesh : TurnsFromHull;
  first.IterationsPerTurn = IterationsFromHull;
  first.OutlierRatio = OutlierRatio;
  first.Guide = std::move(guide);
  return first;
}

OrientedPoints withPointsBetween(const Mesh& surface, Index wanted)
{
  const double share =
    surfaceArea(surface.Positions, surface.Triangles) / static_cast<double>(wanted);
  std::vector<double> between, normals;
  // A surface without area gets no points.
  for (Index r = 0; share > 0.0 && r < surface.Triangles.rows(); ++r)
  {
    const Vector3 a = surface.Positions.row(surface.Triangles(r, 0)),
                  ab = Vector3(surface.Positions.row(surface.Triangles(r, 1))) - a,
                  ac = Vector3(surface.Positions.row(surface.Triangles(r, 2))) - a;
    // Divide the triangle into n^2 equal triangles, and add the center of each.
    const int n = static_cast<int>(std::sqrt(0.5 * ab.cross(ac).norm() / share));
    const Vector3 normal = ab.cross(ac).stableNormalized();
    const auto add = [&](double u, double v)
    {
      const Vector3 x = a + u / n * ab + v / n * ac;
      between.insert(between.end(), x.data(), x.data() + 3);
      normals.insert(normals.end(), normal.data(), normal.data() + 3);
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        add(i + 1.0 / 3.0, j + 1.0 / 3.0);
        if (i + j + 1 < n)
        {
          add(i + 2.0 / 3.0, j + 2.0 / 3.0);
        }
      }
    }
  }
  const auto count = static_cast<Index>(between.size()) / 3;
  const Index size = surface.Positions.rows() + count;
  OrientedPoints points = { Points(size, 3), Points(size, 3) };
  points.Positions << surface.Positions, Eigen::Map<const Points>(between.data(), count, 3);
  points.Normals << vertexNormals(surface.Positions, surface.Triangles),
    Eigen::Map<const Points>(normals.data(), count, 3);
  return points;
}
}
