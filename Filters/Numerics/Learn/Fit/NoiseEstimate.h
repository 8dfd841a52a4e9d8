/// Separate noise from unresolved detail in the errors of a learned surface. Own construction:
/// errors at two mesh resolutions are compared, because refinement reduces the error by detail but
/// not the noise.

#ifndef ConformalNoiseEstimate_h
#define ConformalNoiseEstimate_h

#include "Base/FixedPointSums.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Estimate the ratio of the variance of the noise to the variance due to unresolved detail. The
/// estimate is based on the typical square errors of two surfaces. The coarse surface has a quarter
/// of the vertices of the fine surface. Refinement from coarse to fine divides the square error due
/// to detail by six, as measured on scans (by 16 in the limit of smooth objects). Refinement does
/// not change the noise.
/// @return the ratio, in [0, 10]
double noiseToDetail(double coarseError, double fineError);

/// Estimate the variance of Gaussian noise along the normal from the typical square errors of a
/// coarse and a fine surface. Return 0 if detail explains both errors.
double noiseVariance(double coarseError, double fineError);

/// Geometric mean of square distances, which is insensitive to a few outliers.
class TypicalSquare
{
public:
  /// @param[in] square  squared distance, at most 1e27
  void add(double square);

  /// Compute the geometric mean of the squares added on all ranks.
  /// @param[in] count  number of squares added on all ranks
  double mean(const Reduce& reduce, Index count);

private:
  FixedPointSums Logarithms{ 1 };
};

/// Compute the typical square distance of patterns to a surface.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] wanted     number of patterns to use, spaced evenly in their sequence
double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const Run& run = {});
}

#endif
