#include "Cloud/FootPoints.h"

#include <algorithm>
#include <vector>

namespace conformal
{
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  constexpr Index BlockSize = 256;
  constexpr Index ChunkSize = 64 * BlockSize; // a hundredth of a second or two between reports
  const auto id = [&](Index i) { return idOf ? idOf(i) : i; };
  std::vector<FootPoint> feet(std::min(count, ChunkSize));
  for (Index first = 0; first < count; first += ChunkSize)
  {
    const Index size = std::min(ChunkSize, count - first);
    forBlocks(run, size, BlockSize,
      [&](Index begin, Index end)
      {
        // Neighbors in the scan are often neighbors in space: the last triangle is a hint.
        int hint = -1;
        for (Index i = begin; i < end; ++i)
        {
          const Index own = id(first + i);
          feet[i] = closest(own, samples[own], hint);
          hint = feet[i].Triangle;
        }
      });
    for (Index i = 0; i < size; ++i)
    {
      body(id(first + i), samples[id(first + i)], feet[i]);
    }
    run.report(static_cast<double>(first + size) / static_cast<double>(count));
  }
}

//------------------------------------------------------------------------------
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  const ClosestPoint closest = [&](Index, const Vector3& x, int hint)
  { return surface.closestPoint(x, hint); };
  forEachFoot(samples, closest, count, idOf, body, run);
}
}
