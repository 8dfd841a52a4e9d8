#include "TextCloud/TextCloudWriter.h"

#include "Bytes/Records.h"
#include "Bytes/SurfaceWalk.h"

namespace conformal
{
namespace
{
std::vector<std::string> fieldsOf(const NamedArray& array)
{
  if (array.Name == "Normals" && array.Components == 3)
  {
    return { "nx", "ny", "nz" };
  }
  if (array.Name == "RGB" && array.Components == 3 && isByte(array.Type))
  {
    return { "r", "g", "b" };
  }
  if (array.Name == "RGBA" && array.Components == 4 && isByte(array.Type))
  {
    return { "r", "g", "b", "a" };
  }
  std::vector<std::string> fields;
  for (std::size_t c = 0; c < array.Components; ++c)
  {
    fields.push_back(componentName(array, c));
  }
  return fields;
}

// Return a comment line with the names of all columns.
std::string titleOf(const std::vector<NamedArray>& arrays)
{
  FieldNames names(",;\"'#/"); // readers use these as separators, quotes and starts of comments
  std::string title = "#";
  const auto add = [&](const std::vector<std::string>& fields)
  {
    for (const std::string& field : fields)
    {
      title += " " + names.add(field);
    }
  };
  add({ "x", "y", "z" });
  for (const NamedArray& array : arrays)
  {
    add(fieldsOf(array));
  }
  return title + "\n";
}
}

//------------------------------------------------------------------------------
std::string makeTextCloud(const SurfaceData& surface, const Run& run)
{
  std::string text = surface.PointArrays.empty() ? "" : titleOf(surface.PointArrays);
  walk(
    surface, run,
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
