#include "E57/E57Arrays.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
using ThreeNames = std::array<std::string, NumberOfAxes>;

const ThreeNames& cartesianNames()
{
  static const ThreeNames names = { "cartesianX", "cartesianY", "cartesianZ" };
  return names;
}

const ThreeNames& sphericalNames()
{
  static const ThreeNames names = { "sphericalRange", "sphericalAzimuth", "sphericalElevation" };
  return names;
}

const ThreeNames& colorNames()
{
  static const ThreeNames names = { "colorRed", "colorGreen", "colorBlue" };
  return names;
}

const ThreeNames& normalNames()
{
  static const ThreeNames names = { "nor:normalX", "nor:normalY", "nor:normalZ" };
  return names;
}

constexpr const char* CartesianState = "cartesianInvalidState";
constexpr const char* SphericalState = "sphericalInvalidState";

bool hasAll(const E57Scan& scan, const ThreeNames& names)
{
  return std::all_of(names.begin(), names.end(),
    [&](const std::string& name)
    {
      const E57Field* field = scan.find(name);
      return field && field->Kind != E57Kind::Text;
    });
}

// Values that the fields of one name have in all scans.
struct ValueRange
{
  std::size_t NumberOfScans = 0;
  bool HasDoubles = false;
  bool HasFloats = false;
  std::int64_t Minimum = std::numeric_limits<std::int64_t>::max();
  std::int64_t Maximum = std::numeric_limits<std::int64_t>::min();

  void add(const E57Field& field)
  {
    ++this->NumberOfScans;
    this->HasDoubles =
      this->HasDoubles || field.Kind == E57Kind::Float64 || field.Kind == E57Kind::ScaledInteger;
    this->HasFloats = this->HasFloats || field.Kind == E57Kind::Float32;
    if (field.Kind == E57Kind::Integer)
    {
      this->Minimum = std::min(this->Minimum, field.Minimum);
      this->Maximum = std::max(this->Maximum, field.Maximum);
    }
  }

  // Return the smallest type for all values.
  ScalarType type() const
  {
    const bool hasIntegers = this->Minimum <= this->Maximum;
    if (this->HasDoubles || this->HasFloats)
    {
      return this->HasDoubles || hasIntegers ? ScalarType::Float64 : ScalarType::Float32;
    }
    static const struct
    {
      std::int64_t Low;
      std::int64_t High;
      ScalarType Type;
    } types[] = { { 0, 0xFF, ScalarType::UInt8 }, { -0x80, 0x7F, ScalarType::Int8 },
      { 0, 0xFFFF, ScalarType::UInt16 }, { -0x8000, 0x7FFF, ScalarType::Int16 },
      { -0x80000000LL, 0x7FFFFFFFLL, ScalarType::Int32 }, { 0, 0xFFFFFFFFLL, ScalarType::UInt32 } };
    for (const auto& entry : types)
    {
      if (this->Minimum >= entry.Low && this->Maximum <= entry.High)
      {
        return entry.Type;
      }
    }
    return ScalarType::Int64;
  }
};

// Return the values of a color that become 0 and 255. Integers from 0 to 255 are not changed.
// Return nothing if the limits are unknown.
std::optional<std::pair<double, double>> limitsOfColor(const E57Scan& scan, const E57Field& field)
{
  double low = 0.0;
  double high = 0.0;
  if (field.Kind == E57Kind::Integer)
  {
    low = static_cast<double>(field.Minimum);
    high = static_cast<double>(field.Maximum);
  }
  const auto minimum = scan.ColorLimits.find(field.Name + "Minimum");
  const auto maximum = scan.ColorLimits.find(field.Name + "Maximum");
  if (minimum != scan.ColorLimits.end() && maximum != scan.ColorLimits.end())
  {
    low = minimum->second;
    high = maximum->second;
  }
  if (field.Kind == E57Kind::Integer && low >= 0.0 && high <= 255.0)
  {
    return std::make_pair(0.0, 255.0);
  }
  return high > low ? std::make_optional(std::make_pair(low, high)) : std::nullopt;
}

bool haveColors(const std::vector<E57Scan>& scans)
{
  return !scans.empty() &&
    std::all_of(scans.begin(), scans.end(),
      [](const E57Scan& scan)
      {
        return hasAll(scan, colorNames()) &&
          std::all_of(colorNames().begin(), colorNames().end(),
            [&](const std::string& name) { return limitsOfColor(scan, *scan.find(name)); });
      });
}

bool haveNormals(const std::vector<E57Scan>& scans)
{
  return !scans.empty() &&
    std::all_of(
      scans.begin(), scans.end(), [](const E57Scan& scan) { return hasAll(scan, normalNames()); });
}

// Return the values of all fields that can become arrays of one component.
std::map<std::string, ValueRange> rangesOf(const std::vector<E57Scan>& scans)
{
  std::map<std::string, ValueRange> ranges;
  for (const E57Scan& scan : scans)
  {
    for (const E57Field& field : scan.Fields)
    {
      if (field.Kind != E57Kind::Text)
      {
        ranges[field.Name].add(field);
      }
    }
  }
  for (const ThreeNames* names : { &cartesianNames(), &sphericalNames() })
  {
    for (const std::string& name : *names)
    {
      ranges.erase(name);
    }
  }
  ranges.erase(CartesianState);
  ranges.erase(SphericalState);
  return ranges;
}
}

//------------------------------------------------------------------------------
bool isSpherical(const E57Scan& scan)
{
  return !hasAll(scan, cartesianNames());
}

//------------------------------------------------------------------------------
bool hasScannerPosition(const E57Scan& scan)
{
  return hasAll(scan, sphericalNames()) || (scan.find("rowIndex") && scan.find("columnIndex"));
}

//------------------------------------------------------------------------------
const std::array<std::string, NumberOfAxes>& coordinateNames(const E57Scan& scan)
{
  if (!isSpherical(scan))
  {
    return cartesianNames();
  }
  if (!hasAll(scan, sphericalNames()))
  {
    throw std::invalid_argument("found a scan with neither cartesianX, cartesianY, cartesianZ nor "
                                "sphericalRange, sphericalAzimuth, sphericalElevation");
  }
  return sphericalNames();
}

//------------------------------------------------------------------------------
E57Arrays::E57Arrays(const std::vector<E57Scan>& scans)
  : Points(makeArray("Points", ScalarType::Float64, NumberOfAxes))
  , Invalid(makeArray("Invalid", ScalarType::UInt8, 1))
{
  for (const E57Scan& scan : scans)
  {
    coordinateNames(scan);
  }
  std::map<std::string, ValueRange> ranges = rangesOf(scans);
  const auto addGroup = [&](const ThreeNames& names, const char* array, ScalarType type)
  {
    for (std::size_t c = 0; c < NumberOfAxes; ++c)
    {
      this->Places[names[c]] = { this->PointArrays.size(), c, type == ScalarType::UInt8 };
      ranges.erase(names[c]);
    }
    this->PointArrays.push_back(makeArray(array, type, NumberOfAxes));
  };
  if (haveColors(scans))
  {
    addGroup(colorNames(), "RGB", ScalarType::UInt8);
  }
  if (haveNormals(scans))
  {
    const bool areFloats = std::all_of(normalNames().begin(), normalNames().end(),
      [&](const std::string& name) { return ranges[name].type() == ScalarType::Float32; });
    this->NormalsIndex = this->PointArrays.size();
    addGroup(normalNames(), "Normals", areFloats ? ScalarType::Float32 : ScalarType::Float64);
  }
  const std::vector<E57Field> none;
  for (const E57Field& field : scans.empty() ? none : scans.front().Fields)
  {
    const auto range = ranges.find(field.Name);
    if (range != ranges.end() && range->second.NumberOfScans == scans.size())
    {
      this->Places[field.Name] = { this->PointArrays.size(), 0, false };
      this->PointArrays.push_back(
        makeArray(field.Name == "intensity" ? "Intensity" : field.Name, range->second.type(), 1));
    }
  }
}

//------------------------------------------------------------------------------
std::size_t E57Arrays::pointBytes() const
{
  std::size_t bytes = this->Points.tupleBytes() + this->Invalid.tupleBytes();
  for (const NamedArray& array : this->PointArrays)
  {
    bytes += array.tupleBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void E57Arrays::resize(std::size_t numberOfPoints)
{
  this->Points.Values.resize(numberOfPoints * this->Points.tupleBytes());
  for (NamedArray& array : this->PointArrays)
  {
    array.Values.resize(numberOfPoints * array.tupleBytes());
  }
  this->Invalid.Values.resize(numberOfPoints);
  std::fill_n(this->Invalid.Values.data(), numberOfPoints, static_cast<unsigned char>(0));
}

//------------------------------------------------------------------------------
E57Target E57Arrays::targetOf(const E57Scan& scan, const E57Field& field, std::size_t firstTuple)
{
  E57Target target;
  target.FirstTuple = firstTuple;
  const auto& coordinates = coordinateNames(scan);
  const auto coordinate = std::find(coordinates.begin(), coordinates.end(), field.Name);
  const auto place = this->Places.find(field.Name);
  if (coordinate != coordinates.end())
  {
    target.Array = &this->Points;
    target.Component = static_cast<std::size_t>(coordinate - coordinates.begin());
  }
  else if (field.Kind == E57Kind::Text)
  {
    return target;
  }
  else if (field.Name == (isSpherical(scan) ? SphericalState : CartesianState))
  {
    target.Array = &this->Invalid;
    target.Store = E57Store::Flag;
  }
  else if (place != this->Places.end())
  {
    target.Array = &this->PointArrays[place->second.Array];
    target.Component = place->second.Component;
    if (place->second.IsColor)
    {
      const auto limits = *limitsOfColor(scan, field);
      target.Store = E57Store::Color;
      target.Low = limits.first;
      target.High = limits.second;
    }
  }
  return target;
}

//------------------------------------------------------------------------------
void E57Arrays::removeInvalid()
{
  const std::size_t count = this->Invalid.numberOfTuples();
  const unsigned char* const invalid = this->Invalid.Values.data();
  const auto compress = [&](NamedArray& array)
  {
    const std::size_t bytes = array.tupleBytes();
    unsigned char* const values = array.Values.data();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (kept != i)
      {
        std::memmove(values + kept * bytes, values + i * bytes, bytes);
      }
      kept += invalid[i] == 0 ? 1 : 0;
    }
    array.Values.resize(kept * bytes);
  };
  if (std::any_of(invalid, invalid + count, [](unsigned char flag) { return flag != 0; }))
  {
    compress(this->Points);
    for (NamedArray& array : this->PointArrays)
    {
      compress(array);
    }
  }
}
}
