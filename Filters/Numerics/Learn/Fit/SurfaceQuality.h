/// Evaluate the quality of a learned surface by its samples.
///
/// Own construction, not from a publication: each defect is a fraction of the samples or edges, and
/// is compared with a tolerance. A reference surface is not needed.

#ifndef ConformalSurfaceQuality_h
#define ConformalSurfaceQuality_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Defects of a surface, as fractions in [0, 1]. In fractions of samples, the weight of a sample is
/// the surface area that it represents. For details, see evaluateSurface().
struct SurfaceQuality
{
  double UncoveredFraction = 0.0; ///< fraction of samples that are far from the surface
  /// Fraction of samples at which the surface normal points to the wrong side.
  double InvertedFraction = 0.0;
  double FoldedFraction = 0.0; ///< fraction of edges with a dihedral angle below 30 degrees

  // The following properties are the same for any surface through the samples.
  /// Fraction of samples whose distance from the plane through their neighbors is above 0.02, in
  /// the samples' unit (maximum radius 1).
  double UndersampledFraction = 0.0;
  /// Distance between two layers of samples in the samples' unit (maximum radius 1), or 0 if there
  /// is only one layer.
  double LayerDistance = 0.0;
};

/// Tolerances: maximum fraction of each defect in a good surface. Well-learned surfaces of closed
/// scans have less than half of these fractions.
struct ToleratedQuality
{
  static constexpr double UncoveredFraction = 0.002, InvertedFraction = 0.002,
                          FoldedFraction = 0.0005;
};

/// Minimum number of samples for all fractions but FoldedFraction. With fewer samples of a solid,
/// UndersampledFraction is 1, and the others are 0.
constexpr Index MinimumEvaluated = 20;

/// Evaluate a closed surface by the samples from which it was learned. All distances are in the
/// samples' unit (maximum radius 1).
///
/// - UncoveredFraction: A sample is uncovered if its distance from the surface exceeds a limit. The
///   limit is 1.5 times the typical distance between neighboring samples, or five standard
///   deviations of the noise, whichever is larger. Outliers (samples far from all others) are
///   ignored.
/// - InvertedFraction: At each sample, the surface normal is compared with an outward direction. If
///   the samples have consistent normals, the direction is the normal of the sample. Otherwise, the
///   direction is found by the winding number, a function of position (WindingNumbers.h). To
///   compute the winding number, the surface normals are assigned to the samples. With outward
///   normals, its value is about 1 inside the object, and about 0 outside. In the outward
///   direction, the winding number therefore decreases. If the winding number does not decrease
///   along the surface normal, the surface is inside out, or two of its sides are near the same
///   samples.
/// - UndersampledFraction: A sample is counted if its distance from the plane through its neighbors
///   is above 0.02, or four standard deviations of the noise, whichever is larger. Samples are too
///   sparse there for the curvature of the surface.
/// - LayerDistance: A scan with registration errors can consist of two layers of samples. The
///   offset of a sample is its signed distance from the surface. In two layers, offsets of
///   neighboring samples have about two values. Their kurtosis (mean fourth power, divided by the
///   squared variance) is 1 for two values, and 3 for Gaussian noise. Two layers are assumed if the
///   kurtosis is below 2.15. However, offsets of a curved object from a coarse mesh can also have
///   about two values. Neighboring samples are therefore not counted as layers if they are near a
///   common quadratic surface.
///
/// About 10,000 samples are used. All ranks (processes) use the same samples.
///
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @param[in] noise      standard deviation of the noise in the samples' unit, or 0 if unknown
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
SurfaceQuality evaluateSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// Count the samples that a surface does not reach, on all ranks. They are farther from the surface
/// than five standard deviations of the noise, and than the spacing of the samples, or 0.01 if the
/// spacing is larger. Samples outside of a hull are often reached by the fit. See evaluateSurface()
/// for the arguments.
/// @throws Aborted
Index countBeyondReach(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run = {});

/// Reduce UncoveredFraction by the fraction of samples that a hull left out. A hull is a start
/// surface of learning, a closed surface around the samples. Samples outside of the hull and far
/// from it are left out on purpose.
/// @param[in] leftOut  number of omitted samples
/// @param[in] all      total number of samples
SurfaceQuality withoutLeftOut(SurfaceQuality quality, Index leftOut, Index all);

/// Compute the defect score. Each of the fractions in ToleratedQuality is divided by its tolerated
/// value. The score is the maximum of these ratios. A surface with a score above 1 is bad.
double defectScore(const SurfaceQuality& quality);
}

#endif
