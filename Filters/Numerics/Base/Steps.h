/// Divides the progress of a task among its steps, so that it is even in time.

#ifndef ConformalSteps_h
#define ConformalSteps_h

#include "Base/Run.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace conformal
{
/// Shares progress out to steps by the work that is expected of them:
///
///     Steps steps(run, { 500.0 * triangles, 900.0 * points });
///     const TriangleTree tree(..., steps.next());
///     forBlocksReporting(steps.next(), ...);
///
/// Work is what a step takes on one core, in nanoseconds where it is added to that of others; only
/// the ratios matter. It was measured with a clock around each step, in a release build, on meshes
/// of 3,000 to 600,000 vertices (2026). What machines and meshes make of it stays within the
/// factor to which Testing/Cxx/TestProgress.cxx holds every filter.
class Steps
{
public:
  /// @param[in] work  expected of each step
  Steps(Run whole, std::vector<double> work)
    : Whole(std::move(whole))
    , Work(std::move(work))
  {
  }

  /// Report that the next step begins.
  /// @return the run of that step, which short ones need not report
  /// @throws Aborted if the watcher says stop
  Run next()
  {
    const double left = std::accumulate(this->Work.begin() + this->Next, this->Work.end(), 0.0);
    const double begin = this->End, work = this->Work[this->Next++];
    this->End = work < left ? begin + (1.0 - begin) * work / left : 1.0;
    this->Whole.report(begin);
    return this->Whole.part(begin, this->End);
  }

  /// From here on other steps are left: they share what is left of the progress.
  void replan(std::vector<double> work)
  {
    this->Work = std::move(work);
    this->Next = 0;
  }

private:
  Run Whole;
  std::vector<double> Work;
  std::size_t Next = 0;
  double End = 0.0; ///< of the steps so far
};
}

#endif
