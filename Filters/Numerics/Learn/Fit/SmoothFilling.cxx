#include "Learn/Fit/SmoothFilling.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Cloud/SampleSpacing.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/SparseCore>

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

using SparseMatrix = Eigen::SparseMatrix<double>;

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

// Return the vertices to move: none if there are no gaps.
std::vector<int> verticesInGaps(const std::vector<double>& distances, double spacing, double noise)
{
  const double gap = std::max(GapSpacings * spacing, GapDeviations * noise);
  const double moved = std::max(MovedSpacings * spacing, MovedDeviations * noise);
  const auto size = static_cast<double>(distances.size());
  const auto inGaps = static_cast<double>(
    std::count_if(distances.begin(), distances.end(), [&](double d) { return d > gap; }));
  std::vector<int> vertices;
  if (inGaps < FewestInGaps * size)
  {
    return vertices;
  }
  for (int i = 0; i < static_cast<int>(distances.size()); ++i)
  {
    if (distances[i] > moved)
    {
      vertices.push_back(i);
    }
  }
  if (static_cast<double>(vertices.size()) > MostMoved * size)
  {
    vertices.clear();
  }
  return vertices;
}

// Matrix of the sums of differences from the neighbors, for given columns. All others are zero.
SparseMatrix laplacian(const Adjacency& neighbors, const std::vector<int>& columnOf, Index columns)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto size = static_cast<int>(columnOf.size());
  for (int i = 0; i < size; ++i)
  {
    if (columnOf[i] >= 0)
    {
      entries.emplace_back(i, columnOf[i], static_cast<double>(neighbors.size(i)));
    }
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      if (columnOf[*j] >= 0)
      {
        entries.emplace_back(i, columnOf[*j], -1.0);
      }
    }
  }
  SparseMatrix matrix(size, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Return the off-diagonal entries of a symmetric matrix, times -1, and its diagonal.
EdgeWeights weightsOf(const SparseMatrix& matrix, std::vector<double>& diagonal)
{
  EdgeWeights weights;
  weights.Neighbors.Offsets = { 0 };
  diagonal.assign(matrix.cols(), 0.0);
  for (int column = 0; column < static_cast<int>(matrix.cols()); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() == column)
      {
        diagonal[column] = entry.value();
      }
      else
      {
        weights.Neighbors.Ids.push_back(static_cast<int>(entry.row()));
        weights.Weights.push_back(-entry.value());
      }
    }
    weights.Neighbors.Offsets.push_back(static_cast<int>(weights.Neighbors.Ids.size()));
  }
  return weights;
}
}

//------------------------------------------------------------------------------
Index fillSmoothly(const TrainingSamples& samples, double noise, Points& positions,
  const Triangles& triangles, const Run& run)
{
  constexpr int rings = 2;
  Steps steps(run, { 0.3, 0.7 }); // distances, equations
  const Points selected = selectedSamples(samples, SamplesPerVertex * positions.rows());
  const double spacing =
    std::sqrt(surfaceArea(positions, triangles) / static_cast<double>(selected.rows()));
  const std::vector<int> moved =
    verticesInGaps(distancesFrom(selected, positions, steps.next()), spacing, noise);
  const auto size = static_cast<Index>(moved.size());
  if (size == 0)
  {
    return 0;
  }
  std::vector<int> columnOf(positions.rows(), -1);
  Points places(size, 3), fixed = positions;
  for (int k = 0; k < static_cast<int>(size); ++k)
  {
    columnOf[moved[k]] = k;
    places.row(k) = positions.row(moved[k]);
    fixed.row(moved[k]).setZero();
  }
  const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
  std::vector<int> all(positions.rows());
  for (int i = 0; i < static_cast<int>(all.size()); ++i)
  {
    all[i] = i;
  }
  const SparseMatrix ofMoved = laplacian(neighbors, columnOf, size);
  const SparseMatrix matrix = ofMoved.transpose() * ofMoved;
  Columns solution = -(ofMoved.transpose() * (laplacian(neighbors, all, positions.rows()) * fixed));
  std::vector<double> diagonal;
  const EdgeWeights weights = weightsOf(matrix, diagonal);
  try
  {
    MultifrontalCholesky(weights, diagonal, places, steps.next(), rings).solve(solution);
  }
  catch (const NumericalFailure&)
  {
    return 0; // The fitted surface stays as it is.
  }
  for (Index k = 0; k < size; ++k)
  {
    positions.row(moved[k]) = solution.row(k);
  }
  return size;
}
}
