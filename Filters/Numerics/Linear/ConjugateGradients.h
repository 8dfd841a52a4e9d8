/// Preconditioned conjugate gradients with progress and abort, \cite Hestenes1952. Eigen's solver
/// supports neither.

#ifndef ConformalConjugateGradients_h
#define ConformalConjugateGradients_h

#include "Base/Run.h"

#include <functional>

namespace conformal
{
struct ConjugateGradientsOptions
{
  int NumberOfSteps = 0; ///< maximum number of steps
  /// Square residual, in the norm of the preconditioner, relative to the initial one at which to
  /// stop.
  double Accuracy = 0.0;
};

/// Linear map: writes its result into the second argument, of the size of the first.
using LinearMap = std::function<void(const Points&, Points&)>;

/// Solve A x = b from x = 0 for symmetric positive definite A and preconditioner.
/// @param[in,out] residual    b; on return the residual b - A x
/// @param[in] product         compute A x
/// @param[in] preconditioned  approximate A^-1 x
/// @return x
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
