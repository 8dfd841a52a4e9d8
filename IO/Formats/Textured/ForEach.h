/// Call a function for many indices, with progress reports.

#ifndef ConformalForEach_h
#define ConformalForEach_h

#include "Base/Run.h"

#include <algorithm>
#include <cstddef>

namespace conformal
{
/// Call body(i) for all i below `count`, and report progress from `begin` to `end`.
/// @throws Aborted if the progress callback of `run` returns false
template <typename Body>
void forEach(std::size_t count, const Run& run, double begin, double end, Body body)
{
  constexpr std::size_t chunk = 100000;
  for (std::size_t first = 0; first < count; first += chunk)
  {
    run.report(begin + (end - begin) * static_cast<double>(first) / static_cast<double>(count));
    const std::size_t last = std::min(count, first + chunk);
    for (std::size_t i = first; i < last; ++i)
    {
      body(i);
    }
  }
}
}

#endif
