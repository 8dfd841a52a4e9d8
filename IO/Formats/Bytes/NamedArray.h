/// Define a named array of numbers, and functions for lists of such arrays.

#ifndef ConformalNamedArray_h
#define ConformalNamedArray_h

#include "Bytes/OwnedArray.h"
#include "Bytes/ScalarType.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace conformal
{
/// Array of numbers with a name. All numbers have the same type. Each tuple of the array has
/// `Components` numbers.
struct NamedArray
{
  std::string Name;
  ScalarType Type = ScalarType::Float32;
  std::size_t Components = 1;
  OwnedArray<unsigned char> Values; ///< bytes of the numbers, in the byte order of this machine

  std::size_t tupleBytes() const { return this->Components * sizeOf(this->Type); }
  std::size_t numberOfTuples() const { return this->Values.size() / this->tupleBytes(); }
};

/// Construct an array without values.
NamedArray makeArray(const std::string& name, ScalarType type, std::size_t components);

/// Append a tuple to an array.
/// @param[in] tuple  numbers of the tuple, as many as Components, of the type of the array
inline void append(NamedArray& array, const void* tuple)
{
  const std::size_t bytes = array.tupleBytes();
  array.Values.extend(bytes);
  std::memcpy(array.Values.data() + array.Values.size() - bytes, tuple, bytes);
}

/// Make names of arrays unique. For example, a second array "Shape" gets the name "Shape2".
void makeNamesUnique(std::vector<NamedArray>& arrays);

/// Replace the values of an array that are not finite by 0.
/// @return the number of replaced values
std::uint64_t replaceNonFinite(NamedArray& array);
}

#endif
