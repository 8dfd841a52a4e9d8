// What every fuzzer asks of a filter.
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

/// Run a filter; abort if it gave neither a whole and finite result nor a message and none.
/// @param[in] isClosed  whether a result must be a closed surface of genus zero
inline void run(vtkAlgorithm* filter, bool isClosed = false)
{
  const cases::Messages messages;
  filter->Update();
  require(cases::JudgeFilter(filter, messages, isClosed), filter->GetClassName());
}
}

#endif
