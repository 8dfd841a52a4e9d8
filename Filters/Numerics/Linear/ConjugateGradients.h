/// Preconditioned conjugate gradients that can be stopped. Eigen's cannot.

#ifndef ConformalConjugateGradients_h
#define ConformalConjugateGradients_h

#include "Base/Run.h"

#include <functional>

namespace conformal
{
struct ConjugateGradientsOptions
{
  int NumberOfSteps = 0; ///< at most
  /// Of the residual's square, as the preconditioner measures it, against that of the start.
  double Accuracy = 0.0;
};

/// A linear map, written into its second argument, which has the size of the first.
using LinearMap = std::function<void(const Points&, Points&)>;

/// Solve A x = b from x = 0, where A and the preconditioner are symmetric and positive definite.
/// @param[in] residual        b, which is used up
/// @param[in] product         A x
/// @param[in] preconditioned  about A^-1 x
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
