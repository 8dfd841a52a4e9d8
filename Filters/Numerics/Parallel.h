/// How the core runs on many threads and many processes without knowing any of them.
///
/// Results do not depend on the number of threads: work is cut into blocks of a fixed size,
/// whatever runs them, and blocks never add into each other's results.

#ifndef ConformalParallel_h
#define ConformalParallel_h

#include "Types.h"

#include <algorithm>
#include <functional>

namespace conformal
{
/// Runs body(i) once for every i in [0, count), in any order, perhaps at the same time.
using ParallelFor = std::function<void(Index count, const std::function<void(Index)>& body)>;

/// Run body(begin, end) over [0, size) in blocks of blockSize; in order where no ParallelFor is
/// given.
inline void forBlocks(const ParallelFor& parallelFor, Index size, Index blockSize,
  const std::function<void(Index, Index)>& body)
{
  const Index count = (size + blockSize - 1) / blockSize;
  const auto runBlock = [&](Index block)
  { body(block * blockSize, std::min(size, (block + 1) * blockSize)); };
  if (parallelFor)
  {
    parallelFor(count, runBlock);
    return;
  }
  for (Index block = 0; block < count; ++block)
  {
    runBlock(block);
  }
}

/// The same with a report now and then, always from the calling thread.
/// @throws Aborted if the progress says stop
inline void forBlocks(const ParallelFor& parallelFor, Index size, Index blockSize,
  const Progress& progress, const std::function<void(Index, Index)>& body)
{
  const Index chunkSize = 256 * blockSize;
  for (Index start = 0; start < size; start += chunkSize)
  {
    const Index length = std::min(chunkSize, size - start);
    forBlocks(parallelFor, length, blockSize,
      [&](Index begin, Index end) { body(start + begin, start + end); });
    report(progress, static_cast<double>(start + length) / static_cast<double>(size));
  }
}
}

#endif
