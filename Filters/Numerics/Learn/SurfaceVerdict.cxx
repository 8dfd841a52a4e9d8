#include "Learn/SurfaceVerdict.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/Orientation.h"
#include "Cloud/StrayPoints.h"
#include "Cloud/WindingNumbers.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
constexpr double AskedSamples = 10000.0;
constexpr Index MinimumSamples = 20; // of which anything can be told
constexpr Index BlockSize = 256;

// In nanoseconds as in Steps: for each vertex, for each sample asked.
constexpr double WorkOfTree = 1300.0, WorkOfFoot = 1500.0, WorkOfNumbers = 14000.0;

// Wide enough for the sides of a surface that lie on the same samples to cancel.
constexpr double WidthOfSpacing = 1.0, WidthOfNoise = 2.5;

double foldedFraction(const Points& positions, const Triangles& triangles)
{
  constexpr double cosine = -0.866; // of 150 degrees
  Points normals(triangles.rows(), 3);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    normals.row(r) = areaVector(positions, triangles, r).stableNormalized();
  }
  const Triangles across = triangleNeighbors(triangles, positions.rows());
  Index folded = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = across(r, k);
      folded += other > r && normals.row(r).dot(normals.row(other)) < cosine;
    }
  }
  return static_cast<double>(folded) / (1.5 * static_cast<double>(triangles.rows()));
}

// Where samples meet the surface.
struct Feet
{
  Points Normals; // #P by 3, of its triangles
  std::vector<double> Distances;
};

Feet feetOf(
  const Points& points, const Points& positions, const Triangles& triangles, const Run& run)
{
  Steps steps(run,
    { WorkOfTree * static_cast<double>(positions.rows()),
      WorkOfFoot * static_cast<double>(points.rows()) });
  const TriangleTree tree(positions, triangles, steps.next());
  Feet feet;
  feet.Normals.resize(points.rows(), 3);
  feet.Distances.resize(points.rows());
  forBlocksReporting(steps.next(), points.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = tree.closestPoint(points.row(i), hint);
        hint = foot.Triangle;
        feet.Normals.row(i) = areaVector(positions, triangles, hint).stableNormalized();
        feet.Distances[i] = std::sqrt(foot.SquareDistance);
      }
    });
  return feet;
}

// How much of the object each sample stands for: those of sparse parts for more than those of dense
// ones, and outliers for none. What counts is how much its neighbors have around them, so that a few
// points by themselves are not taken for a large part.
std::vector<double> weightsOf(const Points& points, const Run& run)
{
  constexpr double far = 2.5;
  constexpr int few = 4, neighbors = 8, lowest = 2;
  const std::vector<double> areas = areasOfPoints(points, few, run);
  const std::vector<std::uint8_t> isolated = isolatedPoints(points, far, run);
  const PointTree tree(points, run);
  std::vector<double> weights(areas.size(), 0.0), around;
  std::vector<Neighbor> nearest;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    if (isolated[i])
    {
      continue;
    }
    tree.nearest(points.row(static_cast<Index>(i)), neighbors, nearest);
    around.clear();
    for (const Neighbor& neighbor : nearest)
    {
      around.push_back(areas[neighbor.Id]);
    }
    std::nth_element(around.begin(), around.begin() + lowest, around.end());
    weights[i] = around[lowest];
  }
  return weights;
}

// Directions in which the surface should face at the points.
Points outwardDirections(
  const OrientedPoints& asked, const Points& normals, double width, const Run& run)
{
  const WindingNumbers numbers(asked.Positions, run);
  if (asked.Normals.rows() > 0)
  {
    Points areas = areaVectors(asked.Positions, asked.Normals, run);
    if (turnOutward(numbers, areas, width, run))
    {
      return areas;
    }
  }
  return numbers.descentAtPoints(areaVectors(asked.Positions, normals, run), width, run);
}
}

//------------------------------------------------------------------------------
double workOfVerdict(Index numberOfVertices)
{
  return WorkOfTree * static_cast<double>(numberOfVertices) +
    (WorkOfFoot + WorkOfNumbers) * AskedSamples;
}

//------------------------------------------------------------------------------
SurfaceVerdict judgeSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run)
{
  constexpr double distanceOfSpacing = 1.5, distanceOfNoise = 5.0;
  SurfaceVerdict verdict;
  verdict.FoldedFraction = foldedFraction(positions, triangles);
  const OrientedPoints asked = selectSamples(samples, AskedSamples);
  const Index size = asked.Positions.rows();
  if (size < MinimumSamples || samples.dimension() < 3)
  {
    return verdict;
  }
  Steps steps(run,
    { WorkOfTree * static_cast<double>(positions.rows()) + WorkOfFoot * static_cast<double>(size),
      WorkOfNumbers * static_cast<double>(size) });
  const Feet feet = feetOf(asked.Positions, positions, triangles, steps.next());
  steps.next();
  const double spacing = typicalSpacing(asked.Positions, run.unwatched());
  const double spacingOfAll =
    spacing * std::sqrt(static_cast<double>(size) / static_cast<double>(samples.totalSize()));
  const Points outward = outwardDirections(
    asked, feet.Normals, std::max(WidthOfSpacing * spacing, WidthOfNoise * noise), run.unwatched());
  const double near = std::max(distanceOfSpacing * spacingOfAll, distanceOfNoise * noise);
  const std::vector<double> weights = weightsOf(asked.Positions, run.unwatched());
  double counted = 0.0, unmet = 0.0, inverted = 0.0;
  for (Index i = 0; i < size; ++i)
  {
    counted += weights[i];
    if (feet.Distances[i] > near)
    {
      unmet += weights[i];
    }
    else if (feet.Normals.row(i).dot(outward.row(i)) < 0.0)
    {
      inverted += weights[i];
    }
  }
  if (counted > 0.0)
  {
    verdict.UnmetFraction = unmet / counted;
    verdict.InvertedFraction = inverted / counted;
  }
  return verdict;
}

//------------------------------------------------------------------------------
SurfaceVerdict withoutLeftOut(SurfaceVerdict verdict, Index leftOut, Index all)
{
  verdict.UnmetFraction -= static_cast<double>(leftOut) / static_cast<double>(all);
  return verdict;
}

//------------------------------------------------------------------------------
double badness(const SurfaceVerdict& verdict)
{
  using Tolerated = ToleratedVerdict;
  return std::max({ verdict.UnmetFraction / Tolerated::UnmetFraction,
    verdict.InvertedFraction / Tolerated::InvertedFraction,
    verdict.FoldedFraction / Tolerated::FoldedFraction });
}
}
