#include "GuMesh/GuMeshWriter.h"

#include "Bytes/SurfaceWalk.h"

namespace conformal
{
namespace
{
// Append a trait of the format, such as key=(1 2 3).
template <typename Append>
void appendTrait(std::string& traits, const char* key, const NamedArray* array, std::size_t tuple,
  Append appendValue)
{
  if (array)
  {
    std::string value;
    appendValue(value, *array, tuple);
    traits += (traits.empty() ? "" : " ") + std::string(key) + "=(" + value.substr(1) + ")";
  }
}

// The format has no opacity.
void appendOpaque(std::string& text, const NamedArray& colors, std::size_t tuple)
{
  constexpr std::size_t components = 3;
  appendColor(text, colors, tuple, components);
}

std::string inBraces(const std::string& traits)
{
  return traits.empty() ? "\n" : " {" + traits + "}\n";
}
}

//------------------------------------------------------------------------------
std::string makeGuMesh(const SurfaceData& surface, const Run& run)
{
  const NamedArray* sphere = findSpherePositions(surface);
  const NamedArray* normals = findArray(surface.PointArrays, "Normals", 3, isFloating);
  const NamedArray* tcoords = findArray(surface.PointArrays, "TCoords", 2, isFloating);
  const NamedArray* colors = findColors(surface.PointArrays);
  const NamedArray* polygonColors = findColors(surface.PolygonArrays);
  std::string text;
  walk(
    surface, run,
    [&](std::size_t point)
    {
      text += "Vertex " + std::to_string(point + 1);
      appendTuple(text, surface.Points, point);
      std::string traits;
      appendTrait(traits, "sph", sphere, point, appendTuple);
      appendTrait(traits, "normal", normals, point, appendTuple);
      appendTrait(traits, "uv", tcoords, point, appendTuple);
      appendTrait(traits, "rgb", colors, point, appendOpaque);
      text += inBraces(traits);
    },
    [&](std::size_t polygon, const std::int64_t* ids, std::size_t count)
    {
      text += "Face " + std::to_string(polygon + 1);
      for (std::size_t c = 0; c < count; ++c)
      {
        text += ' ';
        appendNumber(text, ids[c] + 1);
      }
      std::string traits;
      appendTrait(traits, "rgb", polygonColors, polygon, appendOpaque);
      text += inBraces(traits);
    });
  return text;
}
}
