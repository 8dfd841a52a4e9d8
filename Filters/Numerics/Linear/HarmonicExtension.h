/// Harmonic extension: solve for the free vertices of a mesh with fixed values at all other
/// vertices, \cite Pinkall1993.

#ifndef ConformalHarmonicExtension_h
#define ConformalHarmonicExtension_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

#include <vector>

namespace conformal
{
/// Compute values of the free vertices so that the weighted sum of the edges at each of them is
/// zero. Solved by Eigen's sparse Cholesky factorization, or for many vertices by
/// MultifrontalCholesky.
/// @param[in] places      #V by 3 points of the surface, for the elimination order
/// @param[in] free        ids of the free vertices, each once
/// @param[in,out] values  #V by the number of columns
/// @throws NumericalFailure if the matrix of the weights is not positive definite
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const Run& run = {});
}

#endif
