/// Divides the progress of a computation among its steps.

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
/// Gives each step of a computation its share of the progress:
///
///     Steps steps(run, { 0.4, 0.6 }); // tree, foot points
///     const TriangleTree tree(..., steps.next());
///     forBlocksReporting(steps.next(), ...);
///
/// Shares are fixed: parts of the time of one run on a surface of 100,000 points, measured on one
/// core in a release build (2026). Only their ratios matter. Progress therefore never falls and is
/// reported often, but it is no estimate of the time that is left.
class Steps
{
public:
  /// @param[in] shares  of each step; 0 for one that is left out
  Steps(Run whole, std::vector<double> shares)
    : Whole(std::move(whole))
    , Shares(std::move(shares))
    , Sum(std::accumulate(Shares.begin(), Shares.end(), 0.0))
  {
  }

  /// Report that the next step begins.
  /// @return the run of that step; a short step need not report progress
  /// @throws Aborted if the watcher stops the run
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
  double Done = 0.0; ///< sum of the shares of the steps so far
  double End = 0.0;  ///< progress at the end of the steps so far
};
}

#endif
