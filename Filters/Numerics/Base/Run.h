/// What a caller lends to a computation: threads to run on, and somebody who watches and may stop
/// it.
///
/// Results do not depend on the number of threads: work is cut into blocks of a fixed size,
/// whatever runs them, and blocks never add into each other's results.

#ifndef ConformalRun_h
#define ConformalRun_h

#include "Base/Types.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

namespace conformal
{
/// Runs body(i) once for every i in [0, count), in any order, perhaps at the same time.
using ParallelFor = std::function<void(Index count, const std::function<void(Index)>& body)>;

/// Called with the fraction done, in [0, 1], never falling, always from the calling thread.
/// Returns whether to go on; after a false the core throws Aborted.
using Progress = std::function<bool(double)>;

/// Thrown by every function of the core whose Progress returns false.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/// The context of one computation. Functions take it as their last argument; the default runs on
/// the calling thread and reports to nobody.
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
  /// @param[in] fraction  done, in [0, 1], never falling
  /// @throws Aborted if the watcher says stop
  void report(double fraction) const
  {
    if (this->Watcher && !this->Watcher(fraction))
    {
      throw Aborted();
    }
  }

  /// A part of this run: its [0, 1] is [begin, end] of the whole.
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

  /// The same threads; nobody watches. For parts that are too short to be reported.
  Run unwatched() const { return { this->Threads }; }

  /// The same threads, and another watcher.
  Run watchedBy(Progress watcher) const { return { this->Threads, std::move(watcher) }; }

  /// The same watcher; blocks run one after the other. For bodies that depend on their order.
  Run inOrder() const { return { ParallelFor(), this->Watcher }; }

  /// Run body(i) once for every i in [0, count), on all threads.
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

/// Run body(begin, end) over [0, size) in blocks of blockSize.
inline void forBlocks(
  const Run& run, Index size, Index blockSize, const std::function<void(Index, Index)>& body)
{
  run.forEach((size + blockSize - 1) / blockSize,
    [&](Index block) { body(block * blockSize, std::min(size, (block + 1) * blockSize)); });
}

/// The same with a report now and then, always from the calling thread: after a sixteenth of the
/// blocks, but no more than 256 and no less than 64, which keep many threads busy.
/// @throws Aborted if the watcher says stop
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
