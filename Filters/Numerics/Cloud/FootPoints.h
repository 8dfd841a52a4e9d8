/// Find the closest surface points of many samples in parallel, and process them serially. Own
/// construction: chunks of limited size in Morton order, because they limit the memory and fix the
/// order of results.

#ifndef ConformalFootPoints_h
#define ConformalFootPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/TriangleTree.h"

#include <functional>

namespace conformal
{
/// Function that finds the point of a surface closest to a sample.
/// @param[in] id    id of the sample
/// @param[in] x     position of the sample
/// @param[in] hint  id of a triangle that may be near, or -1
using ClosestPoint = std::function<FootPoint(Index id, const Vector3& x, int hint)>;

/// Call body(id, x, foot) for samples, serially and in order. Here x is the position of the sample,
/// and foot the closest point of the surface. Only a limited number of closest points is stored at
/// a time. The body may run on any thread, concurrently with the search for the next closest
/// points.
/// @param[in] closest  function called by all threads, once for each sample
/// @param[in] count    number of samples
/// @param[in] idOf     function that returns the id of the i-th sample; if empty, the id is i
/// @throws Aborted
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});

/// Call body(i, x, foot) once for each i in [0, count), serially, with the closest point of a
/// triangle mesh. Samples are processed in spatial order, so that nearby triangles stay in the
/// processor's cache. Use this function for sums that do not depend on the order
/// (FixedPointSums.h).
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});
}

#endif
