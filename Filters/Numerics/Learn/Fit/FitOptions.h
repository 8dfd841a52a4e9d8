/// Options of the least-squares fit that a caller of trainConformalSOM() may set.

#ifndef ConformalFitOptions_h
#define ConformalFitOptions_h

namespace conformal
{
struct FitOptions
{
  int Iterations = 10;           ///< over all samples, each with new foot points
  double Smoothness = 0.01;      ///< weight of the Laplacian, per sample of a vertex
  bool AutomaticPriority = true; ///< see LeastSquaresFit.h
};
}

#endif
