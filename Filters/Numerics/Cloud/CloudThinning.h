/// Fewer points for the same cloud.

#ifndef ConformalCloudThinning_h
#define ConformalCloudThinning_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Points of a cloud and, where they are known, their normals.
struct OrientedPoints
{
  Points Positions; ///< #P by 3
  Points Normals;   ///< #P by 3, unit vectors or zero where unknown; or empty
};

/// Samples of a cloud, spread over its order: one of each stretch, not always the same, since scans
/// have rhythms of their own. All processes get the same ones.
/// @param[in] most  about how many; all samples where there are fewer
OrientedPoints selectSamples(const TrainingSamples& samples, double maximum);

/// A cloud without the marked points.
/// @param[in] marks  #P, 1 for those to leave out, else 0
OrientedPoints without(const OrientedPoints& cloud, const std::vector<std::uint8_t>& marks);

/// The means of the points in each cube of a grid, whose spacing is chosen so that about as many
/// are left as asked for: noise is averaged, and dense parts come down to the density of the
/// others.
/// @param[in] count  at least 1; the cloud is returned as it is where it has no more points
OrientedPoints thin(const OrientedPoints& cloud, Index count, const Run& run = {});
}

#endif
