#include "PLY/PLYWriter.h"

#include "Bytes/Records.h"
#include "Bytes/SurfaceWalk.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace conformal
{
namespace
{
const char* nameOf(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return "char";
    case ScalarType::UInt8:
      return "uchar";
    case ScalarType::Int16:
      return "short";
    case ScalarType::UInt16:
      return "ushort";
    case ScalarType::Int32:
      return "int";
    case ScalarType::UInt32:
      return "uint";
    case ScalarType::Float32:
      return "float";
    case ScalarType::Float64:
    case ScalarType::Int64: // PLY has no 8-byte integers
    case ScalarType::UInt64:
      break;
  }
  return "double";
}

// Properties of an element. Known arrays get the names that readers recognize.
class PLYProperties
{
public:
  void add(const NamedArray& array)
  {
    this->Arrays.push_back(&array);
    for (std::size_t c = 0; c < array.Components; ++c)
    {
      this->Text += std::string("property ") + nameOf(array.Type) + " " +
        this->Names.add(propertyName(array, c)) + "\n";
    }
  }

  // Reserve a name, so that no array gets this name.
  void keepFree(const std::string& name) { this->Names.add(name); }

  const std::string& text() const { return this->Text; }

  void append(std::string& bytes, std::size_t tuple) const
  {
    for (const NamedArray* array : this->Arrays)
    {
      const std::size_t size = sizeOf(array->Type);
      for (std::size_t i = tuple * array->Components; i < (tuple + 1) * array->Components; ++i)
      {
        if (array->Type == ScalarType::Int64 || array->Type == ScalarType::UInt64)
        {
          appendBytes(bytes, valueOf(*array, i), false);
        }
        else
        {
          appendBytes(bytes, array->Values.data() + i * size, size, false);
        }
      }
    }
  }

private:
  static std::string propertyName(const NamedArray& array, std::size_t component)
  {
    constexpr const char* coordinates[] = { "x", "y", "z" };
    if (array.Name == "Points" && array.Components == 3 && isFloating(array.Type))
    {
      return coordinates[component];
    }
    for (const KnownFields& known : knownFields())
    {
      if (array.Name == known.Array && array.Components == known.Names.size() &&
        known.Fits(array.Type))
      {
        return known.Names[component];
      }
    }
    return componentName(array, component);
  }

  std::vector<const NamedArray*> Arrays;
  FieldNames Names;
  std::string Text;
};
}

//------------------------------------------------------------------------------
std::string makePLY(const SurfaceData& surface, const Run& run)
{
  PLYProperties points;
  points.add(surface.Points);
  for (const NamedArray& array : surface.PointArrays)
  {
    points.add(array);
  }
  PLYProperties polygons;
  polygons.keepFree("vertex_indices");
  for (const NamedArray& array : surface.PolygonArrays)
  {
    polygons.add(array);
  }
  std::size_t longest = 0;
  for (std::size_t i = 0; i < numberOfPolygons(surface); ++i)
  {
    longest = std::max(
      longest, static_cast<std::size_t>(surface.PolygonOffsets[i + 1] - surface.PolygonOffsets[i]));
  }
  const bool isShort = longest <= std::numeric_limits<std::uint8_t>::max();
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
    std::to_string(surface.Points.numberOfTuples()) + "\n" + points.text();
  if (numberOfPolygons(surface) > 0)
  {
    bytes += "element face " + std::to_string(numberOfPolygons(surface)) + "\nproperty list " +
      (isShort ? "uchar" : "int") + " int vertex_indices\n" + polygons.text();
  }
  bytes += "end_header\n";
  walk(
    surface, run, [&](std::size_t point) { points.append(bytes, point); },
    [&](std::size_t polygon, const std::int64_t* ids, std::size_t count)
    {
      if (isShort)
      {
        appendBytes(bytes, static_cast<std::uint8_t>(count), false);
      }
      else
      {
        appendBytes(bytes, static_cast<std::int32_t>(count), false);
      }
      for (std::size_t c = 0; c < count; ++c)
      {
        appendBytes(bytes, static_cast<std::int32_t>(ids[c]), false);
      }
      polygons.append(bytes, polygon);
    });
  return bytes;
}
}
