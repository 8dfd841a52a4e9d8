/// Estimate the noise of samples from their distances to learned surfaces.
///
/// Own construction, not from a publication: errors of a coarse mesh and of a fine mesh are
/// compared. An error is the distance of a sample from the mesh. A finer mesh reduces the error due
/// to unresolved detail (too small for the triangles), but not the error due to noise.

#ifndef ConformalNoiseEstimate_h
#define ConformalNoiseEstimate_h

#include "Base/FixedPointSums.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Estimate the variance of the noise, divided by the variance due to unresolved detail on the fine
/// surface. The estimate is based on the typical square errors of two surfaces. A typical square
/// error is the geometric mean of the squared distances of samples from a surface. The coarse
/// surface has a quarter of the vertices of the fine surface.
///
/// Detail is assumed to cause a six times smaller square error on the fine surface. This factor was
/// measured on scans. For smooth objects and fine meshes, the factor would approach 16, the square
/// of 4. Errors of such meshes are four times smaller if edges are half as long. The noise is
/// assumed to cause the same square error on both surfaces.
/// @param[in] coarseError, fineError  typicalSquareError() of both surfaces
/// @return the ratio, in [0, 10]; 10 if the error of the fine surface is not below that of the
///   coarse surface
double noiseToDetail(double coarseError, double fineError);

/// Estimate the variance of Gaussian noise along the normal, from the typical square errors of a
/// coarse and a fine surface. If unresolved detail alone explains both errors, return 0.
double noiseVariance(double coarseError, double fineError);

/// Geometric mean of squared distances. Unlike the arithmetic mean, the geometric mean hardly
/// depends on a few outliers.
class TypicalSquare
{
public:
  /// Add a squared distance.
  /// @param[in] square  squared distance, at most 1e27, the limit of the sums
  void add(double square);

  /// Compute the geometric mean of the squares added on all ranks (processes).
  /// @param[in] count  number of squares added on all ranks
  double mean(const Reduce& reduce, Index count);

private:
  FixedPointSums Logarithms{ 1 };
};

/// Compute the typical square error of a surface: the geometric mean of the squared distances of
/// samples from the surface.
/// @param[in] positions  #V by 3, in the samples' unit (maximum radius 1)
/// @param[in] triangles  #F by 3
/// @param[in] wanted     number of samples to use, selected at equal intervals of their sequence
double typicalSquareError(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, Index wanted, const Run& run = {});
}

#endif
