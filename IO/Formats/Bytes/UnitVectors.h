/// Normalize vectors that should be of unit length.

#ifndef ConformalUnitVectors_h
#define ConformalUnitVectors_h

#include "Bytes/NamedArray.h"

namespace conformal
{
/// Divide vectors by their length. Vectors whose length is 1 within 1e-12 are not changed, so that
/// vectors written by this library keep their bits.
/// @param[in,out] vectors  #V by 3, Float64
/// @return false if a vector is zero or not finite
bool makeUnitVectors(NamedArray& vectors);
}

#endif
