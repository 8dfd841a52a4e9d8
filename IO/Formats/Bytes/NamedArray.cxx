#include "Bytes/NamedArray.h"

#include <cmath>
#include <cstring>
#include <map>

namespace conformal
{
namespace
{
template <typename T>
std::uint64_t replaceNonFiniteOf(NamedArray& array)
{
  std::uint64_t replaced = 0;
  const std::size_t count = array.Values.size() / sizeof(T);
  for (std::size_t i = 0; i < count; ++i)
  {
    T value;
    unsigned char* place = array.Values.data() + i * sizeof(T);
    std::memcpy(&value, place, sizeof(T));
    if (!std::isfinite(value))
    {
      value = T(0);
      std::memcpy(place, &value, sizeof(T));
      ++replaced;
    }
  }
  return replaced;
}
}

//------------------------------------------------------------------------------
NamedArray makeArray(const std::string& name, ScalarType type, std::size_t components)
{
  NamedArray array;
  array.Name = name;
  array.Type = type;
  array.Components = components;
  return array;
}

//------------------------------------------------------------------------------
void makeNamesUnique(std::vector<NamedArray>& arrays)
{
  std::map<std::string, std::size_t> taken; // names in use, with the last number appended to each
  for (NamedArray& array : arrays)
  {
    auto place = taken.emplace(array.Name, 1);
    for (std::size_t& number = place.first->second; !place.second;)
    {
      place = taken.emplace(array.Name + std::to_string(++number), 1);
    }
    array.Name = place.first->first;
  }
}

//------------------------------------------------------------------------------
std::uint64_t replaceNonFinite(NamedArray& array)
{
  switch (array.Type)
  {
    case ScalarType::Float32:
      return replaceNonFiniteOf<float>(array);
    case ScalarType::Float64:
      return replaceNonFiniteOf<double>(array);
    default:
      return 0;
  }
}
}
