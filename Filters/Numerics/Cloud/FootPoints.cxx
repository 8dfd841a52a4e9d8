#include "Cloud/FootPoints.h"

#include <algorithm>
#include <vector>

namespace conformal
{
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body,
  const ParallelFor& parallelFor, const Progress& progress)
{
  constexpr Index BlockSize = 256;
  constexpr Index ChunkSize = 64 * BlockSize; // a hundredth of a second or two between reports
  const auto id = [&](Index i) { return idOf ? idOf(i) : i; };
  std::vector<FootPoint> feet(std::min(count, ChunkSize));
  for (Index first = 0; first < count; first += ChunkSize)
  {
    const Index size = std::min(ChunkSize, count - first);
    forBlocks(parallelFor, size, BlockSize,
      [&](Index begin, Index end)
      {
        // Neighbors in the scan are often neighbors in space: the last triangle is a hint.
        int hint = -1;
        for (Index i = begin; i < end; ++i)
        {
          feet[i] = surface.closestPoint(samples[id(first + i)], hint);
          hint = feet[i].Triangle;
        }
      });
    for (Index i = 0; i < size; ++i)
    {
      body(id(first + i), samples[id(first + i)], feet[i]);
    }
    report(progress, static_cast<double>(first + size) / static_cast<double>(count));
  }
}
}
