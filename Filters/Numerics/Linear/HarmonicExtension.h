/// Harmonic extension: compute values at the free vertices of a mesh from fixed values at all other
/// vertices, \cite Pinkall1993.

#ifndef ConformalHarmonicExtension_h
#define ConformalHarmonicExtension_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

#include <vector>

namespace conformal
{
/// Compute values at the free vertices. At each free vertex, the weighted differences to its
/// neighbors' values then have the sum zero. The equations are solved by Eigen's sparse Cholesky
/// factorization, or for many vertices by MultifrontalCholesky.
/// @param[in] places      #V by 3 positions of the vertices; they determine only the elimination
///   order
/// @param[in] free        ids of the free vertices, each once
/// @param[in,out] values  #V rows; each column is a separate problem. Rows of free vertices are
///   computed, all others are given.
/// @throws NumericalFailure if the matrix of the weights is not positive definite
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const Run& run = {});
}

#endif
