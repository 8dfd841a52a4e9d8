#include "HarmonicExtension.h"

namespace conformal
{
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const ParallelFor& parallelFor,
  const Progress& progress)
{
  const Index size = static_cast<Index>(free.size());
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
  const MultifrontalCholesky factor(inner, diagonal, innerPlaces, parallelFor, progress);
  factor.solve(solution);
  for (Index i = 0; i < size; ++i)
  {
    values.row(free[i]) = solution.row(i);
  }
}
}
