#include "Textured/VertexPacking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#ifdef CONFORMALSOM_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace conformal
{
namespace
{
// Lowest and highest value of each column.
template <std::size_t Columns, typename Number>
std::array<std::array<double, Columns>, 2> rangesOf(const std::vector<Number>& values)
{
  std::array<std::array<double, Columns>, 2> ranges;
  ranges[0].fill(std::numeric_limits<double>::infinity());
  ranges[1].fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto value = static_cast<double>(values[i]);
    ranges[0][i % Columns] = std::min(ranges[0][i % Columns], value);
    ranges[1][i % Columns] = std::max(ranges[1][i % Columns], value);
  }
  return ranges;
}

std::uint16_t packed(double value, double low, double step, int bits)
{
  const double highest = (1 << bits) - 1;
  return static_cast<std::uint16_t>(
    step > 0.0 ? std::clamp(std::round((value - low) / step), 0.0, highest) : 0.0);
}
}

//------------------------------------------------------------------------------
PackedPositions packPositions(const std::vector<double>& positions, int bits)
{
  const auto [low, high] = rangesOf<3>(positions);
  PackedPositions result;
  result.Offset = low;
  double size = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    size = std::max(size, high[c] - low[c]);
  }
  result.Scale = size > 0.0 ? size / ((1 << bits) - 1) : 1.0;
  result.Values.assign(positions.size() / 3 * 4, 0);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    result.Values[i / 3 * 4 + i % 3] = packed(positions[i], low[i % 3], result.Scale, bits);
  }
  return result;
}

//------------------------------------------------------------------------------
PackedTexCoords packTexCoords(const std::vector<float>& texCoords, int bits)
{
  std::vector<double> fromTop(texCoords.begin(), texCoords.end());
  for (std::size_t i = 1; i < fromTop.size(); i += 2)
  {
    fromTop[i] = 1.0 - fromTop[i];
  }
  const auto [low, high] = rangesOf<2>(fromTop);
  PackedTexCoords result;
  result.Offset = low;
  for (int c = 0; c < 2; ++c)
  {
    result.Scale[c] = high[c] > low[c] ? (high[c] - low[c]) / ((1 << bits) - 1) : 1.0;
  }
  result.Values.resize(fromTop.size());
  for (std::size_t i = 0; i < fromTop.size(); ++i)
  {
    result.Values[i] = packed(fromTop[i], low[i % 2], result.Scale[i % 2], bits);
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::int8_t> packDirections(const std::vector<float>& vectors, float fourth)
{
  const auto rounded = [](float value)
  { return static_cast<std::int8_t>(std::clamp(std::round(127.0F * value), -127.0F, 127.0F)); };
  std::vector<std::int8_t> result(vectors.size() / 3 * 4, rounded(fourth));
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    result[i / 3 * 4 + i % 3] = rounded(vectors[i]);
  }
  return result;
}

#ifdef CONFORMALSOM_HAS_MESHOPT
//------------------------------------------------------------------------------
bool hasMeshopt()
{
  return true;
}

//------------------------------------------------------------------------------
TexturedSurface sortedForCompression(const TexturedSurface& surface)
{
  const std::size_t count = surface.Positions.size() / 3;
  TexturedSurface sorted = surface;
  meshopt_optimizeVertexCache(
    sorted.Corners.data(), surface.Corners.data(), surface.Corners.size(), count);
  std::vector<std::uint32_t> places(count);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(
    places.data(), sorted.Corners.data(), sorted.Corners.size(), count);
  meshopt_remapIndexBuffer(
    sorted.Corners.data(), sorted.Corners.data(), sorted.Corners.size(), places.data());
  const auto remap = [&](auto& values, std::size_t width)
  {
    const auto old = values;
    meshopt_remapVertexBuffer(
      values.data(), old.data(), count, width * sizeof(old.front()), places.data());
    values.resize(used * width);
  };
  remap(sorted.Positions, 3);
  remap(sorted.TexCoords, 2);
  if (!sorted.Normals.empty())
  {
    remap(sorted.Normals, 3);
  }
  if (!sorted.Tangents.empty())
  {
    remap(sorted.Tangents, 3);
  }
  return sorted;
}

//------------------------------------------------------------------------------
std::string compressVertices(const void* vertices, std::size_t count, std::size_t stride)
{
  meshopt_encodeVertexVersion(0); // the only version of the extension
  std::string bytes(meshopt_encodeVertexBufferBound(count, stride), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(
    reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), vertices, count, stride));
  return bytes;
}

//------------------------------------------------------------------------------
std::string compressDirections(const std::vector<float>& vectors, float fourth)
{
  const std::size_t count = vectors.size() / 3;
  std::vector<float> four(4 * count, fourth);
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    four[i / 3 * 4 + i % 3] = vectors[i];
  }
  std::vector<std::int8_t> octahedral(4 * count);
  meshopt_encodeFilterOct(octahedral.data(), count, 4, 8, four.data());
  return compressVertices(octahedral.data(), count, 4);
}

//------------------------------------------------------------------------------
std::string compressCorners(const std::vector<std::uint32_t>& corners, std::size_t points)
{
  meshopt_encodeIndexVersion(1); // the only version of the extension
  std::string bytes(meshopt_encodeIndexBufferBound(corners.size(), points), '\0');
  bytes.resize(meshopt_encodeIndexBuffer(
    reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), corners.data(), corners.size()));
  return bytes;
}
#else
namespace
{
[[noreturn]] void throwWithoutMeshopt()
{
  throw std::runtime_error("this build cannot compress by EXT_meshopt_compression, because it has "
                           "not found the library meshoptimizer");
}
}

//------------------------------------------------------------------------------
bool hasMeshopt()
{
  return false;
}

//------------------------------------------------------------------------------
TexturedSurface sortedForCompression(const TexturedSurface&)
{
  throwWithoutMeshopt();
}

//------------------------------------------------------------------------------
std::string compressVertices(const void*, std::size_t, std::size_t)
{
  throwWithoutMeshopt();
}

//------------------------------------------------------------------------------
std::string compressDirections(const std::vector<float>&, float)
{
  throwWithoutMeshopt();
}

//------------------------------------------------------------------------------
std::string compressCorners(const std::vector<std::uint32_t>&, std::size_t)
{
  throwWithoutMeshopt();
}
#endif
}
