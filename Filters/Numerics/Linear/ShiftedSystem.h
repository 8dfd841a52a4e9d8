/// Solve (A + lambda K) x = b for given symmetric matrices A and K and many numbers lambda. One
/// factorization is sufficient, by the method of \cite Lanczos1950.

#ifndef ConformalShiftedSystem_h
#define ConformalShiftedSystem_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/MultifrontalCholesky.h"

#include <Eigen/SparseCore>

#include <vector>

namespace conformal
{
using SparseMatrix = Eigen::SparseMatrix<double>; ///< by columns

/// Factor a symmetric, positive definite matrix whose unknowns belong to the vertices of a mesh.
/// @param[in] places  position of each unknown; determines only the elimination order (the sequence
///   in which unknowns are eliminated)
/// @param[in] rings  number of rings of neighbors that the matrix couples to a vertex; 1 for direct
///   neighbors
/// @throws NumericalFailure if the constructor of MultifrontalCholesky throws it
MultifrontalCholesky factorize(
  const SparseMatrix& matrix, const Points& places, int rings, const Run& run = {});

/// Represent the solutions x of (A + lambda K) x = b for all lambda near a given center c.
/// Solutions are accurate if lambda / c is between about 1/30 and 30.
///
/// Let B = A + c K. For each lambda, the solution is approximated in the Krylov space of the matrix
/// B^-1 A and the vector B^-1 b. This space is the same for all lambda. The space is computed by a
/// few steps of the Lanczos method. Each step solves one system of equations with the factor of B.
class ShiftedSystem
{
public:
  /// @param[in] matrix  A, symmetric and positive semidefinite
  /// @param[in] factor  Cholesky factor of B
  /// @param[in] center  number c, above 0
  /// @param[in] right  right-hand sides b, one in each column
  /// @param[in] steps  dimension of each Krylov space; a larger space is accurate for a wider range
  ///   of lambda
  ShiftedSystem(const SparseMatrix& matrix, const MultifrontalCholesky& factor, double center,
    Columns right, int steps, const Run& run = {});

  /// Return the solution x for one column of the right-hand sides.
  Eigen::VectorXd solution(Index column, double lambda) const;

  /// Return the inner product of b and x. The product is computed by a Gauss quadrature. Therefore,
  /// the product is more accurate than x.
  double product(Index column, double lambda) const;

private:
  struct Recurrence
  {
    std::vector<double> Diagonal, Beside;
    double Length = 0.0; ///< length of B^-1 b in the inner product of B
  };
  Eigen::VectorXd coefficients(const Recurrence& recurrence, double lambda) const;

  double Center;
  std::vector<Recurrence> Recurrences;
  std::vector<Columns> Basis; ///< basis vectors of each step
};
}

#endif
