// Run each trial in a separate process, with limits of time and memory.
#ifndef HostileRunTrial_h
#define HostileRunTrial_h

#include "Trial.h"

#include <functional>

namespace hostile
{
/// Outcome of a trial, and its CPU time.
struct Ended
{
  const hostile::Trial* Trial;
  cases::Outcome Outcome;
  double CPUSeconds;
};

/// Run trials, at most `jobs` at the same time. Each trial is reported after it has ended, in the
/// order of the list.
void RunTrials(
  const std::vector<Trial>& trials, int jobs, const std::function<void(const Ended&)>& report);
}

#endif
