#include "Bytes/NumberText.h"
#include "Bytes/SurfaceBytes.h"
#include "Bytes/SurfaceWalk.h"

namespace conformal
{
namespace
{
// A tuple's numbers, each behind a blank.
void appendTuple(std::string& text, const NamedArray& array, std::size_t tuple)
{
  for (std::size_t c = 0; c < array.Components; ++c)
  {
    text += ' ';
    appendNumber(text, valueOf(array, tuple * array.Components + c));
  }
}

// Bytes as fractions: these are read back as the same bytes whatever the others are.
void appendColor(std::string& text, const NamedArray& colors, std::size_t tuple)
{
  constexpr float whole = 255.0F;
  for (std::size_t c = 0; c < colors.Components; ++c)
  {
    text += ' ';
    appendNumber(text, static_cast<float>(valueOf(colors, tuple * colors.Components + c)) / whole);
  }
}

// A trait of Gu's meshes, key=(1 2 3).
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

std::string inBraces(const std::string& traits)
{
  return traits.empty() ? "\n" : " {" + traits + "}\n";
}

std::string asColumnName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c <= ' ' || c == ',' || c == ';' || c == '"'; },
    '_');
  return name.empty() ? "_" : name;
}
}

//------------------------------------------------------------------------------
std::string makeOFF(const SurfaceData& surface, const ParseProgress& progress)
{
  const NamedArray* normals = findArray(surface.PointArrays, "Normals", 3, isFloating);
  const NamedArray* tcoords = findArray(surface.PointArrays, "TCoords", 2, isFloating);
  const NamedArray* colors = findColors(surface.PointArrays);
  const NamedArray* polygonColors = findColors(surface.PolygonArrays);
  const NamedArray* index = findArray(
    surface.PolygonArrays, "ColorIndex", 1, [](ScalarType type) { return !isFloating(type); });
  std::string text = std::string(tcoords ? "ST" : "") + (colors ? "C" : "") + (normals ? "N" : "") +
    "OFF\n" + std::to_string(surface.Points.numberOfTuples()) + " " +
    std::to_string(numberOfPolygons(surface)) + " 0\n";
  walk(
    surface, progress,
    [&](std::size_t point)
    {
      std::string line;
      appendTuple(line, surface.Points, point);
      if (normals)
      {
        appendTuple(line, *normals, point);
      }
      if (colors)
      {
        appendColor(line, *colors, point);
      }
      if (tcoords)
      {
        appendTuple(line, *tcoords, point);
      }
      text.append(line, 1);
      text += '\n';
    },
    [&](std::size_t polygon, const std::int64_t* ids, std::size_t count)
    {
      text += std::to_string(count);
      for (std::size_t c = 0; c < count; ++c)
      {
        text += ' ';
        appendNumber(text, ids[c]);
      }
      if (polygonColors)
      {
        appendColor(text, *polygonColors, polygon);
      }
      else if (index && valueOf(*index, polygon) >= 0.0)
      {
        appendTuple(text, *index, polygon);
      }
      text += '\n';
    });
  return text;
}

//------------------------------------------------------------------------------
std::string makeGuMesh(const SurfaceData& surface, const ParseProgress& progress)
{
  const NamedArray* sphere = findSpherePositions(surface);
  const NamedArray* normals = findArray(surface.PointArrays, "Normals", 3, isFloating);
  const NamedArray* tcoords = findArray(surface.PointArrays, "TCoords", 2, isFloating);
  const NamedArray* colors = findArray(surface.PointArrays, "RGB", 3, isByte);
  const NamedArray* polygonColors = findArray(surface.PolygonArrays, "RGB", 3, isByte);
  std::string text;
  walk(
    surface, progress,
    [&](std::size_t point)
    {
      text += "Vertex " + std::to_string(point + 1);
      appendTuple(text, surface.Points, point);
      std::string traits;
      appendTrait(traits, "sph", sphere, point, appendTuple);
      appendTrait(traits, "normal", normals, point, appendTuple);
      appendTrait(traits, "uv", tcoords, point, appendTuple);
      appendTrait(traits, "rgb", colors, point, appendColor);
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
      appendTrait(traits, "rgb", polygonColors, polygon, appendColor);
      text += inBraces(traits);
    });
  return text;
}

//------------------------------------------------------------------------------
std::string makeTextCloud(const SurfaceData& surface, const ParseProgress& progress)
{
  std::string text;
  for (const NamedArray& array : surface.PointArrays)
  {
    if (array.Name == "Normals" && array.Components == 3)
    {
      text += " nx ny nz";
    }
    else if (array.Name == "RGB" && array.Components == 3 && isByte(array.Type))
    {
      text += " r g b";
    }
    else if (array.Components == 1)
    {
      text += " " + asColumnName(array.Name);
    }
    else
    {
      for (std::size_t c = 0; c < array.Components; ++c)
      {
        text += " " + asColumnName(array.Name) + "_" + std::to_string(c);
      }
    }
  }
  text = text.empty() ? "" : "# x y z" + text + "\n";
  walk(
    surface, progress,
    [&](std::size_t point)
    {
      std::string line;
      appendTuple(line, surface.Points, point);
      for (const NamedArray& array : surface.PointArrays)
      {
        appendTuple(line, array, point);
      }
      text.append(line, 1);
      text += '\n';
    },
    [](std::size_t, const std::int64_t*, std::size_t) {});
  return text;
}
}
