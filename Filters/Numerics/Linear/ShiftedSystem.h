/// Solver of (A + lambda K) x = b for many lambda by one factorization.

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

/// Factor a symmetric, positive definite matrix of a mesh's vertices.
/// @param[in] places  a point for each unknown, for the order of elimination
/// @param[in] rings   of neighbors that the matrix couples to a vertex
/// @throws NumericalFailure as MultifrontalCholesky
MultifrontalCholesky factorize(
  const SparseMatrix& matrix, const Points& places, int rings, const Run& run = {});

/// Solutions x of (A + lambda K) x = b for all lambda within a factor of about 30 of a center c.
/// In the inner product of B = A + c K all of these matrices have the same Krylov space, that of
/// B^-1 A and B^-1 b, so a few steps of the method of \cite Lanczos1950 with the factor of B serve
/// them all.
class ShiftedSystem
{
public:
  /// @param[in] matrix  A, symmetric and positive semidefinite
  /// @param[in] factor  of B
  /// @param[in] center  c, above 0
  /// @param[in] right   columns b
  /// @param[in] steps   of each Krylov space; more make the range of lambda wider
  ShiftedSystem(const SparseMatrix& matrix, const MultifrontalCholesky& factor, double center,
    Columns right, int steps, const Run& run = {});

  /// x for a column of the right sides.
  Eigen::VectorXd solution(Index column, double lambda) const;

  /// b x, more accurate than x is: a Gauss quadrature.
  double product(Index column, double lambda) const;

private:
  struct Recurrence
  {
    std::vector<double> Diagonal, Beside;
    double Length = 0.0; ///< of B^-1 b
  };
  Eigen::VectorXd coefficients(const Recurrence& recurrence, double lambda) const;

  double Center;
  std::vector<Recurrence> Recurrences;
  std::vector<Columns> Basis; ///< of each step
};
}

#endif
