/// Run computations on several threads, and report progress to a callback that can abort the
/// computation.
///
/// Results do not depend on the number of threads. Loops are divided into blocks of fixed size.
/// Each block writes only the results of its indices.

#ifndef ConformalRun_h
#define ConformalRun_h

#include "Base/Types.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

namespace conformal
{
/// Function that calls body(i) once for every i in [0, count), in any order and possibly
/// concurrently.
using ParallelFor = std::function<void(Index count, const std::function<void(Index)>& body)>;

/// Progress callback. The argument is the completed fraction in [0, 1], which never decreases. The
/// callback runs on the thread that started the computation. If the callback returns false, the
/// computation throws Aborted.
using Progress = std::function<bool(double)>;

/// Exception thrown after the progress callback returned false.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/// Threads and progress callback of one computation. A Run is the last parameter of functions with
/// a noticeable running time. A default-constructed Run uses only the calling thread and reports no
/// progress.
class Run
{
public:
  Run() = default;
  Run(ParallelFor threads, Progress progress = {})
    : Threads(std::move(threads))
    , Watcher(std::move(progress))
  {
  }

  /// Report progress.
  /// @param[in] fraction  completed fraction in [0, 1]; must not be lower than in earlier calls
  /// @throws Aborted if the progress callback returns false
  void report(double fraction) const
  {
    if (this->Watcher && !this->Watcher(fraction))
    {
      throw Aborted();
    }
  }

  /// Return a Run for one part of this computation. Progress from 0 to 1 of the part is reported as
  /// progress from `begin` to `end` of the whole computation.
  Run part(double begin, double end) const
  {
    if (!this->Watcher)
    {
      return *this;
    }
    return { this->Threads, [begin, end, whole = this->Watcher](double fraction) {
              return whole(fraction < 1.0 ? std::min(begin + fraction * (end - begin), end) : end);
            } };
  }

  /// Return a Run with the same threads and without progress reports, for steps too short to
  /// report.
  Run unwatched() const { return { this->Threads }; }

  /// Return a Run with the same threads and another progress callback.
  Run watchedBy(Progress watcher) const { return { this->Threads, std::move(watcher) }; }

  /// Return a Run that uses only the calling thread and has the same progress callback. Its loops
  /// are executed in ascending order. Use the returned Run if the result of a loop depends on the
  /// order of iterations.
  Run inOrder() const { return { ParallelFor(), this->Watcher }; }

  /// Call body(i) once for every i in [0, count), on all threads.
  void forEach(Index count, const std::function<void(Index)>& body) const
  {
    if (this->Threads)
    {
      this->Threads(count, body);
      return;
    }
    for (Index i = 0; i < count; ++i)
    {
      body(i);
    }
  }

private:
  ParallelFor Threads;
  Progress Watcher;
};

/// Number of consecutive indices in a block. An index of a light block costs less than a
/// microsecond, an index of a heavy block more. Sums over blocks change with these numbers, in
/// their last bits.
constexpr Index LightBlock = 1024, HeavyBlock = 256;

/// Call body(begin, end) for each block of up to `blockSize` consecutive indices in [0, size).
inline void forBlocks(
  const Run& run, Index size, Index blockSize, const std::function<void(Index, Index)>& body)
{
  run.forEach((size + blockSize - 1) / blockSize,
    [&](Index block) { body(block * blockSize, std::min(size, (block + 1) * blockSize)); });
}

/// Call body(begin, end) for each block of up to `blockSize` consecutive indices in [0, size).
/// Report progress from the calling thread after every n blocks. The number n is a sixteenth of the
/// number of blocks, clamped to [64, 256]. At least 64 blocks between reports keep many threads
/// busy. At most 256 blocks make reports frequent.
/// @throws Aborted if the progress callback returns false
inline void forBlocksReporting(
  const Run& run, Index size, Index blockSize, const std::function<void(Index, Index)>& body)
{
  const Index chunkSize = blockSize * std::clamp<Index>(size / blockSize / 16, 64, 256);
  for (Index start = 0; start < size; start += chunkSize)
  {
    const Index length = std::min(chunkSize, size - start);
    forBlocks(
      run, length, blockSize, [&](Index begin, Index end) { body(start + begin, start + end); });
    run.report(static_cast<double>(start + length) / static_cast<double>(size));
  }
}
}

#endif
