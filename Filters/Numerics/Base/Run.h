/// Execution context of a computation: a thread pool, and a progress callback that may abort.
///
/// Results do not depend on the number of threads. Work is divided into blocks of fixed size, and
/// each block writes only its own results.

#ifndef ConformalRun_h
#define ConformalRun_h

#include "Base/Types.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

namespace conformal
{
/// Run body(i) once for every i in [0, count), in any order and possibly concurrently.
using ParallelFor = std::function<void(Index count, const std::function<void(Index)>& body)>;

/// Progress callback. Its argument is the completed fraction in [0, 1], which never decreases. The
/// callback runs on the thread that started the computation. If it returns false, the computation
/// throws Aborted.
using Progress = std::function<bool(double)>;

/// Exception thrown after the progress callback returned false.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/// Execution context of one computation, passed as the last argument. A default-constructed run
/// uses only the calling thread and reports no progress.
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
  /// @param[in] fraction  completed fraction in [0, 1]; must not decrease
  /// @throws Aborted if the progress callback returns false
  void report(double fraction) const
  {
    if (this->Watcher && !this->Watcher(fraction))
    {
      throw Aborted();
    }
  }

  /// Return a run for one part of this computation. Its progress from 0 to 1 is reported as
  /// progress from `begin` to `end` of this run.
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

  /// Return a run with the same threads and without progress reports, for steps too short to
  /// report.
  Run unwatched() const { return { this->Threads }; }

  /// Return a run with the same threads and another progress callback.
  Run watchedBy(Progress watcher) const { return { this->Threads, std::move(watcher) }; }

  /// Return a run with the same progress callback but without threads. It executes blocks serially
  /// in ascending order, for bodies that depend on the order.
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

/// Call body(begin, end) for each block of up to `blockSize` consecutive indices in [0, size).
inline void forBlocks(
  const Run& run, Index size, Index blockSize, const std::function<void(Index, Index)>& body)
{
  run.forEach((size + blockSize - 1) / blockSize,
    [&](Index block) { body(block * blockSize, std::min(size, (block + 1) * blockSize)); });
}

/// Call body(begin, end) for each block of up to `blockSize` consecutive indices in [0, size), and
/// report progress from the calling thread. Progress is reported after each sixteenth of the
/// blocks, but at least 64 and at most 256 blocks, so that many threads stay busy.
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
