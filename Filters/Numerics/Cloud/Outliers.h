/// Leave out outliers before learning. Clumps of outliers would hang on the learned surface by
/// threads, which no map to the sphere can represent.
///
/// Own construction: the marks of StrayPoints.h are repeated, since an outlier is conspicuous only
/// after its neighbors among the outliers were removed.

#ifndef ConformalOutliers_h
#define ConformalOutliers_h

#include "Base/Run.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Return the samples that are not outliers.
///
/// A cloud has outliers if isolatedPoints() marks at least 0.5 % of the samples. Scans without
/// outliers have less than 0.3 %, even if they are noisy, uneven or incomplete. Without outliers,
/// all samples are returned.
///
/// Samples marked by isolatedPoints() or strayPoints() are removed alternately, until few are
/// marked. At most about 50,000 samples are marked. Any other sample is an outlier if it is far
/// from the remaining samples, or from the plane of its neighbors among them, by the limits of
/// StrayPoints.h.
///
/// @return samples in the same coordinates; the result does not depend on the number of threads or
///   ranks
/// @throws Aborted
TrainingSamples withoutOutliers(const TrainingSamples& samples, const Run& run = {});
}

#endif
