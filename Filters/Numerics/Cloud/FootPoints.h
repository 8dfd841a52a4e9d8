/// Closest surface points of many samples, computed in parallel and delivered one after the other.

#ifndef ConformalFootPoints_h
#define ConformalFootPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/TriangleTree.h"

#include <functional>

namespace conformal
{
/// The closest point of a surface.
/// @param[in] id    of the pattern
/// @param[in] x     the pattern
/// @param[in] hint  a triangle that may be near, or -1
using ClosestPoint = std::function<FootPoint(Index id, const Vector3& x, int hint)>;

/// Call body(id, x, foot) for patterns of the samples, one after the other and in order, where x is
/// the pattern and foot its closest point on the surface. A bounded number of feet is kept. The
/// body may run on any thread, while others look for the next feet.
/// @param[in] closest  called by all threads, once for each pattern
/// @param[in] count    how many patterns
/// @param[in] idOf     id of the i-th of them; identity where empty
/// @throws Aborted
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});

/// Call body(i, x, foot) with the closest points on triangles, for each i in [0, count) once, one
/// after the other: neighbors in space follow each other, so that the triangles around them are at
/// hand. For sums whose order does not matter (FixedPointSums.h).
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});
}

#endif
