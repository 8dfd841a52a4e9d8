/// Solve linear equations by preconditioned conjugate gradients, \cite Hestenes1952. Unlike
/// Eigen::ConjugateGradient, this function reports progress and can be aborted.

#ifndef ConformalConjugateGradients_h
#define ConformalConjugateGradients_h

#include "Base/Run.h"

#include <functional>

namespace conformal
{
struct ConjugateGradientsOptions
{
  int NumberOfSteps = 0; ///< maximum number of steps
  /// Let A x = b be the equations, and r = b - A x the residual. Let P be the preconditioner, which
  /// approximates the inverse of A. The iteration ends when the scalar product of r and P r is at
  /// most this fraction of its initial value.
  double Accuracy = 0.0;
};

/// Function that applies a linear map to the first argument and writes the result to the second
/// argument. Both arguments have the same size.
using LinearMap = std::function<void(const Points&, Points&)>;

/// Solve A x = b for the three columns of b, starting from x = 0. The matrix A and the
/// preconditioner must be symmetric positive definite.
/// @param[in,out] residual    on input, the right-hand side b. On return, the residual b - A x.
/// @param[in] product         function that computes A x
/// @param[in] preconditioned  preconditioner, a function that computes an approximation of A^-1 x
/// @return solution x
/// @throws Aborted
inline Points conjugateGradients(Points& residual, const LinearMap& product,
  const LinearMap& preconditioned, const ConjugateGradientsOptions& options, const Run& run = {})
{
  Points x = Points::Zero(residual.rows(), 3), direction = x, work(residual.rows(), 3);
  double square = 0.0, wanted = 0.0;
  for (int step = 0; step <= options.NumberOfSteps; ++step)
  {
    preconditioned(residual, work);
    const double before = square;
    square = residual.cwiseProduct(work).sum();
    wanted = step == 0 ? options.Accuracy * square : wanted;
    if (step == options.NumberOfSteps || !(square > wanted))
    {
      break;
    }
    direction = work + (step == 0 ? 0.0 : square / before) * direction;
    product(direction, work);
    const double length = square / direction.cwiseProduct(work).sum();
    x += length * direction;
    residual -= length * work;
    run.report((step + 1.0) / options.NumberOfSteps);
  }
  run.report(1.0);
  return x;
}
}

#endif
