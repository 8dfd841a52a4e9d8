/// Raise a number to a positive integer power. Own construction, by repeated multiplication: the
/// result does not depend on the library function std::pow, and small powers are faster.

#ifndef ConformalIntegerPower_h
#define ConformalIntegerPower_h

namespace conformal
{
/// Return base^exponent.
/// @param[in] exponent  at least 1
inline double integerPower(double base, int exponent)
{
  double result = base;
  for (int i = 1; i < exponent; ++i)
  {
    result *= base;
  }
  return result;
}
}

#endif
