// Runs cases in processes of their own, with limits of time and memory.
#ifndef HostileRunCase_h
#define HostileRunCase_h

#include "Case.h"

#include <functional>

namespace hostile
{
/// What became of a case, and what it cost.
struct Ended
{
  const hostile::Case* Case;
  hostile::Outcome Outcome;
  double CPUSeconds;
};

/// Run cases, so many at a time; report each when it has ended, in the order of the list.
void RunCases(
  const std::vector<Case>& cases, int jobs, const std::function<void(const Ended&)>& report);
}

#endif
