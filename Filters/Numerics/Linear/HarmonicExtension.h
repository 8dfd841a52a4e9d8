/// Compute a harmonic extension, \cite Pinkall1993. Values at some vertices of a mesh (free
/// vertices) are computed from given values at all other vertices.

#ifndef ConformalHarmonicExtension_h
#define ConformalHarmonicExtension_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

#include <vector>

namespace conformal
{
/// Solve linear equations of a symmetric, positive definite matrix. The off-diagonal entries are
/// the weights times -1. The equations are solved by Eigen's sparse Cholesky factorization. For
/// 20,000 unknowns or more, the class MultifrontalCholesky is used instead. MultifrontalCholesky is
/// faster and uses several threads.
/// @param[in] places  position of each unknown; determines only the sequence in which unknowns are
///   eliminated
/// @param[in,out] columns  on input, the right-hand sides. On return, the solutions.
/// @throws NumericalFailure if the matrix is not positive definite, or MultifrontalCholesky cannot
///   divide the unknowns by their positions
/// @throws Aborted
void solveByCholesky(const EdgeWeights& weights, const std::vector<double>& diagonal,
  const Points& places, Columns& columns, const Run& run = {});

/// Compute the values at the free vertices from the values at all other vertices. In the result,
/// each free vertex has the weighted mean of the values of its neighbors. The equations are solved
/// by solveByCholesky().
/// @param[in] places      #V by 3 positions of the vertices. Positions determine only the sequence
///   in which unknowns are eliminated.
/// @param[in] free        ids of the free vertices, each once
/// @param[in,out] values  #V rows; each column is a separate problem. Rows of free vertices are
///   computed; the other rows are given.
/// @throws NumericalFailure if the matrix of the equations is not positive definite
void extendHarmonically(const EdgeWeights& weights, const Points& places,
  const std::vector<int>& free, Columns& values, const Run& run = {});
}

#endif
