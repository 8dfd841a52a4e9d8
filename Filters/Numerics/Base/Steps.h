/// Divide the progress of a task among its steps in proportion to their estimated cost.

#ifndef ConformalSteps_h
#define ConformalSteps_h

#include "Base/Run.h"

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace conformal
{
/// Divide the progress of a run among steps by their estimated cost:
///
///     Steps steps(run, { 500.0 * triangles, 900.0 * points });
///     const TriangleTree tree(..., steps.next());
///     forBlocksReporting(steps.next(), ...);
///
/// Only the ratios of the costs matter. They were measured on one core, in a release build, on
/// meshes of 3,000 to 600,000 vertices (2026). Testing/Cxx/TestProgress.cxx bounds the deviation on
/// other meshes for every filter.
class Steps
{
public:
  /// @param[in] work  estimated cost of each step, in any unit
  Steps(Run whole, std::vector<double> work)
    : Whole(std::move(whole))
    , Work(std::move(work))
  {
  }

  /// Report that the next step begins.
  /// @return the run of that step; a short step need not report progress
  /// @throws Aborted if the progress callback returns false
  Run next()
  {
    const double left = std::accumulate(this->Work.begin() + this->Next, this->Work.end(), 0.0);
    const double begin = this->End, work = this->Work[this->Next++];
    this->End = work < left ? begin + (1.0 - begin) * work / left : 1.0;
    this->Whole.report(begin);
    return this->Whole.part(begin, this->End);
  }

  /// Replace the steps that follow: the new ones share the remaining progress.
  void replan(std::vector<double> work)
  {
    this->Work = std::move(work);
    this->Next = 0;
  }

private:
  Run Whole;
  std::vector<double> Work;
  std::size_t Next = 0;
  double End = 0.0; ///< progress at the end of the current step
};
}

#endif
