/// Quality of a learned surface, as far as its samples show it; own construction.

#ifndef ConformalSurfaceQuality_h
#define ConformalSurfaceQuality_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Shares in [0, 1]; a sample counts by the area that it stands for.
struct SurfaceQuality
{
  double UncoveredFraction = 0.0; ///< samples that the surface does not reach
  double InvertedFraction = 0.0;  ///< samples at which the surface faces the wrong way
  double FoldedFraction = 0.0;    ///< edges with a dihedral angle sharper than 30 degrees

  // Of the samples alone; another surface through them does not change these.
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
/// - A sample is covered by a surface that is no farther than 1.5 times the typical distance of
///   neighbors in the cloud, or five standard deviations of noise. Outliers, samples far from all
///   others, are not counted.
/// - The surface faces the right way at a sample whose normal agrees. Where the samples have no
///   normals, or normals that do not agree on what is inside, the samples get the normals of the
///   surface: where the surface is right, their winding number (WindingNumbers.h) falls along the
///   normal. It does not where two sides of the surface lie on the same samples, or where the
///   surface is inside out.
/// - Samples are too few where they lie off the plane of their neighbors by more than 0.02.
/// - Samples lie on two layers, as in scans that are not registered well, where their offsets from
///   the surface have two values among neighbors: a kurtosis nearer to 1 than to the 3 of noise.
///   Neighbors on one curved surface are no layers, though their offsets from the triangles of a
///   coarse mesh have two values, too: those are near a quadratic polynomial.
///
/// Some 10,000 of the samples are used, the same on all processes.
///
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] noise      its standard deviation in the samples' unit, or 0
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
SurfaceQuality evaluateSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// Quality without the samples that a hull left out on purpose, which the surface need not cover.
SurfaceQuality withoutLeftOut(SurfaceQuality quality, Index leftOut, Index all);

/// Largest ratio of a fraction to its tolerated value: a surface above 1 is bad.
double defectScore(const SurfaceQuality& quality);
}

#endif
