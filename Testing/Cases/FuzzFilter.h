// Run a filter in a fuzzer, and check its result.
#ifndef FuzzFilter_h
#define FuzzFilter_h

#include "FilterSource.h"
#include "Judge.h"

#include "vtkAlgorithm.h"

#include <cstdio>
#include <cstdlib>

namespace fuzz
{
inline void require(const cases::Outcome& outcome, const char* what)
{
  if (cases::isBad(outcome.Verdict))
  {
    std::fprintf(stderr, "%s: %s\n", what, outcome.Reason.c_str());
    std::abort();
  }
}

/// Run a filter. Abort the process unless the filter returns a valid and finite result, or a
/// message and an empty result.
/// @param[in] isClosed  whether a result must be a closed surface of genus zero
inline void run(vtkAlgorithm* filter, bool isClosed = false)
{
  const cases::Messages messages;
  filter->Update();
  require(cases::JudgeFilter(filter, messages, isClosed), filter->GetClassName());
}
}

#endif
