#include "Linear/HarmonicExtension.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/MultifrontalCholesky.h"

#include <Eigen/SparseCholesky>

#include <stdexcept>

namespace conformal
{
namespace
{
// Minimum number of unknowns for the multifrontal factorization. For 134,000 unknowns, the
// multifrontal factorization is about three times as fast as Eigen's. It also reports progress and
// can be aborted.
constexpr Index LargeSystem = 20000;

void solveByEigen(const EdgeWeights& weights, const std::vector<double>& diagonal, Columns& columns)
{
  std::vector<Eigen::Triplet<double>> entries;
  const int size = static_cast<int>(diagonal.size());
  for (int i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, diagonal[i]);
    for (int k = weights.Neighbors.Offsets[i]; k < weights.Neighbors.Offsets[i + 1]; ++k)
    {
      if (weights.Neighbors.Ids[k] < i)
      {
        entries.emplace_back(i, weights.Neighbors.Ids[k], -weights.Weights[k]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success)
  {
    throw NumericalFailure("the matrix is not positive definite");
  }
  columns = factor.solve(columns).eval();
}
}

//------------------------------------------------------------------------------
void solveByCholesky(const EdgeWeights& weights, const std::vector<double>& diagonal,
  const Points& places, Columns& columns, const Run& run)
{
  if (places.rows() < LargeSystem)
  {
    solveByEigen(weights, diagonal, columns);
    return;
  }
  Steps steps(run, { 0.88, 0.12 }); // factor, solution
  const MultifrontalCholesky factor(weights, diagonal, places, steps.next());
  steps.next();
  factor.solve(columns);
}

//------------------------------------------------------------------------------
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const Run& run)
{
  const Index size = static_cast<Index>(free.size());
  if (size == 0)
  {
    return;
  }
  Steps steps(run, { 0.01, 0.99 }); // matrix, solution
  steps.next();
  std::vector<int> unknowns(places.rows(), -1);
  for (Index i = 0; i < size; ++i)
  {
    unknowns[free[i]] = static_cast<int>(i);
  }
  EdgeWeights inner;
  inner.Neighbors.Offsets = { 0 };
  std::vector<double> diagonal(size);
  Points innerPlaces(size, 3);
  Columns solution = Columns::Zero(size, values.cols());
  for (Index i = 0; i < size; ++i)
  {
    const int v = free[i];
    innerPlaces.row(i) = places.row(v);
    diagonal[i] = weights.sumAt(v);
    for (int k = weights.Neighbors.Offsets[v]; k < weights.Neighbors.Offsets[v + 1]; ++k)
    {
      const int other = weights.Neighbors.Ids[k];
      if (unknowns[other] >= 0)
      {
        inner.Neighbors.Ids.push_back(unknowns[other]);
        inner.Weights.push_back(weights.Weights[k]);
      }
      else
      {
        solution.row(i) += weights.Weights[k] * values.row(other);
      }
    }
    inner.Neighbors.Offsets.push_back(static_cast<int>(inner.Neighbors.Ids.size()));
  }
  solveByCholesky(inner, diagonal, innerPlaces, solution, steps.next());
  for (Index i = 0; i < size; ++i)
  {
    values.row(free[i]) = solution.row(i);
  }
}
}
