/// Exception for a method that fails on valid input, so that another method can be tried.

#ifndef ConformalNumericalFailure_h
#define ConformalNumericalFailure_h

#include <stdexcept>

namespace conformal
{
/// Thrown by a method that has no result for a valid input. Examples: equations without a usable
/// solution, or a map that leaves no feasible position for a vertex. Callers try another method.
class NumericalFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
