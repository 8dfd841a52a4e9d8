/// Harmonic extension: solves for the free vertices of a mesh whose other vertices are fixed.

#ifndef ConformalHarmonicExtension_h
#define ConformalHarmonicExtension_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

#include <vector>

namespace conformal
{
/// Put the free vertices where the weighted sum of the edges at each of them is zero: with Eigen's
/// sparse Cholesky factor, or, if there are many, with MultifrontalCholesky.
/// @param[in] places      #V by 3 points of the surface, for the order of elimination
/// @param[in] free        ids of the vertices that move, each once
/// @param[in,out] values  #V by the number of columns
/// @throws NumericalFailure if the weights are not those of a membrane: not positive definite
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const Run& run = {});
}

#endif
