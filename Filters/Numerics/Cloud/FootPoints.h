/// Find the closest surface points (foot points) of many samples (points of a cloud) on all
/// threads. Pass the foot points to a function serially. The scheme is our own construction:
/// samples are processed in chunks of limited size, which limits the memory. Within a chunk, the
/// sequence of calls does not depend on the number of threads.

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
/// @param[in] hint  id of a triangle that is probably near x, which reduces the cost; -1 for none
using ClosestPoint = std::function<FootPoint(Index id, const Vector3& x, int hint)>;

/// Call body(id, x, foot) serially for the samples idOf(0), idOf(1), ..., idOf(count - 1). Here, x
/// is the position of the sample, and foot is the point of the surface closest to x. Only a limited
/// number of closest points is stored at a time. The body can run on any thread, concurrently with
/// the search for further closest points.
/// @param[in] closest  function that finds the closest point, called by all threads once for each
///   sample
/// @param[in] count    number of samples
/// @param[in] idOf     function that returns the id of the i-th sample; if empty, the id is i
/// @throws Aborted
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});

/// Call body(i, x, foot) serially, once for each i in [0, count), in any sequence. Here, x is the
/// position of sample idOf(i), and foot is the point of a triangle mesh closest to x. The ids are
/// distinct. The samples are visited along a Morton curve, on which successive samples are usually
/// close together. The triangles near the samples thus stay in the cache of the processor. Use this
/// function only if the sequence of calls does not matter, for example with FixedPointSums, whose
/// sums do not depend on the order. If few samples of many are left out, call
/// TrainingSamples::sortAlongCurve() before.
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});
}

#endif
