/// Reduce the number of points of a point cloud. The method is our own construction. The points in
/// each cell of a grid are averaged, because means have less noise. The cell size that gives the
/// wanted number of means is found by bisection.

#ifndef ConformalCloudThinning_h
#define ConformalCloudThinning_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Points of a point cloud, and their normals and scanners if known.
struct OrientedPoints
{
  Points Positions; ///< #P by 3
  /// #P by 3 unit vectors, zero for points without a known normal; empty if no normals are known
  Points Normals;
  /// #P by 3 vectors from points to their scanners, zero for points whose scanner is unknown; empty
  /// if no scanners are known. The function thin() omits them.
  Points ToScanner = {};
};

/// Select samples evenly from the sequence of all samples. The sequence is divided into intervals
/// of equal length. One sample is selected from each interval. The position of the selected sample
/// varies from interval to interval. If the sequence of the points is periodic, as in the rows of a
/// scan, a fixed position would select similar points. If the samples are distributed over ranks
/// (MPI processes), every rank returns the selected samples of all ranks.
/// @param[in] maximum  approximate number of samples to select. If there are fewer samples, all are
///   selected.
OrientedPoints selectSamples(const TrainingSamples& samples, double maximum);

/// Return the points of a cloud that are not marked.
/// @param[in] marks  #P marks: 1 for points to leave out, 0 for points to keep
OrientedPoints without(const OrientedPoints& cloud, const std::vector<std::uint8_t>& marks);

/// Replace the points in each cube of a grid by their mean. The size of the cubes is chosen so that
/// the number of means is at most `count`, and close to `count`. The means have less noise than the
/// points. In dense parts of the cloud, more points are averaged than in sparse parts.
/// @param[in] count  maximum number of means, at least 1. A cloud of at most `count` points is
///   returned unchanged.
OrientedPoints thin(const OrientedPoints& cloud, Index count, const Run& run = {});
}

#endif
