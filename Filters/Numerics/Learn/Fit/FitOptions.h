/// Options of the least-squares fit that a caller of trainConformalSOM() may set. The fit moves the
/// vertices of a mesh toward the samples.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
/// Options of the least-squares fit (LeastSquaresFit.h).
struct FitOptions
{
  /// Usual weight of a smooth surface at a vertex, divided by the mean weight of the samples of a
  /// vertex.
  static constexpr double UsualSmoothness = 0.01;

  /// Number of iterations. Each iteration projects the samples to the surface, then moves the
  /// vertices.
  int Iterations = 10;
  /// Factor of the smoothness that follows from the samples, or of UsualSmoothness.
  double Smoothness = 1.0;
  /// Whether samples farther from the surface have larger weights, see LeastSquaresFit.h.
  bool AutomaticPriority = true;
};
}

#endif
