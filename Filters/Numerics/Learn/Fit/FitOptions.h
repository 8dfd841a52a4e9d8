/// Options of the least-squares fit that a caller of trainConformalSOM() may set.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
struct FitOptions
{
  /// Number of iterations; each one uses new foot points of the samples.
  int Iterations = 10;
  /// Weight of the Laplacian term of a vertex, relative to the mean weight of a vertex's samples.
  double Smoothness = 0.01;
  bool AutomaticPriority = true; ///< whether to weight samples by distance, see LeastSquaresFit.h
};
}

#endif
