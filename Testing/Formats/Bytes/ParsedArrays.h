// Access and compare the results of parsers.
#ifndef ParsedArrays_h
#define ParsedArrays_h

#include "Bytes/SurfaceData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace samples
{
inline const conformal::NamedArray* find(
  const std::vector<conformal::NamedArray>& arrays, const char* name)
{
  const auto found = std::find_if(
    arrays.begin(), arrays.end(), [&](const auto& array) { return array.Name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

template <typename T>
std::vector<T> values(const conformal::NamedArray& array)
{
  std::vector<T> result(array.Values.size() / sizeof(T));
  std::copy_n(
    array.Values.data(), array.Values.size(), reinterpret_cast<unsigned char*>(result.data()));
  return result;
}

template <typename T>
void ExpectArray(const std::vector<conformal::NamedArray>& arrays, const char* name,
  conformal::ScalarType type, std::size_t components, const std::vector<T>& expected)
{
  const conformal::NamedArray* array = find(arrays, name);
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->Type, type) << name;
  EXPECT_EQ(array->Components, components) << name;
  EXPECT_EQ(values<T>(*array), expected) << name;
}

using Ids = std::vector<std::int64_t>;

inline Ids polygonIds(const conformal::SurfaceData& data)
{
  return Ids(data.PolygonIds.data(), data.PolygonIds.data() + data.PolygonIds.size());
}

inline Ids polygonOffsets(const conformal::SurfaceData& data)
{
  return Ids(data.PolygonOffsets.data(), data.PolygonOffsets.data() + data.PolygonOffsets.size());
}

inline bool AreSame(const conformal::NamedArray& a, const conformal::NamedArray& b)
{
  return a.Name == b.Name && a.Type == b.Type && a.Values.size() == b.Values.size() &&
    std::equal(a.Values.data(), a.Values.data() + a.Values.size(), b.Values.data());
}
}

#endif
