/// Scale vectors to unit length.

#ifndef ConformalUnitVectors_h
#define ConformalUnitVectors_h

#include "Bytes/NamedArray.h"

namespace conformal
{
/// Divide vectors by their length. Vectors whose length is 1 within 1e-12 are not changed. Vectors
/// that this library has written thus remain equal bit by bit.
/// @param[in,out] vectors  array of vectors of 3 components, Float64
/// @return false if a vector is zero or not finite
bool makeUnitVectors(NamedArray& vectors);
}

#endif
