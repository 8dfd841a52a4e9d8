/// Evaluate the quality of a learned surface by its samples. Own construction: each defect is
/// measured as a fraction and compared with a tolerance, because learned surfaces have no reference
/// to compare with.

#ifndef ConformalSurfaceQuality_h
#define ConformalSurfaceQuality_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Defects of a surface, as fractions in [0, 1]. In fractions of the samples, each sample is
/// weighted by the area that it represents.
struct SurfaceQuality
{
  double UncoveredFraction = 0.0; ///< fraction of samples far from the surface
  /// Fraction of samples at which the surface is oriented the wrong way.
  double InvertedFraction = 0.0;
  double FoldedFraction = 0.0; ///< fraction of edges with a dihedral angle below 30 degrees

  // Properties of the samples alone. They are the same for any surface through the samples.
  /// Fraction of samples at least 0.02 off the plane of their neighbors.
  double UndersampledFraction = 0.0;
  double LayerDistance = 0.0; ///< distance between two layers of samples, or 0 for one layer
};

/// Largest tolerated fractions. Well-learned surfaces of closed scans have less than half of these
/// values.
struct ToleratedQuality
{
  static constexpr double UncoveredFraction = 0.002, InvertedFraction = 0.002,
                          FoldedFraction = 0.0005;
};

/// Evaluate a closed surface by the samples from which it was learned.
///
/// - A sample is covered if its distance from the surface is at most 1.5 times the typical spacing
///   of the cloud, or five standard deviations of noise. Outliers (samples far from all others) are
///   ignored.
/// - The surface is oriented correctly at a sample if its normal agrees with the sample's. If the
///   samples have no consistent normals, the surface's normals are tested by winding numbers
///   (WindingNumbers.h). The winding number decreases along a correct normal. It does not decrease
///   if two sides of the surface share samples, or if the surface is inside out.
/// - The surface is undersampled at samples that lie off the plane of their neighbors by more than
///   0.02.
/// - Scans with registration errors may consist of two layers. Samples form two layers if the
///   offsets of neighboring samples from the surface have two values. The kurtosis of such offsets
///   is nearer to 1 than to 3, the kurtosis of noise. Offsets of a curved object from coarse
///   triangles have two values, too. Neighbors near one quadratic polynomial are therefore ignored.
///
/// About 10,000 samples are used. All ranks use the same samples.
///
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] noise      standard deviation in the samples' unit, or 0
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
SurfaceQuality evaluateSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// Return a quality with a reduced uncovered fraction: samples that a hull omitted on purpose are
/// not counted as uncovered.
SurfaceQuality withoutLeftOut(SurfaceQuality quality, Index leftOut, Index all);

/// Compute the defect score: the maximum over all defects of the fraction divided by its tolerated
/// value. A surface with a score above 1 is bad.
double defectScore(const SurfaceQuality& quality);
}

#endif
