/// Normalization of vectors that should be of unit length.

#ifndef ConformalUnitVectors_h
#define ConformalUnitVectors_h

#include "Bytes/NamedArray.h"

namespace conformal
{
/// Divide vectors by their length, but for those that are of unit length to 1e-12 already: what
/// this library wrote stays as it is.
/// @param[in,out] vectors  #V by 3, Float64
/// @return false if one has no direction, or is not finite
bool makeUnitVectors(NamedArray& vectors);
}

#endif
