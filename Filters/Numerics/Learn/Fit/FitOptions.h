/// Options of the least-squares fit that a caller of trainConformalSOM() may set.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
struct FitOptions
{
  static constexpr double UsualSmoothness =
    0.01; ///< weight of the Laplacian, per sample of a vertex

  int Iterations = 10;     ///< over all samples, each with new foot points
  double Smoothness = 1.0; ///< factor of the smoothness that the samples choose, or that is usual
  bool AutomaticPriority = true; ///< see LeastSquaresFit.h
};
}

#endif
