/// Closest surface points of many samples, computed in parallel and delivered in order.

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

/// Call body(id, x, foot) for patterns of the samples, in order and on the calling thread, where x
/// is the pattern and foot its closest point on the surface. A bounded number of feet is kept.
/// @param[in] closest  called by all threads, once for each pattern
/// @param[in] count    how many patterns
/// @param[in] idOf     id of the i-th of them; identity where empty
/// @throws Aborted
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});

/// The same on triangles.
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run = {});
}

#endif
