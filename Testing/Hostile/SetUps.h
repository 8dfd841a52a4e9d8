// Filters in their modes, and how cases come of them.
#ifndef HostileSetUps_h
#define HostileSetUps_h

#include "Case.h"
#include "Inputs.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace hostile
{
/// A property and the values it is given.
struct Property
{
  std::string Name;
  std::vector<std::pair<std::string, std::function<void(vtkAlgorithm*)>>> Values;

  /// Whether it may be a count, the last of its values being the largest: work without end, which
  /// must stop when asked to.
  bool IsCount = false;
};

struct SetUp
{
  std::string Class;
  std::string Mode;
  bool IsOurs = true;

  /// A filter with the input where it is to be tried, and with good data on its other ports.
  std::function<vtkSmartPointer<vtkAlgorithm>(vtkDataObject* input, vtkPolyData* good)> Make;

  /// Faults of the input that it must tell of.
  unsigned int Reads = 0;

  /// Whether the first output is a closed surface of genus zero.
  bool IsClosed = false;

  /// Whether it has other ports, whose data can be of another scale.
  bool HasOthers = false;

  std::vector<Property> Properties = {};

  /// Whether its points have no unit, so that they are the same for inputs of any scale.
  bool IsUnitless = false;

  /// Whether another set-up of the class reads the same arrays in the same way.
  bool IsVariant = false;

  std::string name() const
  {
    return this->Mode.empty() ? this->Class : this->Class + " (" + this->Mode + ")";
  }
};

/// One case for each input, and two for each scale where there are others it can differ from.
void AddCases(std::vector<Case>& all, const SetUp& setUp, const std::vector<Input>& inputs);

/// One case for each value of each property, on good data, and for the largest of counts runs that
/// are asked to stop at their first report of progress, and at their third.
void AddPropertyCases(std::vector<Case>& all, const SetUp& setUp);

/// Values that no property is made for, through its setter.
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
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double largest = std::numeric_limits<double>::max();
  for (const auto& [text, value] : { std::pair("NaN", std::numeric_limits<double>::quiet_NaN()),
         std::pair("inf", infinity), std::pair("-inf", -infinity), std::pair("-1", -1.0),
         std::pair("0", 0.0), std::pair("5e-324", std::numeric_limits<double>::denorm_min()),
         std::pair("1.8e308", largest), std::pair("-1.8e308", -largest) })
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

/// Names of arrays; Text is const char* or std::string.
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
  }
  for (const auto& [a, b] : values)
  {
    property.Values.emplace_back(
      std::to_string(a).substr(0, 12) + " " + std::to_string(b).substr(0, 12),
      [set, a = a, b = b](vtkAlgorithm* filter) { (static_cast<Filter*>(filter)->*set)(a, b); });
  }
  return property;
}

/// Extreme values of each of four numbers, the others as they are by default.
template <typename Filter>
Property Vector4(const char* name, void (Filter::*set)(double, double, double, double),
  const std::array<double, 4>& defaults)
{
  Property property = { name, {} };
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < defaults.size(); ++i)
  {
    using Value = std::pair<const char*, double>;
    for (const auto& [text, value] : { Value("NaN", NaN), Value("inf", infinity), Value("0", 0.0),
           Value("-1", -1.0), Value("5e-324", 5e-324), Value("1e300", 1e300) })
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
