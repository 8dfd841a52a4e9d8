/// What is wrong with a learned surface, as far as it can be told from its samples.

#ifndef ConformalSurfaceVerdict_h
#define ConformalSurfaceVerdict_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
struct SurfaceVerdict
{
  // Of the samples, each counted by the area that it stands for.
  double UnmetFraction = 0.0;    ///< the surface does not come near them
  double InvertedFraction = 0.0; ///< the surface faces the wrong way there

  double FoldedFraction = 0.0; ///< of the edges: bent by more than 150 degrees

  // Of the samples alone, which no other surface would mend.
  double UnresolvedFraction = 0.0; ///< of them, off the plane of their neighbors by 0.02 or more
  double LayerDistance = 0.0;      ///< of two layers that they lie on, or 0
};

/// What is tolerated of each; closed scans that were learned well have less than half of it.
struct ToleratedVerdict
{
  static constexpr double UnmetFraction = 0.002, InvertedFraction = 0.002, FoldedFraction = 0.0005;
};

/// Judge a closed surface by the samples it was learned from.
///
/// - A sample is met by a surface that is no farther than 1.5 times the typical distance of
///   neighbors in the cloud, or five standard deviations of noise. Outliers, samples far from all
///   others, are not counted.
/// - The surface faces the right way at a sample that has a normal to agree with. Where no normals
///   are known, or where they do not agree on what is inside, the samples get those of the surface:
///   where it is right, their winding number (WindingNumbers.h) falls along it. It does not where
///   two sides of the surface lie on the same samples, or where it has been turned inside out.
/// - Samples are too few where they lie off the plane of their neighbors by more than 0.02: what is
///   between them is guessed.
/// - Samples lie on two layers, as those of scans that are not registered well, where their offsets
///   from the surface have, among neighbors, two values: a kurtosis nearer to 1 than to the 3 of
///   noise. Neighbors on one curved surface are no layers, though their offsets from the triangles
///   of a coarse mesh have two values, too: those are near a quadratic polynomial.
///
/// Some 10,000 of the samples are asked, the same on all processes.
///
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] noise      its standard deviation in the samples' unit, or 0
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
SurfaceVerdict judgeSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// What judgeSurface() takes, in nanoseconds as in Steps.
double workOfVerdict(Index numberOfVertices);

/// The verdict without samples that a hull left out on purpose, which the surface need not meet.
SurfaceVerdict withoutLeftOut(SurfaceVerdict verdict, Index leftOut, Index all);

/// The worst of a verdict, in units of what is tolerated: a surface above 1 is bad.
double badness(const SurfaceVerdict& verdict);
}

#endif
