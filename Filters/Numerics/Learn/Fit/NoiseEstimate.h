/// Separate noise from unresolved detail in the errors of a learned surface.
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
/// Estimate the variance of the noise over that of unresolved detail, from the typical square
/// errors of two surfaces. The coarse one has a quarter of the vertices of the fine one. Refinement
/// divides the error by detail by six, as measured on scans (16 in the limit of smooth objects). It
/// does not change the noise.
/// @return in [0, 10]
double noiseToDetail(double coarseError, double fineError);

/// Estimate the variance of Gaussian noise along the normal from the typical square errors of a
/// coarse and a fine surface; 0 if detail explains them.
double noiseVariance(double coarseError, double fineError);

/// Geometric mean of square distances, which is insensitive to a few outliers.
class TypicalSquare
{
public:
  /// @param[in] square  up to 1e27
  void add(double square);

  /// Compute the mean over all ranks.
  /// @param[in] count  number of squares added on all ranks
  double mean(const Reduce& reduce, Index count);

private:
  FixedPointSums Logarithms{ 1 };
};

/// Compute the typical square distance of patterns to a surface.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] wanted     number of patterns used, evenly spaced
double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const Run& run = {});
}

#endif
