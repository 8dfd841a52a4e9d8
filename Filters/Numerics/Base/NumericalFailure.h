/// The failure of a method that may be followed by another.

#ifndef ConformalNumericalFailure_h
#define ConformalNumericalFailure_h

#include <stdexcept>

namespace conformal
{
/// Thrown where a method has no result for an input that is valid: equations without a usable
/// solution, a map without room for a vertex. Callers try another method.
class NumericalFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
