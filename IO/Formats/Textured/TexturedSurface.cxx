#include "Textured/TexturedSurface.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FloatRange.h"
#include "Bytes/NumberText.h"
#include "Textured/ForEach.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
// Round coordinates to the digits that floats need, unless floats are too coarse.
std::vector<float> floatsOf(const std::vector<double>& positions)
{
  const FloatRounding rounding =
    floatRoundingOf(positions.size(), [&](std::size_t i) { return positions[i]; });
  if (rounding.isTooCoarse())
  {
    return {};
  }
  return { positions.begin(), positions.end() };
}

template <typename T>
void appendLine(std::string& text, const char* keyword, const T* values, std::size_t count)
{
  text += keyword;
  for (std::size_t c = 0; c < count; ++c)
  {
    text += ' ';
    appendNumber(text, values[c]);
  }
  text += '\n';
}
}

//------------------------------------------------------------------------------
std::string makeOBJ(const TexturedSurface& surface, const std::string& materialFile, const Run& run)
{
  const std::size_t count = surface.Positions.size() / 3;
  const bool hasNormals = !surface.Normals.empty();
  std::string text = "mtllib " + materialFile + "\nusemtl surface\n";
  const std::vector<float> floats = floatsOf(surface.Positions);
  forEach(count, run, 0.0, 0.3,
    [&](std::size_t i)
    {
      if (floats.empty())
      {
        appendLine(text, "v", &surface.Positions[3 * i], 3);
      }
      else
      {
        appendLine(text, "v", &floats[3 * i], 3);
      }
    });
  forEach(count, run, 0.3, 0.5,
    [&](std::size_t i) { appendLine(text, "vt", &surface.TexCoords[2 * i], 2); });
  if (hasNormals)
  {
    forEach(count, run, 0.5, 0.7,
      [&](std::size_t i) { appendLine(text, "vn", &surface.Normals[3 * i], 3); });
  }
  forEach(surface.Corners.size(), run, 0.7, 1.0,
    [&](std::size_t i)
    {
      const std::string id = std::to_string(surface.Corners[i] + std::uint64_t(1));
      text += i % 3 == 0 ? "f " : " ";
      text += id + "/" + id + (hasNormals ? "/" + id : "") + (i % 3 == 2 ? "\n" : "");
    });
  return text;
}

//------------------------------------------------------------------------------
std::string makeMTL(const std::string& textureFile)
{
  return "newmtl surface\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + textureFile + "\n";
}

//------------------------------------------------------------------------------
std::string makePLY(const TexturedSurface& surface, const std::string& textureFile, const Run& run)
{
  const std::size_t count = surface.Positions.size() / 3;
  const std::size_t triangles = surface.Corners.size() / 3;
  if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw std::length_error("a PLY file of 32-bit ids holds at most 2^31 points");
  }
  const bool hasNormals = !surface.Normals.empty();
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment TextureFile " + textureFile +
    "\nelement vertex " + std::to_string(count) +
    "\nproperty double x\nproperty double y\nproperty double z\n" +
    (hasNormals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") +
    "property float texture_u\nproperty float texture_v\nelement face " +
    std::to_string(triangles) + "\nproperty list uchar int vertex_indices\nend_header\n";
  bytes.reserve(bytes.size() + count * (hasNormals ? 44 : 32) + triangles * 13);
  forEach(count, run, 0.0, 0.6,
    [&](std::size_t i)
    {
      std::for_each_n(
        &surface.Positions[3 * i], 3, [&](double v) { appendBytes(bytes, v, false); });
      std::for_each_n(surface.Normals.data() + (hasNormals ? 3 * i : 0), hasNormals ? 3 : 0,
        [&](float v) { appendBytes(bytes, v, false); });
      std::for_each_n(&surface.TexCoords[2 * i], 2, [&](float v) { appendBytes(bytes, v, false); });
    });
  forEach(triangles, run, 0.6, 1.0,
    [&](std::size_t i)
    {
      bytes += static_cast<char>(3);
      std::for_each_n(
        &surface.Corners[3 * i], 3, [&](std::uint32_t id) { appendBytes(bytes, id, false); });
    });
  return bytes;
}
}
