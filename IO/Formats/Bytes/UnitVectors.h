/// Normalize vectors that should be of unit length.

#ifndef ConformalUnitVectors_h
#define ConformalUnitVectors_h

#include "Bytes/NamedArray.h"

namespace conformal
{
/// Divide vectors by their length, except those of unit length to 1e-12. Vectors written by this
/// library thus keep their bits.
/// @param[in,out] vectors  #V by 3, Float64
/// @return false if a vector has no direction, or is not finite
bool makeUnitVectors(NamedArray& vectors);
}

#endif
