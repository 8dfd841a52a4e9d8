/// Closest surface points of many samples, computed in parallel and delivered serially. Own
/// construction: Morton order and bounded chunks keep memory small and the order of results fixed.

#ifndef ConformalFootPoints_h
#define ConformalFootPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/TriangleTree.h"

#include <functional>

namespace conformal
{
/// Find the closest point of a surface.
/// @param[in] id    of the sample
/// @param[in] x     the sample
/// @param[in] hint  a triangle that may be near, or -1
using ClosestPoint = std::function<FootPoint(Index id, const Vector3& x, int hint)>;

/// Call body(id, x, foot) for samples serially and in order, where x is the sample and foot its
/// closest point on the surface. A bounded number of closest points is stored. The body may run on
/// any thread, concurrently with the search for the next closest points.
/// @param[in] closest  called by all threads, once for each sample
/// @param[in] count    number of samples
/// @param[in] idOf     id of the i-th sample; identity if empty
/// @throws Aborted
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});

/// Call body(i, x, foot) with the closest point on triangles once for each i in [0, count),
/// serially. Samples are visited in spatial order, so that nearby triangles stay in the cache. Use
/// it for sums whose order does not matter (FixedPointSums.h).
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});
}

#endif
