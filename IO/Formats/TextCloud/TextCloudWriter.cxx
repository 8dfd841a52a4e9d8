#include "TextCloud/TextCloudWriter.h"

#include "Bytes/SurfaceWalk.h"

#include <algorithm>

namespace conformal
{
namespace
{
std::string asColumnName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c <= ' ' || c == ',' || c == ';' || c == '"'; },
    '_');
  return name.empty() ? "_" : name;
}
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
