/// A named array of numbers read from a file.

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
/// Numbers with a name, #T by Components of one type.
struct NamedArray
{
  std::string Name;
  ScalarType Type = ScalarType::Float32;
  std::size_t Components = 1;
  OwnedArray<unsigned char> Values; ///< as bytes in this machine's order

  std::size_t tupleBytes() const { return this->Components * sizeOf(this->Type); }
  std::size_t numberOfTuples() const { return this->Values.size() / this->tupleBytes(); }
};

/// An array without values.
NamedArray makeArray(const std::string& name, ScalarType type, std::size_t components);

/// Append a tuple of the array's type and number of components.
inline void append(NamedArray& array, const void* tuple)
{
  const std::size_t bytes = array.tupleBytes();
  array.Values.extend(bytes);
  std::memcpy(array.Values.data() + array.Values.size() - bytes, tuple, bytes);
}

/// Give each array a name of its own: a second "Shape" becomes "Shape2".
void makeNamesUnique(std::vector<NamedArray>& arrays);

/// Replace values that are not finite by 0. Returns how many there were.
std::uint64_t replaceNonFinite(NamedArray& array);
}

#endif
