// Make properties with extreme and invalid values, for the tests of all classes.
#ifndef CasesProperties_h
#define CasesProperties_h

#include "Case.h"

#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace cases
{
/// Numbers that often cause errors.
inline constexpr std::array<std::pair<const char*, double>, 14> Extremes = {
  std::pair("NaN", std::numeric_limits<double>::quiet_NaN()),
  std::pair("inf", std::numeric_limits<double>::infinity()),
  std::pair("-inf", -std::numeric_limits<double>::infinity()), std::pair("-1", -1.0),
  std::pair("0", 0.0), std::pair("5e-324", std::numeric_limits<double>::denorm_min()),
  std::pair("1e-300", 1e-300), std::pair("1e-160", 1e-160), std::pair("1e-20", 1e-20),
  std::pair("1e20", 1e20), std::pair("1e160", 1e160), std::pair("1e300", 1e300),
  std::pair("1.8e308", std::numeric_limits<double>::max()),
  std::pair("-1.8e308", std::numeric_limits<double>::lowest())
};

inline std::vector<std::pair<std::string, double>> ExtremeValues()
{
  return { Extremes.begin(), Extremes.end() };
}

/// Return ids of points. Most of these points do not exist.
inline std::vector<std::pair<std::string, vtkIdType>> ExtremeIds()
{
  std::vector<std::pair<std::string, vtkIdType>> ids;
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(162), vtkIdType(0),
         std::numeric_limits<vtkIdType>::max(), std::numeric_limits<vtkIdType>::min() })
  {
    ids.emplace_back(std::to_string(id), id);
  }
  return ids;
}

/// Return a property with values of any type. The function `set` sets a value.
template <typename Filter, typename Value>
Property Values(const char* name, const std::vector<std::pair<std::string, Value>>& values,
  const std::function<void(Filter*, const Value&)>& set)
{
  Property property = { name, {} };
  property.IsNumber = std::is_same_v<Value, double>;
  for (const auto& [text, value] : values)
  {
    property.Values.emplace_back(text,
      [set, value = value](vtkAlgorithm* filter) { set(static_cast<Filter*>(filter), value); });
  }
  return property;
}

template <typename Filter>
Property Integer(const char* name, void (Filter::*set)(int))
{
  Property property = { name, {} };
  for (int value : { std::numeric_limits<int>::min(), -1, 0, 1, std::numeric_limits<int>::max() })
  {
    property.Values.emplace_back(std::to_string(value),
      [=](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(value); });
  }
  property.IsCount = true;
  return property;
}

template <typename Filter>
Property Number(const char* name, void (Filter::*set)(double))
{
  Property property = { name, {} };
  property.IsNumber = true;
  for (const auto& [text, value] : Extremes)
  {
    property.Values.emplace_back(text,
      [set, value = value](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(value); });
  }
  return property;
}

template <typename Filter>
Property Switch(const char* name, void (Filter::*set)(bool))
{
  Property property = { name, {} };
  for (bool value : { false, true })
  {
    property.Values.emplace_back(value ? "on" : "off",
      [=](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(value); });
  }
  return property;
}

/// Return a property that is the name of an array. Text is const char* or std::string.
template <typename Filter, typename Text>
Property Name(const char* name, void (Filter::*set)(Text))
{
  Property property = { name, {} };
  for (const auto& [what, value] : { std::pair<const char*, std::string>("empty", ""),
         { "missing", "no such array" }, { "of 3 components", "SpherePosition" },
         { "of bytes", "Colors" }, { "long", std::string(100000, 'x') }, { "two lines", "a\nb" } })
  {
    property.Values.emplace_back(what,
      [set, value = value](vtkAlgorithm* filter)
      { (static_cast<Filter*>(filter)->*set)(value.c_str()); });
  }
  if constexpr (std::is_same_v<Text, const char*>)
  {
    property.Values.emplace_back(
      "null", [=](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(nullptr); });
  }
  return property;
}

template <typename Filter>
Property Vector3(const char* name, void (Filter::*set)(double, double, double))
{
  Property property = { name, {} };
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  using Value = std::pair<const char*, std::vector<double>>;
  for (const auto& [text, v] : { Value("NaN", { NaN, 0.0, 1.0 }), Value("inf", { infinity, 0, 0 }),
         Value("zero", { 0, 0, 0 }), Value("5e-324", { 5e-324, 0, 0 }),
         Value("1e-200", { 1e-200, 1e-200, 0 }), Value("1e200", { 1e200, 0, 0 }),
         Value("-1e200", { -1e200, 1e200, 0 }), Value("1.8e308", { largest, largest, largest }),
         Value("up", { 0, 1, 0 }), Value("forward", { 0, 0, 1 }) })
  {
    property.Values.emplace_back(text,
      [set, v = v](vtkAlgorithm* filter)
      { (static_cast<Filter*>(filter)->*set)(v[0], v[1], v[2]); });
  }
  property.IsNumber = true;
  for (const auto& [text, value] : Extremes)
  {
    property.Values.emplace_back(std::string("0.1 ") + text + " 1",
      [set, value = value](vtkAlgorithm* filter)
      { (static_cast<Filter*>(filter)->*set)(0.1, value, 1.0); });
  }
  return property;
}

template <typename Filter, typename Value>
Property Vector2(const char* name, void (Filter::*set)(Value, Value))
{
  Property property = { name, {} };
  constexpr Value largest = std::numeric_limits<Value>::max();
  constexpr Value lowest = std::numeric_limits<Value>::lowest();
  std::vector<std::pair<Value, Value>> values = { { 0, 0 }, { -1, 5 }, { 1, 1 }, { 3, 70000 },
    { 65536, 65536 }, { largest, largest }, { lowest, 1 } };
  if constexpr (std::numeric_limits<Value>::has_infinity)
  {
    values.emplace_back(std::numeric_limits<Value>::infinity(), 1);
    values.emplace_back(1, std::numeric_limits<Value>::quiet_NaN());
    values.emplace_back(std::numeric_limits<Value>::denorm_min(), 1);
    property.IsNumber = true;
    for (const auto& [text, value] : Extremes)
    {
      property.Values.emplace_back(std::string(text) + " 1",
        [set, value = value](vtkAlgorithm* filter)
        { (static_cast<Filter*>(filter)->*set)(value, 1.0); });
    }
  }
  for (const auto& [a, b] : values)
  {
    property.Values.emplace_back(
      std::to_string(a).substr(0, 12) + " " + std::to_string(b).substr(0, 12),
      [set, a = a, b = b](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(a, b); });
  }
  return property;
}

/// Return a property of four numbers. In each value, one number is extreme, and the others have
/// their defaults.
template <typename Filter>
Property Vector4(const char* name, void (Filter::*set)(double, double, double, double),
  const std::array<double, 4>& defaults)
{
  Property property = { name, {} };
  property.IsNumber = true;
  for (std::size_t i = 0; i < defaults.size(); ++i)
  {
    for (const auto& [text, value] : Extremes)
    {
      std::array<double, 4> v = defaults;
      v[i] = value;
      property.Values.emplace_back(std::to_string(i) + " " + text,
        [set, v](vtkAlgorithm* filter)
        { (static_cast<Filter*>(filter)->*set)(v[0], v[1], v[2], v[3]); });
    }
  }
  return property;
}
}

#endif
