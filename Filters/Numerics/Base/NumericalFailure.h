/// Throw NumericalFailure if a method fails on valid input, so that the caller can use another
/// method.

#ifndef ConformalNumericalFailure_h
#define ConformalNumericalFailure_h

#include <stdexcept>

namespace conformal
{
/// Exception thrown by a numerical method that finds no result for a valid input. One example is a
/// system of equations without a usable solution. Another example is a map in which a vertex has no
/// valid position. The caller can use another method.
class NumericalFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
