#include "Textured/GLBFile.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FloatRange.h"
#include "Bytes/NumberText.h"
#include "Textured/ForEach.h"
#include "Textured/GLBDocument.h"
#include "Textured/VertexPacking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
// Choose the origin of the coordinates in the file. If floats are too coarse at this distance from
// the origin of the surface, choose the center of its bounding box.
std::array<double, 3> originOf(const std::vector<double>& positions)
{
  const FloatRounding rounding =
    floatRoundingOf(positions.size(), [&](std::size_t i) { return positions[i]; });
  std::array<double, 3> origin = { 0.0, 0.0, 0.0 };
  for (std::size_t c = 0; c < 3 && rounding.isTooCoarse(); ++c)
  {
    origin[c] = 0.5 * rounding.Low[c] + 0.5 * rounding.High[c];
  }
  return origin;
}

void requireScaleRange(double scale)
{
  using Limits = std::numeric_limits<float>;
  if (!(scale <= Limits::max() && scale >= Limits::min()))
  {
    throw std::invalid_argument("the coordinates in meters do not fit into 32-bit floats");
  }
}

// Return the transform of the node, from coordinates of the file to meters, as JSON.
std::string placementOf(const std::array<double, 3>& origin, double metersPerUnit)
{
  std::string text;
  if (origin != std::array<double, 3>{ 0.0, 0.0, 0.0 })
  {
    std::string numbers;
    for (const double coordinate : origin)
    {
      const double meters = coordinate * metersPerUnit;
      if (!(std::abs(meters) <= std::numeric_limits<float>::max()))
      {
        throw std::invalid_argument("a coordinate in meters is not finite as a 32-bit float");
      }
      numbers += numbers.empty() ? "" : ",";
      appendNumber(numbers, meters);
    }
    text += ",\"translation\":[" + numbers + "]";
  }
  if (metersPerUnit != 1.0)
  {
    requireScaleRange(metersPerUnit);
    std::string unit;
    appendNumber(unit, metersPerUnit);
    text += ",\"scale\":[" + unit + "," + unit + "," + unit + "]";
  }
  return text;
}

// Compute the minimum and maximum of the positions, as floats like in the file.
template <typename Coordinate>
std::string boundsOf(std::size_t count, Coordinate coordinate)
{
  std::array<float, 3> low;
  std::array<float, 3> high;
  for (std::size_t c = 0; c < 3; ++c)
  {
    low[c] = high[c] = static_cast<float>(coordinate(c));
  }
  for (std::size_t i = 3; i < count; ++i)
  {
    const float value = static_cast<float>(coordinate(i));
    low[i % 3] = std::min(low[i % 3], value);
    high[i % 3] = std::max(high[i % 3], value);
  }
  std::string text;
  const auto append = [&](const char* name, const std::array<float, 3>& corner)
  {
    text += name;
    for (std::size_t c = 0; c < 3; ++c)
    {
      text += c > 0 ? "," : "";
      appendNumber(text, static_cast<double>(corner[c])); // readers compare as doubles
    }
    text += "]";
  };
  append(",\"min\":[", low);
  append(",\"max\":[", high);
  return text;
}

// Return the transform of the node for packed positions, as JSON.
std::string placementOf(const PackedPositions& packed, double metersPerUnit)
{
  std::string translation, scale;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double meters = packed.Offset[c] * metersPerUnit, step = packed.Scale * metersPerUnit;
    requireScaleRange(step);
    if (!(std::abs(meters) <= std::numeric_limits<float>::max()))
    {
      throw std::invalid_argument("the coordinates in meters do not fit into 32-bit floats");
    }
    translation += c > 0 ? "," : "";
    scale += c > 0 ? "," : "";
    appendNumber(translation, meters);
    appendNumber(scale, step);
  }
  return ",\"translation\":[" + translation + "],\"scale\":[" + scale + "]";
}

std::string boundsOf(const std::vector<std::uint16_t>& packed)
{
  std::array<std::uint16_t, 3> low, high;
  std::copy_n(packed.begin(), 3, low.begin());
  high = low;
  for (std::size_t i = 0; i < packed.size(); ++i)
  {
    if (i % 4 < 3)
    {
      low[i % 4] = std::min(low[i % 4], packed[i]);
      high[i % 4] = std::max(high[i % 4], packed[i]);
    }
  }
  const auto list = [](const std::array<std::uint16_t, 3>& values)
  {
    return "[" + std::to_string(values[0]) + "," + std::to_string(values[1]) + "," +
      std::to_string(values[2]) + "]";
  };
  return ",\"min\":" + list(low) + ",\"max\":" + list(high);
}

// Return the scale and offset of packed texture coordinates, as an extension of a texture.
std::string transformOf(const PackedTexCoords& packed)
{
  std::string text = ",\"extensions\":{\"KHR_texture_transform\":{\"offset\":[";
  appendNumber(text, packed.Offset[0]);
  text += ",";
  appendNumber(text, packed.Offset[1]);
  text += "],\"scale\":[";
  appendNumber(text, packed.Scale[0]);
  text += ",";
  appendNumber(text, packed.Scale[1]);
  return text + "]}}";
}

void addAttribute(std::string& attributes, const char* name, int accessor)
{
  attributes += attributes.empty() ? "" : ",";
  attributes += "\"" + std::string(name) + "\":" + std::to_string(accessor);
}

// Add the corners of the triangles as 32-bit ids, and return their accessor.
int addCorners(GLBDocument& document, const TexturedSurface& surface, const Run& run)
{
  const std::size_t begin = document.Bytes.size();
  forEach(surface.Corners.size(), run, 0.0, 1.0,
    [&](std::size_t i) { appendBytes(document.Bytes, surface.Corners[i], false); });
  return document.addAccessor(document.addView(begin, gltf::ElementArrayBuffer), gltf::UnsignedInt,
    "SCALAR", surface.Corners.size());
}

// Add a level with packed vertices. `texCoords` are two numbers for each of its points.
void addPackedLevel(GLBDocument& document, const TexturedSurface& surface,
  const std::uint16_t* texCoords, bool isCompressed, const Run& run)
{
  static_assert(sizeof(std::uint16_t) == 2);
  const std::size_t count = surface.Positions.size() / 3;
  const PackedPositions positions = packPositions(surface.Positions, isCompressed ? 14 : 16);
  const std::string placement = placementOf(positions, document.MetersPerUnit);
  const auto add = [&](const void* values, std::size_t stride)
  {
    return isCompressed ? document.addCompressed(compressVertices(values, count, stride), count,
                            stride, "\"mode\":\"ATTRIBUTES\"", false)
                        : document.addVertices(values, count, stride);
  };
  const auto addDirections = [&](const std::vector<float>& vectors, float fourth)
  {
    return isCompressed ? document.addCompressed(compressDirections(vectors, fourth), count, 4,
                            "\"mode\":\"ATTRIBUTES\",\"filter\":\"OCTAHEDRAL\"", false)
                        : document.addVertices(packDirections(vectors, fourth).data(), count, 4);
  };
  std::string attributes;
  addAttribute(attributes, "POSITION",
    document.addAccessor(add(positions.Values.data(), 8), gltf::UnsignedShort, "VEC3", count,
      boundsOf(positions.Values)));
  run.report(0.5);
  if (!surface.Normals.empty())
  {
    addAttribute(attributes, "NORMAL",
      document.addAccessor(addDirections(surface.Normals, 0.0F), gltf::SignedByte, "VEC3", count,
        ",\"normalized\":true"));
  }
  if (!surface.Tangents.empty())
  {
    addAttribute(attributes, "TANGENT",
      document.addAccessor(addDirections(surface.Tangents, 1.0F), gltf::SignedByte, "VEC4", count,
        ",\"normalized\":true"));
  }
  addAttribute(attributes, "TEXCOORD_0",
    document.addAccessor(add(texCoords, 4), gltf::UnsignedShort, "VEC2", count));
  run.report(0.7);
  const int corners = isCompressed
    ? document.addAccessor(document.addCompressed(compressCorners(surface.Corners, count),
                             surface.Corners.size(), 4, "\"mode\":\"TRIANGLES\"", true),
        gltf::UnsignedInt, "SCALAR", surface.Corners.size())
    : addCorners(document, surface, run.part(0.7, 1.0));
  document.addMesh(attributes, corners, count, placement);
}

// Add all levels with packed vertices. Their texture coordinates have the same steps, since levels
// share the material.
void addPackedLevels(
  GLBDocument& document, std::vector<TexturedSurface> levels, bool isCompressed, const Run& run)
{
  std::vector<float> all;
  for (TexturedSurface& level : levels)
  {
    level = isCompressed ? sortedForCompression(level) : level;
    all.insert(all.end(), level.TexCoords.begin(), level.TexCoords.end());
  }
  run.report(0.3);
  const PackedTexCoords packed = packTexCoords(all, isCompressed ? 13 : 16);
  document.TextureTransform = transformOf(packed);
  const std::uint16_t* texCoords = packed.Values.data();
  for (const TexturedSurface& level : levels)
  {
    addPackedLevel(document, level, texCoords, isCompressed, run.part(0.3, 1.0));
    texCoords += level.TexCoords.size();
  }
}

// Append numbers as floats, and return their accessor.
template <typename Number>
int addFloats(GLBDocument& document, std::size_t count, std::size_t components, const char* type,
  const std::string& bounds, const Run& run, Number number)
{
  const std::size_t begin = document.Bytes.size();
  forEach(count * components, run, 0.0, 1.0,
    [&](std::size_t i) { appendBytes(document.Bytes, static_cast<float>(number(i)), false); });
  return document.addAccessor(
    document.addView(begin, gltf::ArrayBuffer), gltf::Float, type, count, bounds);
}

// Add a level with vertices of floats.
void addLevel(GLBDocument& document, const TexturedSurface& surface, const Run& run)
{
  const std::array<double, 3> origin = originOf(surface.Positions);
  const std::string placement = placementOf(origin, document.MetersPerUnit);
  const auto coordinate = [&](std::size_t i) { return surface.Positions[i] - origin[i % 3]; };
  requireFloatRange(surface.Positions.size(), coordinate);
  const std::size_t count = surface.Positions.size() / 3;
  std::string attributes;
  addAttribute(attributes, "POSITION",
    addFloats(document, count, 3, "VEC3", boundsOf(surface.Positions.size(), coordinate),
      run.part(0.0, 0.3), coordinate));
  if (!surface.Normals.empty())
  {
    addAttribute(attributes, "NORMAL",
      addFloats(document, count, 3, "VEC3", "", run.part(0.3, 0.5),
        [&](std::size_t i) { return surface.Normals[i]; }));
  }
  if (!surface.Tangents.empty())
  {
    addAttribute(attributes, "TANGENT",
      addFloats(document, count, 4, "VEC4", "", run.part(0.5, 0.6),
        [&](std::size_t i) { return i % 4 == 3 ? 1.0F : surface.Tangents[i / 4 * 3 + i % 4]; }));
  }
  addAttribute(attributes, "TEXCOORD_0",
    addFloats(document, count, 2, "VEC2", "", run.part(0.6, 0.7),
      [&](std::size_t i)
      { return i % 2 == 1 ? 1.0F - surface.TexCoords[i] : surface.TexCoords[i]; }));
  document.addMesh(attributes, addCorners(document, surface, run.part(0.7, 1.0)), count, placement);
}
}

//------------------------------------------------------------------------------
std::string makeGLB(const GLBContents& contents, const Run& run)
{
  const TexturedSurface& first = contents.Levels.at(0);
  const bool isCompressed = contents.Compression == GLBCompression::Meshopt;
  const bool isPacked = contents.Compression != GLBCompression::None;
  GLBDocument document;
  document.Name = first.Name;
  document.MetersPerUnit = first.MetersPerUnit;
  document.RepeatsTexture = first.RepeatsTexture;
  if (isPacked)
  {
    document.Extensions = "\"KHR_mesh_quantization\",\"KHR_texture_transform\"";
    document.Extensions += isCompressed ? ",\"EXT_meshopt_compression\"" : "";
  }
  for (const TexturedSurface& level : contents.Levels)
  {
    requireFloatRange(level.Positions.size(), [&](std::size_t i) { return level.Positions[i]; });
  }
  if (isPacked)
  {
    addPackedLevels(document, contents.Levels, isCompressed, run);
  }
  else
  {
    for (const TexturedSurface& level : contents.Levels)
    {
      addLevel(document, level, run);
    }
  }
  document.addPicture(contents.Picture);
  if (!contents.NormalMap.empty())
  {
    document.addNormalMap(contents.NormalMap);
  }
  run.report(1.0);
  return document.file();
}
}
