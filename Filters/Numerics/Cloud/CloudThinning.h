/// Reduce the number of points of a cloud. Own construction: points are averaged in the cells of a
/// grid, because means reduce noise. The size of the cells is found by bisection.

#ifndef ConformalCloudThinning_h
#define ConformalCloudThinning_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Points of a cloud, and their normals if these are known.
struct OrientedPoints
{
  Points Positions; ///< #P by 3
  /// #P by 3 unit vectors, zero for points without a known normal; empty if no normals are known
  Points Normals;
};

/// Select samples evenly from the sequence of points. The sequence is divided into intervals of
/// equal length, and one sample is selected from each. Its position in the interval varies, because
/// the sequence of points of a scan may be periodic. All ranks return the same samples.
/// @param[in] maximum  approximate number of samples to select; if there are fewer, all are
///   returned
OrientedPoints selectSamples(const TrainingSamples& samples, double maximum);

/// Return a cloud without the marked points.
/// @param[in] marks  #P marks, 1 for points to leave out, 0 for all others
OrientedPoints without(const OrientedPoints& cloud, const std::vector<std::uint8_t>& marks);

/// Replace the points in each cube of a grid by their mean. The size of the cubes is chosen so that
/// there are about `count` means, and no more. The means have less noise than the points. Dense
/// parts of the cloud lose more points than sparse parts.
/// @param[in] count  approximate number of means, at least 1; a cloud of at most `count` points is
///   returned unchanged
OrientedPoints thin(const OrientedPoints& cloud, Index count, const Run& run = {});
}

#endif
