#include "Bytes/SurfaceBytes.h"
#include "Bytes/SurfaceWalk.h"

#include <limits>
#include <set>

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
    case ScalarType::Int64: // PLY has no such integers
    case ScalarType::UInt64:
      break;
  }
  return "double";
}

// The properties of an element, with the names that readers know.
class PLYProperties
{
public:
  void add(const NamedArray& array)
  {
    this->Arrays.push_back(&array);
    for (std::size_t c = 0; c < array.Components; ++c)
    {
      std::string name = propertyName(array, c);
      while (!this->Names.insert(name).second)
      {
        name += "_";
      }
      this->Text += std::string("property ") + nameOf(array.Type) + " " + name + "\n";
    }
  }

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
    constexpr const char* known[][5] = { { "Points", "x", "y", "z", nullptr },
      { "Normals", "nx", "ny", "nz", nullptr }, { "TCoords", "s", "t", nullptr, nullptr },
      { "RGB", "red", "green", "blue", nullptr }, { "RGBA", "red", "green", "blue", "alpha" } };
    for (const auto& names : known)
    {
      const bool isColor = names[0][0] == 'R';
      const std::size_t components = std::find(names + 1, names + 5, nullptr) - (names + 1);
      if (array.Name == names[0] && array.Components == components &&
        (isColor ? isByte(array.Type) : isFloating(array.Type)))
      {
        return names[component + 1];
      }
    }
    std::string name = array.Name.empty() ? "array" : array.Name;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return c <= ' '; }, '_');
    return array.Components == 1 ? name : name + "_" + std::to_string(component);
  }

  std::vector<const NamedArray*> Arrays;
  std::set<std::string> Names;
  std::string Text;
};

// Triangles between points that are those of the surface or others.
std::string makeFreeSurfer(
  const SurfaceData& surface, const NamedArray& points, double scale, const ParseProgress& progress)
{
  requireTriangles(surface);
  std::string bytes = "\xFF\xFF\xFE"
                      "created by ConformalSOM\n\n";
  appendBytes(bytes, static_cast<std::int32_t>(surface.Points.numberOfTuples()), true);
  appendBytes(bytes, static_cast<std::int32_t>(numberOfPolygons(surface)), true);
  walk(
    surface, progress,
    [&](std::size_t point)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto value = static_cast<float>(scale * valueOf(points, 3 * point + c));
        if (!std::isfinite(value))
        {
          throw std::invalid_argument("a coordinate is no finite float");
        }
        appendBytes(bytes, value, true);
      }
    },
    [&](std::size_t, const std::int64_t* ids, std::size_t count)
    {
      for (std::size_t c = 0; c < count; ++c)
      {
        appendBytes(bytes, static_cast<std::int32_t>(ids[c]), true);
      }
    });
  return bytes;
}
}

//------------------------------------------------------------------------------
std::string makePLY(const SurfaceData& surface, const ParseProgress& progress)
{
  PLYProperties points;
  points.add(surface.Points);
  for (const NamedArray& array : surface.PointArrays)
  {
    points.add(array);
  }
  PLYProperties polygons;
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
    surface, progress, [&](std::size_t point) { points.append(bytes, point); },
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

//------------------------------------------------------------------------------
std::string makeFreeSurferSurface(const SurfaceData& surface, const ParseProgress& progress)
{
  return makeFreeSurfer(surface, surface.Points, 1.0, progress);
}

//------------------------------------------------------------------------------
std::string makeFreeSurferSphere(const SurfaceData& surface, const ParseProgress& progress)
{
  constexpr double radius = 100.0;
  const NamedArray* sphere = findSpherePositions(surface);
  if (!sphere)
  {
    throw std::invalid_argument("the surface has no array \"SpherePosition\" of 3 numbers");
  }
  return makeFreeSurfer(surface, *sphere, radius, progress);
}

//------------------------------------------------------------------------------
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const ParseProgress& progress)
{
  report(progress, 0.0);
  std::string bytes = "\xFF\xFF\xFF";
  appendBytes(bytes, static_cast<std::int32_t>(values.numberOfTuples()), true);
  appendBytes(bytes, static_cast<std::int32_t>(numberOfPolygons), true);
  appendBytes(bytes, std::int32_t(1), true);
  for (std::size_t i = 0; i < values.numberOfTuples(); ++i)
  {
    appendBytes(bytes, static_cast<float>(valueOf(values, i)), true);
  }
  return bytes;
}
}
