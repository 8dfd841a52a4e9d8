/// How much of what a surface leaves of its patterns is noise.
/// Own construction: errors at two resolutions separate noise from detail.

#ifndef ConformalNoiseEstimate_h
#define ConformalNoiseEstimate_h

#include "Base/FixedPointSums.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Variance of the noise over that of the detail that a surface is too coarse for, from the typical
/// square errors of that surface and of one of a quarter of its vertices: by refinement the detail
/// falls sixfold (measured on scans; sixteenfold would be the limit of a smooth object), the noise
/// stays.
/// @return in [0, 10]
double noiseToDetail(double coarseError, double fineError);

/// Variance of the noise along the normal, from the same errors, if it is Gaussian; 0 where detail
/// explains them.
double noiseVariance(double coarseError, double fineError);

/// The geometric mean of square distances, which a few outliers do not change.
class TypicalSquare
{
public:
  /// @param[in] square  up to 1e27
  void add(double square);

  /// Of all processes.
  /// @param[in] count  of what they have added
  double mean(const Reduce& reduce, Index count);

private:
  FixedPointSums Logarithms{ 1 };
};

/// The typical square distance of patterns to a surface.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] wanted     how many patterns, evenly spaced
double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const Run& run = {});
}

#endif
