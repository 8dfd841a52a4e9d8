/// Exception for a method that fails on valid input, so that another method can be tried.

#ifndef ConformalNumericalFailure_h
#define ConformalNumericalFailure_h

#include <stdexcept>

namespace conformal
{
/// Exception thrown by a method that finds no result for a valid input. Examples are equations
/// without a usable solution, or a map in which a vertex has no valid position. The caller can try
/// another method.
class NumericalFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
