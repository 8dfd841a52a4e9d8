/// Quality of a learned surface by its samples; own construction.

#ifndef ConformalSurfaceQuality_h
#define ConformalSurfaceQuality_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Defects as fractions in [0, 1]. Samples are weighted by the area that they represent.
struct SurfaceQuality
{
  double UncoveredFraction = 0.0; ///< samples far from the surface
  double InvertedFraction = 0.0;  ///< samples at which the surface is oriented the wrong way
  double FoldedFraction = 0.0;    ///< edges with a dihedral angle sharper than 30 degrees

  // Properties of the samples alone; another surface through them does not change these.
  double UndersampledFraction = 0.0; ///< samples off the plane of their neighbors by 0.02 or more
  double LayerDistance = 0.0;        ///< between two layers of samples, or 0
};

/// Largest tolerated fractions; well-learned closed scans have less than half of them.
struct ToleratedQuality
{
  static constexpr double UncoveredFraction = 0.002, InvertedFraction = 0.002,
                          FoldedFraction = 0.0005;
};

/// Evaluate a closed surface by the samples it was learned from.
///
/// - A sample is covered if its distance from the surface is at most 1.5 times the typical spacing
///   of the cloud, or five standard deviations of noise. Outliers, samples far from all others, are
///   not counted.
/// - The surface is oriented correctly at a sample if its normal agrees with the sample's. Without
///   consistent normals of the samples, those of the surface are tested by winding numbers
///   (WindingNumbers.h). The winding number decreases along a correct normal. It does not if two
///   sides of the surface share samples, or the surface is inside out.
/// - The surface is undersampled at samples that lie off the plane of their neighbors by more than
///   0.02.
/// - Samples form two layers, as in scans with registration errors, if neighboring offsets from the
///   surface have two values. Their kurtosis is then nearer to 1 than to the 3 of noise. On a
///   curved surface, offsets from coarse triangles have two values, too. Neighbors near one
///   quadratic polynomial are therefore not counted.
///
/// About 10,000 of the samples are used, the same on all ranks.
///
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] noise      standard deviation in the samples' unit, or 0
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
SurfaceQuality evaluateSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// Exclude samples that a hull omitted on purpose from the uncovered fraction of a quality.
SurfaceQuality withoutLeftOut(SurfaceQuality quality, Index leftOut, Index all);

/// Compute the maximum ratio of a fraction to its tolerated value. A surface with a score above 1
/// is bad.
double defectScore(const SurfaceQuality& quality);
}

#endif
