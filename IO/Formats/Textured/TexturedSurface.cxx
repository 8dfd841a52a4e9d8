#include "Textured/TexturedSurface.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FloatRange.h"
#include "Bytes/NumberText.h"
#include "Text/JSONText.h"
#include "Textured/VertexPacking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
// Constants of the glTF 2.0 specification.
constexpr int Float = 5126;
constexpr int SignedByte = 5120;
constexpr int UnsignedShort = 5123;
constexpr int UnsignedInt = 5125;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr int ClampToEdge = 33071;
constexpr int Repeat = 10497;
constexpr std::uint32_t Magic = 0x46546C67;     // "glTF"
constexpr std::uint32_t JSONChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t BINChunk = 0x004E4942;  // "BIN"

// Call body(i) for all i below `count`, and report progress from `begin` to `end`.
template <typename Body>
void forEach(std::size_t count, const Run& run, double begin, double end, Body body)
{
  constexpr std::size_t chunk = 100000;
  for (std::size_t first = 0; first < count; first += chunk)
  {
    run.report(begin + (end - begin) * static_cast<double>(first) / count);
    const std::size_t last = std::min(count, first + chunk);
    for (std::size_t i = first; i < last; ++i)
    {
      body(i);
    }
  }
}

void pad(std::string& bytes, char filler)
{
  bytes.append((4 - bytes.size() % 4) % 4, filler);
}

// Builder of the lists of a glTF document and of its binary buffer.
class GLBBuilder
{
public:
  std::string Bytes;

  // Add a buffer view of the bytes from `begin` on, and return its index.
  int addView(std::size_t begin, int target, const std::string& more = "")
  {
    this->separate(this->Views);
    this->Views += "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
      ",\"byteLength\":" + std::to_string(this->Bytes.size() - begin);
    this->Views += more + (target ? ",\"target\":" + std::to_string(target) + "}" : "}");
    pad(this->Bytes, '\0');
    return this->NumberOfViews++;
  }

  // Add a buffer view of vertices of `stride` bytes each, and return its index.
  int addVertices(const void* vertices, std::size_t count, std::size_t stride)
  {
    const std::size_t begin = this->Bytes.size();
    this->Bytes.append(static_cast<const char*>(vertices), count * stride);
    return this->addView(begin, ArrayBuffer, ",\"byteStride\":" + std::to_string(stride));
  }

  // Add a compressed buffer view, and return its index.
  int addCompressed(const std::string& bytes, std::size_t count, std::size_t stride,
    const std::string& mode, bool isIndices)
  {
    const std::size_t size = count * stride;
    const std::string strideText = ",\"byteStride\":" + std::to_string(stride);
    this->separate(this->Views);
    this->Views += "{\"buffer\":1,\"byteOffset\":" + std::to_string(this->FallbackSize) +
      ",\"byteLength\":" + std::to_string(size) + (isIndices ? "" : strideText) +
      ",\"target\":" + std::to_string(isIndices ? ElementArrayBuffer : ArrayBuffer) +
      ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" +
      std::to_string(this->Bytes.size()) + ",\"byteLength\":" + std::to_string(bytes.size()) +
      strideText + ",\"count\":" + std::to_string(count) + "," + mode + "}}}";
    this->Bytes += bytes;
    pad(this->Bytes, '\0');
    this->FallbackSize += (size + 3) / 4 * 4;
    return this->NumberOfViews++;
  }

  std::string Extensions;       // names in quotes, separated by commas
  std::string TextureTransform; // of the texture, as JSON; or empty
  std::string MimeType = "image/png";

  int addAccessor(int view, int componentType, const char* type, std::size_t count,
    const std::string& bounds = "")
  {
    this->separate(this->Accessors);
    this->Accessors += "{\"bufferView\":" + std::to_string(view) +
      ",\"componentType\":" + std::to_string(componentType) +
      ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" + bounds + "}";
    return this->NumberOfAccessors++;
  }

  std::string file(const std::string& attributes, int indices, int image,
    const TexturedSurface& surface, const std::string& placement) const
  {
    const std::string wrap = std::to_string(surface.RepeatsTexture ? Repeat : ClampToEdge);
    const std::string name = surface.Name.empty() ? "" : "\"name\":" + jsonText(surface.Name) + ",";
    std::string unit;
    appendNumber(unit, surface.MetersPerUnit);
    const std::string extensions = this->Extensions.empty() ? ""
                                                            : "\"extensionsUsed\":[" +
        this->Extensions + "],\"extensionsRequired\":[" + this->Extensions + "],";
    const std::string fallback = this->FallbackSize == 0
      ? ""
      : ",{\"byteLength\":" + std::to_string(this->FallbackSize) +
        ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
    std::string json = "{" + extensions +
      "\"asset\":{\"version\":\"2.0\",\"generator\":\"ConformalSOM\","
      "\"extras\":{\"metersPerUnit\":" +
      unit +
      "}},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
      "\"nodes\":[{" +
      name + "\"mesh\":0" + placement + "}],\"meshes\":[{" + name +
      "\"primitives\":[{\"attributes\":{" + attributes +
      "},\"indices\":" + std::to_string(indices) +
      ",\"material\":0}]}],"
      "\"materials\":[{" +
      name + "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0" +
      this->TextureTransform +
      "},"
      "\"metallicFactor\":0},\"doubleSided\":true}],"
      "\"textures\":[{\"sampler\":0,\"source\":0}],"
      "\"samplers\":[{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":" +
      wrap + ",\"wrapT\":" + wrap + "}],\"images\":[{\"bufferView\":" + std::to_string(image) +
      ",\"mimeType\":\"" + this->MimeType + "\"}],\"accessors\":[" + this->Accessors +
      "],\"bufferViews\":[" + this->Views +
      "],\"buffers\":[{\"byteLength\":" + std::to_string(this->Bytes.size()) + "}" + fallback +
      "]}";
    pad(json, ' ');
    const std::uint64_t size = 12 + 8 + json.size() + 8 + this->Bytes.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
    {
      throw std::length_error("a GLB file holds at most 4 GiB");
    }
    std::string result;
    result.reserve(size);
    appendBytes(result, Magic, false);
    appendBytes(result, std::uint32_t(2), false);
    appendBytes(result, static_cast<std::uint32_t>(size), false);
    appendBytes(result, static_cast<std::uint32_t>(json.size()), false);
    appendBytes(result, JSONChunk, false);
    result += json;
    appendBytes(result, static_cast<std::uint32_t>(this->Bytes.size()), false);
    appendBytes(result, BINChunk, false);
    result += this->Bytes;
    return result;
  }

private:
  static void separate(std::string& list) { list += list.empty() ? "" : ","; }

  std::string Views;
  std::string Accessors;
  std::size_t FallbackSize = 0; // of the second buffer, which has no bytes
  int NumberOfViews = 0;
  int NumberOfAccessors = 0;
};

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
    using Limits = std::numeric_limits<float>;
    if (!(std::abs(meters) <= Limits::max() && step <= Limits::max() && step >= Limits::min()))
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

std::string mimeTypeOf(std::string_view picture)
{
  return picture.substr(0, 2) == "\xff\xd8" ? "image/jpeg" : "image/png";
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

std::string makePackedGLB(
  const TexturedSurface& original, std::string_view picture, bool isCompressed, const Run& run)
{
  static_assert(sizeof(std::uint16_t) == 2);
  const TexturedSurface surface = isCompressed ? sortedForCompression(original) : original;
  const std::size_t count = surface.Positions.size() / 3;
  run.report(0.3);
  GLBBuilder builder;
  builder.Extensions = isCompressed
    ? "\"KHR_mesh_quantization\",\"KHR_texture_transform\",\"EXT_meshopt_compression\""
    : "\"KHR_mesh_quantization\",\"KHR_texture_transform\"";
  builder.MimeType = mimeTypeOf(picture);
  const PackedPositions positions = packPositions(surface.Positions, isCompressed ? 14 : 16);
  const std::string placement = placementOf(positions, surface.MetersPerUnit);
  const auto add = [&](const void* values, std::size_t stride)
  {
    return isCompressed ? builder.addCompressed(compressVertices(values, count, stride), count,
                            stride, "\"mode\":\"ATTRIBUTES\"", false)
                        : builder.addVertices(values, count, stride);
  };
  std::string attributes = "\"POSITION\":" +
    std::to_string(builder.addAccessor(
      add(positions.Values.data(), 8), UnsignedShort, "VEC3", count, boundsOf(positions.Values)));
  run.report(0.5);
  if (!surface.Normals.empty())
  {
    const int view = isCompressed
      ? builder.addCompressed(compressNormals(surface.Normals), count, 4,
          "\"mode\":\"ATTRIBUTES\",\"filter\":\"OCTAHEDRAL\"", false)
      : builder.addVertices(packNormals(surface.Normals).data(), count, 4);
    attributes += ",\"NORMAL\":" +
      std::to_string(builder.addAccessor(view, SignedByte, "VEC3", count, ",\"normalized\":true"));
  }
  const PackedTexCoords texCoords = packTexCoords(surface.TexCoords, isCompressed ? 13 : 16);
  builder.TextureTransform = transformOf(texCoords);
  attributes += ",\"TEXCOORD_0\":" +
    std::to_string(
      builder.addAccessor(add(texCoords.Values.data(), 4), UnsignedShort, "VEC2", count));
  run.report(0.7);
  int cornersView = 0;
  if (isCompressed)
  {
    cornersView = builder.addCompressed(compressCorners(surface.Corners, count),
      surface.Corners.size(), 4, "\"mode\":\"TRIANGLES\"", true);
  }
  else
  {
    const std::size_t begin = builder.Bytes.size();
    forEach(surface.Corners.size(), run, 0.7, 0.9,
      [&](std::size_t i) { appendBytes(builder.Bytes, surface.Corners[i], false); });
    cornersView = builder.addView(begin, ElementArrayBuffer);
  }
  const int corners =
    builder.addAccessor(cornersView, UnsignedInt, "SCALAR", surface.Corners.size());
  const std::size_t imageBegin = builder.Bytes.size();
  builder.Bytes += picture;
  const int image = builder.addView(imageBegin, 0);
  run.report(1.0);
  return builder.file(attributes, corners, image, surface, placement);
}

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
std::string makeGLB(const TexturedSurface& surface, std::string_view picture, const Run& run,
  GLBCompression compression)
{
  requireFloatRange(surface.Positions.size(), [&](std::size_t i) { return surface.Positions[i]; });
  if (compression != GLBCompression::None)
  {
    return makePackedGLB(surface, picture, compression == GLBCompression::Meshopt, run);
  }
  const std::array<double, 3> origin = originOf(surface.Positions);
  const std::string placement = placementOf(origin, surface.MetersPerUnit);
  const auto coordinate = [&](std::size_t i) { return surface.Positions[i] - origin[i % 3]; };
  requireFloatRange(surface.Positions.size(), coordinate);
  const std::size_t count = surface.Positions.size() / 3;
  const bool hasNormals = !surface.Normals.empty();
  GLBBuilder builder;
  builder.MimeType = mimeTypeOf(picture);
  std::string& bytes = builder.Bytes;
  bytes.reserve(count * (hasNormals ? 32 : 20) + surface.Corners.size() * 4 + picture.size() + 3);
  const auto appendFloats = [&](const std::vector<float>& values, double begin, double end)
  {
    forEach(
      values.size(), run, begin, end, [&](std::size_t i) { appendBytes(bytes, values[i], false); });
  };

  forEach(surface.Positions.size(), run, 0.0, 0.3,
    [&](std::size_t i) { appendBytes(bytes, static_cast<float>(coordinate(i)), false); });
  const int positions = builder.addAccessor(builder.addView(0, ArrayBuffer), Float, "VEC3", count,
    boundsOf(surface.Positions.size(), coordinate));
  std::string attributes = "\"POSITION\":" + std::to_string(positions);
  if (hasNormals)
  {
    const std::size_t begin = bytes.size();
    appendFloats(surface.Normals, 0.3, 0.5);
    const int normals =
      builder.addAccessor(builder.addView(begin, ArrayBuffer), Float, "VEC3", count);
    attributes += ",\"NORMAL\":" + std::to_string(normals);
  }
  const std::size_t texCoordsBegin = bytes.size();
  forEach(surface.TexCoords.size(), run, 0.5, 0.7,
    [&](std::size_t i)
    {
      const float value = surface.TexCoords[i];
      appendBytes(bytes, i % 2 == 1 ? 1.0F - value : value, false);
    });
  const int texCoords =
    builder.addAccessor(builder.addView(texCoordsBegin, ArrayBuffer), Float, "VEC2", count);
  attributes += ",\"TEXCOORD_0\":" + std::to_string(texCoords);

  const std::size_t cornersBegin = bytes.size();
  forEach(surface.Corners.size(), run, 0.7, 0.9,
    [&](std::size_t i) { appendBytes(bytes, surface.Corners[i], false); });
  const int corners = builder.addAccessor(builder.addView(cornersBegin, ElementArrayBuffer),
    UnsignedInt, "SCALAR", surface.Corners.size());

  const std::size_t imageBegin = bytes.size();
  bytes += picture;
  const int image = builder.addView(imageBegin, 0);
  run.report(1.0);
  return builder.file(attributes, corners, image, surface, placement);
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
