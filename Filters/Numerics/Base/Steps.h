/// Compute the progress of a computation from the progress of its steps.

#ifndef ConformalSteps_h
#define ConformalSteps_h

#include "Base/Run.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace conformal
{
/// Assign a share of the total progress to each step of a computation. For example, the second of
/// these steps has 60 % of the progress:
///
///     Steps steps(run, { 0.4, 0.6 }); // build a tree, find closest points
///     const TriangleTree tree(..., steps.next());
///     forBlocksReporting(steps.next(), ...);
///
/// Callers pass constants as shares: measured times of the steps. The times were measured for a
/// surface of 100,000 points, on one core in a release build (2026). Only the ratios of the shares
/// matter. Progress never decreases and is reported often. However, progress does not predict the
/// remaining time, since other surfaces have other ratios.
class Steps
{
public:
  /// @param[in] shares  relative durations of the steps; 0 for a step that is not executed
  Steps(Run whole, std::vector<double> shares)
    : Whole(std::move(whole))
    , Shares(std::move(shares))
    , Sum(std::accumulate(Shares.begin(), Shares.end(), 0.0))
  {
  }

  /// Begin the next step, and report the progress at its beginning.
  /// @return Run (threads and progress callback) to pass to that step. A short step need not report
  ///   progress.
  /// @throws Aborted if the progress callback returns false
  Run next()
  {
    const double begin = this->End;
    this->Done += this->Shares[this->Next++];
    this->End = this->Next < this->Shares.size() ? std::min(1.0, this->Done / this->Sum) : 1.0;
    this->Whole.report(begin);
    return this->Whole.part(begin, this->End);
  }

private:
  Run Whole;
  std::vector<double> Shares;
  double Sum;
  std::size_t Next = 0;
  double Done = 0.0; ///< sum of Shares over the steps that have begun
  double End = 0.0;  ///< progress at the end of the current step
};
}

#endif
