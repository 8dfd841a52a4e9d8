#include "Learn/Fit/SmoothFilling.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Cloud/SampleSpacing.h"
#include "Learn/Fit/FlatBases.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index SamplesPerVertex = 4;

// Distances from samples, in spacings and in standard deviations of the noise: of vertices that are
// moved, and of vertices that show a gap.
constexpr double MovedSpacings = 1.5, MovedDeviations = 3.0;
constexpr double GapSpacings = 2.0, GapDeviations = 4.0;
constexpr double FewestInGaps = 0.002, MostMoved = 0.8; // fractions of the vertices

std::vector<double> distancesFrom(const Points& samples, const Points& positions, const Run& run)
{
  constexpr Index blockSize = 256;
  const PointTree tree(samples, run.unwatched());
  std::vector<double> distances(positions.rows());
  forBlocksReporting(run, positions.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        distances[i] = std::sqrt(tree.nearest(positions.row(i)).SquareDistance);
      }
    });
  return distances;
}

std::vector<int> fartherThan(double limit, const std::vector<double>& distances)
{
  std::vector<int> vertices;
  for (int i = 0; i < static_cast<int>(distances.size()); ++i)
  {
    if (distances[i] > limit)
    {
      vertices.push_back(i);
    }
  }
  return vertices;
}

// Return the vertices to move: none if there are no gaps.
std::vector<int> verticesInGaps(const std::vector<double>& distances, double spacing, double noise)
{
  const double gap = std::max(GapSpacings * spacing, GapDeviations * noise);
  const double moved = std::max(MovedSpacings * spacing, MovedDeviations * noise);
  const auto size = static_cast<double>(distances.size());
  const auto inGaps = static_cast<double>(
    std::count_if(distances.begin(), distances.end(), [&](double d) { return d > gap; }));
  if (inGaps < FewestInGaps * size)
  {
    return {};
  }
  std::vector<int> vertices = fartherThan(moved, distances);
  if (static_cast<double>(vertices.size()) > MostMoved * size)
  {
    vertices.clear();
  }
  return vertices;
}

// Return the typical distance of neighboring samples across scan lines, if there are any, else in
// any direction. Six samples lie in a circle of this radius times the square root of 6 / pi.
double spacingOfRows(const Points& samples)
{
  constexpr Index step = 7;
  const SampleSpacing spacing(samples);
  std::vector<double> radii;
  std::vector<Neighbor> around;
  for (Index i = 0; i < samples.rows(); i += step)
  {
    radii.push_back(spacing.at(i, around).Radius);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle * std::sqrt(Pi / 6.0);
}

// Matrix of the sums of differences from the neighbors.
SparseMatrix laplacian(const Adjacency& neighbors, Index size)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < static_cast<int>(size); ++i)
  {
    entries.emplace_back(i, i, static_cast<double>(neighbors.size(i)));
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      entries.emplace_back(i, *j, -1.0);
    }
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}

//------------------------------------------------------------------------------
Index fillSmoothly(const TrainingSamples& samples, double noise, Points& positions,
  const Triangles& triangles, const Run& run)
{
  constexpr int rings = 2;
  Steps steps(run, { 0.3, 0.6, 0.1 }); // distances, equations, flat bases
  const Points selected = selectedSamples(samples, SamplesPerVertex * positions.rows());
  const double spacing =
    std::sqrt(surfaceArea(positions, triangles) / static_cast<double>(selected.rows()));
  const std::vector<double> distances = distancesFrom(selected, positions, steps.next());
  const std::vector<int> moved = verticesInGaps(distances, spacing, noise);
  const auto size = static_cast<Index>(moved.size());
  if (size == 0)
  {
    return 0;
  }
  std::vector<Eigen::Triplet<double>> ones;
  Points places(size, 3), fixed = positions;
  for (int k = 0; k < static_cast<int>(size); ++k)
  {
    ones.emplace_back(moved[k], k, 1.0);
    places.row(k) = positions.row(moved[k]);
    fixed.row(moved[k]).setZero();
  }
  SparseMatrix toVertices(positions.rows(), size);
  toVertices.setFromTriplets(ones.begin(), ones.end());
  const SparseMatrix all =
    laplacian(vertexNeighbors(triangles, positions.rows()), positions.rows());
  const SparseMatrix ofMoved = all * toVertices;
  const SparseMatrix matrix = ofMoved.transpose() * ofMoved;
  Columns solution = -(ofMoved.transpose() * (all * fixed));
  try
  {
    factorize(matrix, places, rings, steps.next()).solve(solution);
  }
  catch (const NumericalFailure&)
  {
    return 0; // The fitted surface stays as it is.
  }
  for (Index k = 0; k < size; ++k)
  {
    positions.row(moved[k]) = solution.row(k);
  }
  // The gaps between scan lines are no bases.
  const double ofRows = std::max(spacing, spacingOfRows(selected));
  flattenBases(selected,
    fartherThan(std::max(MovedSpacings * ofRows, MovedDeviations * noise), distances), ofRows,
    0.5 * (ofRows - spacing), positions, triangles, steps.next());
  return size;
}
}
