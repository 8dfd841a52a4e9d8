/// Options of the least-squares fit that a caller of trainConformalSOM() may set.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
struct FitOptions
{
  /// Usual weight of the Laplacian term of a vertex, relative to the mean weight of its samples.
  static constexpr double UsualSmoothness = 0.01;

  /// Number of iterations; each one uses new foot points of the samples.
  int Iterations = 10;
  /// Factor of the smoothness that follows from the samples, or of the usual one.
  double Smoothness = 1.0;
  bool AutomaticPriority = true; ///< whether to weight samples by distance, see LeastSquaresFit.h
};
}

#endif
