#include "OFF/OFFWriter.h"

#include "Bytes/SurfaceWalk.h"

namespace conformal
{
//------------------------------------------------------------------------------
std::string makeOFF(const SurfaceData& surface, const Run& run)
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
    surface, run,
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
}
