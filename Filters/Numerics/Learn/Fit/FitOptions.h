/// Options of the least-squares fit that a caller of trainConformalSOM() can set. The fit moves the
/// vertices of a mesh toward the samples.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
/// Options of the least-squares fit (LeastSquaresFit.h).
struct FitOptions
{
  /// Usual smoothness. The fit minimizes an energy with smoothness terms. The smoothness is the
  /// weight of these terms at a vertex, divided by the mean mass. The mean mass is the total weight
  /// of the samples, divided by the number of vertices.
  static constexpr double UsualSmoothness = 0.01;

  /// Number of iterations. Each iteration projects the samples to the surface, then moves the
  /// vertices.
  int Iterations = 10;
  /// Factor that multiplies UsualSmoothness. After the fit, FairFit.h removes noise by smoothing.
  /// The weight of this smoothing is also multiplied by the factor. If the samples are noisy, the
  /// smoothness is increased further.
  double Smoothness = 1.0;
  /// Whether samples farther from the surface have larger weights, see LeastSquaresFit.h.
  bool AutomaticPriority = true;
};
}

#endif
