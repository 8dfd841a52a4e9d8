#include "Bytes/Records.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
template <std::size_t Bytes>
void copyStrided(const char* from, std::size_t fromStride, unsigned char* to, std::size_t toStride,
  std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(to + i * toStride, from + i * fromStride, Bytes);
  }
}

void copyStrided(const char* from, std::size_t fromStride, unsigned char* to, std::size_t toStride,
  std::size_t bytes, std::size_t count)
{
  if (bytes == fromStride && bytes == toStride)
  {
    std::memcpy(to, from, bytes * count);
    return;
  }
  switch (bytes) // constant sizes compile to one or two instructions
  {
    case 1:
      return copyStrided<1>(from, fromStride, to, toStride, count);
    case 3:
      return copyStrided<3>(from, fromStride, to, toStride, count);
    case 4:
      return copyStrided<4>(from, fromStride, to, toStride, count);
    case 8:
      return copyStrided<8>(from, fromStride, to, toStride, count);
    case 12:
      return copyStrided<12>(from, fromStride, to, toStride, count);
    case 24:
      return copyStrided<24>(from, fromStride, to, toStride, count);
    default:
      for (std::size_t i = 0; i < count; ++i)
      {
        std::memcpy(to + i * toStride, from + i * fromStride, bytes);
      }
  }
}

template <std::size_t Bytes>
void swapEach(unsigned char* values, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    std::reverse(values + i * Bytes, values + (i + 1) * Bytes);
  }
}

void swapEach(unsigned char* values, std::size_t bytes, std::size_t count)
{
  switch (bytes)
  {
    case 2:
      return swapEach<2>(values, count);
    case 4:
      return swapEach<4>(values, count);
    case 8:
      return swapEach<8>(values, count);
    default:
      return;
  }
}

template <typename T>
bool isFiniteTriple(const unsigned char* bytes)
{
  T p[3];
  std::memcpy(p, bytes, sizeof(p));
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}
}

//------------------------------------------------------------------------------
const std::vector<KnownFields>& knownFields()
{
  static const std::vector<KnownFields> known = { { "Normals", { "nx", "ny", "nz" }, isFloating },
    { "Normals", { "normal_x", "normal_y", "normal_z" }, isFloating },
    { "RGBA", { "red", "green", "blue", "alpha" }, isByte },
    { "RGB", { "red", "green", "blue" }, isByte },
    { "RGBA", { "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha" }, isByte },
    { "RGB", { "diffuse_red", "diffuse_green", "diffuse_blue" }, isByte },
    { "TCoords", { "s", "t" }, isFloating }, { "TCoords", { "u", "v" }, isFloating },
    { "TCoords", { "texture_u", "texture_v" }, isFloating } };
  return known;
}

//------------------------------------------------------------------------------
Records::Records(std::vector<RecordField> fields, bool hasPoints)
  : Fields(std::move(fields))
  , Slots(this->Fields.size())
{
  this->collectNames();
  if (hasPoints)
  {
    this->groupPoints();
  }
  for (const KnownFields& known : knownFields())
  {
    this->group(known);
  }
  this->groupNeighbors();
  this->Names.clear();
  this->findRuns();
}

//------------------------------------------------------------------------------
// Map names to fields. Without this map, each name would be searched in all fields, at quadratic
// cost.
void Records::collectNames()
{
  for (std::size_t i = 0; i < this->Fields.size(); ++i)
  {
    const auto [place, isNew] = this->Names.emplace(this->Fields[i].Name, i);
    if (!isNew)
    {
      place->second = None;
    }
  }
}

//------------------------------------------------------------------------------
// Find the field of each name. The result is empty if a name is missing or repeated, or its field
// is already assigned to an array.
std::vector<std::size_t> Records::find(const std::vector<std::string>& names) const
{
  std::vector<std::size_t> found;
  for (const std::string& name : names)
  {
    const auto place = this->Names.find(name);
    const std::size_t field = place == this->Names.end() ? None : place->second;
    if (field == None || !this->Fields[field].IsKept || this->Slots[field].Array != None)
    {
      return {};
    }
    found.push_back(field);
  }
  return found;
}

//------------------------------------------------------------------------------
void Records::addArray(
  const std::string& name, ScalarType type, const std::vector<std::size_t>& members)
{
  for (std::size_t component = 0; component < members.size(); ++component)
  {
    this->Slots[members[component]] = { this->Arrays.size(), component };
  }
  this->Arrays.push_back(makeArray(name, type, members.size()));
  this->Names.emplace(name, None);
}

//------------------------------------------------------------------------------
void Records::groupPoints()
{
  const std::vector<std::size_t> members = this->find({ "x", "y", "z" });
  if (members.empty())
  {
    throw std::invalid_argument(
      "found no properties x, y and z of the points with one number each");
  }
  const bool areFloats = std::all_of(members.begin(), members.end(),
    [&](std::size_t i) { return this->Fields[i].Type == ScalarType::Float32; });
  this->addArray("Points", areFloats ? ScalarType::Float32 : ScalarType::Float64, members);
}

//------------------------------------------------------------------------------
void Records::group(const KnownFields& known)
{
  const std::vector<std::size_t> members = this->find(known.Names);
  if (members.empty() || this->isTaken(known.Array))
  {
    return;
  }
  const ScalarType type = this->Fields[members[0]].Type;
  const bool isOneType = std::all_of(
    members.begin(), members.end(), [&](std::size_t i) { return this->Fields[i].Type == type; });
  if (isOneType && known.Fits(type))
  {
    this->addArray(known.Array, type, members);
  }
}

//------------------------------------------------------------------------------
void Records::groupNeighbors()
{
  for (std::size_t i = 0; i < this->Fields.size();)
  {
    const RecordField& field = this->Fields[i];
    if (!field.IsKept || this->Slots[i].Array != None)
    {
      ++i;
      continue;
    }
    const auto goOn = [&](std::size_t next, const std::string& name)
    {
      return next < this->Fields.size() && this->Fields[next].IsKept &&
        this->Slots[next].Array == None && this->Fields[next].Name == name &&
        this->Fields[next].Type == field.Type;
    };
    const bool isFirst = field.Name.size() > 2 && field.Name.substr(field.Name.size() - 2) == "_0";
    const std::string stem = isFirst ? field.Name.substr(0, field.Name.size() - 2) : "";
    const bool isNumbered = isFirst && goOn(i + 1, stem + "_1") && !this->isTaken(stem);
    std::vector<std::size_t> members;
    do
    {
      members.push_back(i++);
    } while (goOn(i, isNumbered ? stem + "_" + std::to_string(members.size()) : field.Name));
    this->addArray(isNumbered ? stem : field.Name, field.Type, members);
  }
}

//------------------------------------------------------------------------------
void Records::findRuns()
{
  for (std::size_t i = 0; i < this->Slots.size(); ++i)
  {
    const RecordField& field = this->Fields[i];
    const Slot slot = this->Slots[i];
    const std::size_t bytes = sizeOf(field.Type);
    if (!field.IsKept)
    {
      this->RecordBytes += bytes;
      continue;
    }
    if (this->Arrays[slot.Array].Type != field.Type)
    {
      this->Runs.clear();
      return;
    }
    const std::size_t place = slot.Component * bytes;
    Run* last = this->Runs.empty() ? nullptr : &this->Runs.back();
    if (last && last->Array == slot.Array && last->TupleOffset + last->Bytes == place &&
      last->RecordOffset + last->Bytes == this->RecordBytes)
    {
      last->Bytes += bytes;
    }
    else
    {
      this->Runs.push_back({ slot.Array, this->RecordBytes, place, bytes });
    }
    this->RecordBytes += bytes;
  }
}

//------------------------------------------------------------------------------
void Records::resize(std::size_t numberOfRecords)
{
  for (NamedArray& array : this->Arrays)
  {
    array.Values.resize(numberOfRecords * array.tupleBytes());
    array.Values.shrink();
  }
}

//------------------------------------------------------------------------------
void Records::copy(const char* packed, std::size_t numberOfRecords, std::size_t first, bool swap)
{
  for (const Run& run : this->Runs)
  {
    NamedArray& array = this->Arrays[run.Array];
    const std::size_t stride = array.tupleBytes();
    copyStrided(packed + run.RecordOffset, this->RecordBytes,
      array.Values.data() + first * stride + run.TupleOffset, stride, run.Bytes, numberOfRecords);
  }
  if (swap)
  {
    for (NamedArray& array : this->Arrays)
    {
      swapEach(array.Values.data() + first * array.tupleBytes(), sizeOf(array.Type),
        numberOfRecords * array.Components);
    }
  }
}

//------------------------------------------------------------------------------
void Records::copyField(std::size_t field, const char* from, std::size_t stride,
  std::size_t numberOfRecords, std::size_t first, bool swap)
{
  const Slot slot = this->Slots[field];
  NamedArray& array = this->Arrays[slot.Array];
  const std::size_t tupleBytes = array.tupleBytes();
  unsigned char* to =
    array.Values.data() + first * tupleBytes + slot.Component * sizeOf(array.Type);
  withType(this->Fields[field].Type,
    [&](auto zero)
    {
      const bool isSameType = array.Type == this->Fields[field].Type;
      for (std::size_t i = 0; i < numberOfRecords; ++i)
      {
        auto value = zero;
        char bytes[sizeof(value)];
        std::memcpy(bytes, from + i * stride, sizeof(value));
        if (swap)
        {
          std::reverse(bytes, bytes + sizeof(value));
        }
        std::memcpy(&value, bytes, sizeof(value));
        if (isSameType)
        {
          std::memcpy(to + i * tupleBytes, &value, sizeof(value));
        }
        else
        {
          const auto converted = static_cast<double>(value);
          std::memcpy(to + i * tupleBytes, &converted, sizeof(converted));
        }
      }
    });
}

//------------------------------------------------------------------------------
void Records::move(std::size_t from, std::size_t to)
{
  for (NamedArray& array : this->Arrays)
  {
    const std::size_t bytes = array.tupleBytes();
    std::memmove(array.Values.data() + to * bytes, array.Values.data() + from * bytes, bytes);
  }
}

//------------------------------------------------------------------------------
bool Records::isFinitePoint(std::size_t record) const
{
  const NamedArray& points = this->Arrays.front();
  const unsigned char* point = points.Values.data() + record * points.tupleBytes();
  return points.Type == ScalarType::Float32 ? isFiniteTriple<float>(point)
                                            : isFiniteTriple<double>(point);
}

//------------------------------------------------------------------------------
std::string componentName(const NamedArray& array, std::size_t component)
{
  const std::string name = array.Name.empty() ? "array" : array.Name;
  return array.Components == 1 ? name : name + "_" + std::to_string(component);
}

//------------------------------------------------------------------------------
std::string FieldNames::add(std::string wanted)
{
  std::replace_if(
    wanted.begin(), wanted.end(),
    [&](char c) { return (c >= 0 && c <= ' ') || this->Refused.find(c) != std::string::npos; },
    '_');
  while (!this->Taken.insert(wanted).second)
  {
    wanted += "_";
  }
  return wanted;
}
}
