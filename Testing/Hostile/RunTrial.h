// Runs trials in processes of their own, with limits of time and memory.
#ifndef HostileRunTrial_h
#define HostileRunTrial_h

#include "Trial.h"

#include <functional>

namespace hostile
{
/// What became of a trial, and what it cost.
struct Ended
{
  const hostile::Trial* Trial;
  cases::Outcome Outcome;
  double CPUSeconds;
};

/// Run trials, so many at a time; report each when it has ended, in the order of the list.
void RunTrials(
  const std::vector<Trial>& trials, int jobs, const std::function<void(const Ended&)>& report);
}

#endif
