/// Find the points of a cloud that are copies: an earlier point has the same coordinates.
///
/// Many files store a point of the surface several times, once for each triangle or image that uses
/// it. Copies make clumps. Spacings and planes, which are computed from the nearest neighbors of a
/// point, are wrong in clumps. The search is our own construction: equal positions have equal keys,
/// which are computed by the mixing function of \cite Steele2014.

#ifndef ConformalCopies_h
#define ConformalCopies_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Copies among the points of a cloud.
struct Copies
{
  /// For each point of this rank, whether it is a copy. Empty if the cloud has no copies.
  std::vector<bool> IsCopy;
  Index Count = 0; ///< number of copies on all ranks

  bool contains(Index i) const { return !this->IsCopy.empty() && this->IsCopy[i]; }
};

/// Find the copies of a cloud. A point is a copy if an earlier point, in the sequence of the points
/// of all ranks, has the same coordinates.
///
/// Large clouds are examined in parts of about a million points. All points of one position are in
/// one part. If the first part contains no copies, the cloud is regarded as one without copies.
///
/// @param[in] points  #P by 3 coordinates, in any unit. Points that are not finite are no copies.
/// @param[in] skip    function that returns true for points that are not examined; empty to examine
///   all points
/// @param[in] reduce  communication between ranks; each rank passes its part of the cloud
/// @throws Aborted
/// @post the result does not depend on the number of threads or ranks
Copies findCopies(const PointView& points, const std::function<bool(Index)>& skip = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif
