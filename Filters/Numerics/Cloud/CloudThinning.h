/// Reduce the number of points of a cloud. Own construction: means over grid cells, with the
/// spacing found by bisection.

#ifndef ConformalCloudThinning_h
#define ConformalCloudThinning_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Points of a cloud and, if known, their normals.
struct OrientedPoints
{
  Points Positions; ///< #P by 3
  Points Normals;   ///< #P by 3, unit vectors or zero where unknown; or empty
};

/// Select samples spread over the order of a cloud, one at a varying position of each stretch,
/// since scans may be periodic. All ranks return the same samples.
/// @param[in] most  approximate number; all samples are returned if there are fewer
OrientedPoints selectSamples(const TrainingSamples& samples, double maximum);

/// Return a cloud without the marked points.
/// @param[in] marks  #P, 1 for a point to leave out, else 0
OrientedPoints without(const OrientedPoints& cloud, const std::vector<std::uint8_t>& marks);

/// Replace the points in each cube of a grid by their mean. The spacing is chosen for about the
/// given number of means. Noise is averaged, and dense parts are reduced to the density of the
/// others.
/// @param[in] count  at least 1; a cloud without more points is returned unchanged
OrientedPoints thin(const OrientedPoints& cloud, Index count, const Run& run = {});
}

#endif
