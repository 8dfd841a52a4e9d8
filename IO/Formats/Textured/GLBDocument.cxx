#include "Textured/GLBDocument.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/NumberText.h"
#include "Text/JSONText.h"

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr std::uint32_t Magic = 0x46546C67;     // "glTF"
constexpr std::uint32_t JSONChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t BINChunk = 0x004E4942;  // "BIN"

void pad(std::string& bytes, char filler)
{
  bytes.append((4 - bytes.size() % 4) % 4, filler);
}

void separate(std::string& list)
{
  list += list.empty() ? "" : ",";
}

std::string numberText(double value)
{
  std::string text;
  appendNumber(text, value);
  return text;
}

std::string mimeTypeOf(const std::string& picture)
{
  return picture.compare(0, 2, "\xff\xd8") == 0 ? "image/jpeg" : "image/png";
}
}

//------------------------------------------------------------------------------
int GLBDocument::addView(std::size_t begin, int target, const std::string& more)
{
  separate(this->Views);
  this->Views += "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
    ",\"byteLength\":" + std::to_string(this->Bytes.size() - begin);
  this->Views += more + (target ? ",\"target\":" + std::to_string(target) + "}" : "}");
  pad(this->Bytes, '\0');
  return this->NumberOfViews++;
}

//------------------------------------------------------------------------------
int GLBDocument::addVertices(const void* vertices, std::size_t count, std::size_t stride)
{
  const std::size_t begin = this->Bytes.size();
  this->Bytes.append(static_cast<const char*>(vertices), count * stride);
  return this->addView(begin, gltf::ArrayBuffer, ",\"byteStride\":" + std::to_string(stride));
}

//------------------------------------------------------------------------------
int GLBDocument::addCompressed(const std::string& bytes, std::size_t count, std::size_t stride,
  const std::string& mode, bool isIndices)
{
  const std::size_t size = count * stride;
  const std::string strideText = ",\"byteStride\":" + std::to_string(stride);
  separate(this->Views);
  this->Views += "{\"buffer\":1,\"byteOffset\":" + std::to_string(this->FallbackSize) +
    ",\"byteLength\":" + std::to_string(size) + (isIndices ? "" : strideText) +
    ",\"target\":" + std::to_string(isIndices ? gltf::ElementArrayBuffer : gltf::ArrayBuffer) +
    ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":" +
    std::to_string(this->Bytes.size()) + ",\"byteLength\":" + std::to_string(bytes.size()) +
    strideText + ",\"count\":" + std::to_string(count) + "," + mode + "}}}";
  this->Bytes += bytes;
  pad(this->Bytes, '\0');
  this->FallbackSize += (size + 3) / 4 * 4;
  return this->NumberOfViews++;
}

//------------------------------------------------------------------------------
int GLBDocument::addAccessor(
  int view, int componentType, const char* type, std::size_t count, const std::string& more)
{
  separate(this->Accessors);
  this->Accessors += "{\"bufferView\":" + std::to_string(view) +
    ",\"componentType\":" + std::to_string(componentType) + ",\"count\":" + std::to_string(count) +
    ",\"type\":\"" + type + "\"" + more + "}";
  return this->NumberOfAccessors++;
}

//------------------------------------------------------------------------------
void GLBDocument::addMesh(
  const std::string& attributes, int corners, std::size_t points, const std::string& placement)
{
  separate(this->Meshes);
  const std::string name = this->Name.empty() ? "" : "\"name\":" + jsonText(this->Name) + ",";
  this->Meshes += "{" + name + "\"primitives\":[{\"attributes\":{" + attributes +
    "},\"indices\":" + std::to_string(corners) + ",\"material\":0}]}";
  this->Placements.push_back(placement);
  this->NumbersOfPoints.push_back(points);
}

//------------------------------------------------------------------------------
void GLBDocument::addPicture(const std::string& picture)
{
  this->Picture = this->addTexture(picture);
}

//------------------------------------------------------------------------------
void GLBDocument::addNormalMap(const std::string& picture)
{
  this->NormalMap = this->addTexture(picture);
}

//------------------------------------------------------------------------------
int GLBDocument::addTexture(const std::string& picture)
{
  const std::size_t begin = this->Bytes.size();
  this->Bytes += picture;
  const int view = this->addView(begin, 0);
  separate(this->Images);
  separate(this->Textures);
  this->Images +=
    "{\"bufferView\":" + std::to_string(view) + ",\"mimeType\":\"" + mimeTypeOf(picture) + "\"}";
  this->Textures += "{\"sampler\":0,\"source\":" + std::to_string(this->NumberOfTextures) + "}";
  return this->NumberOfTextures++;
}

//------------------------------------------------------------------------------
std::string GLBDocument::nodes() const
{
  const std::string name = this->Name.empty() ? "" : "\"name\":" + jsonText(this->Name) + ",";
  std::string ids, coverages, list;
  for (std::size_t i = 1; i < this->Placements.size(); ++i)
  {
    separate(ids);
    ids += std::to_string(i);
    // The share of the screen below which the next level is drawn. It keeps the number of points
    // for each pixel below that of the first level on the whole screen.
    coverages += numberText(static_cast<double>(this->NumbersOfPoints[i]) /
                   static_cast<double>(this->NumbersOfPoints[0])) +
      ",";
  }
  for (std::size_t i = 0; i < this->Placements.size(); ++i)
  {
    separate(list);
    list += "{" + name + "\"mesh\":" + std::to_string(i) + this->Placements[i];
    list += i > 0 || ids.empty() ? "}"
                                 : ",\"extensions\":{\"MSFT_lod\":{\"ids\":[" + ids +
        "]}},\"extras\":{\"MSFT_screencoverage\":[" + coverages + "0]}}";
  }
  return list;
}

//------------------------------------------------------------------------------
std::string GLBDocument::material() const
{
  const std::string name = this->Name.empty() ? "" : "\"name\":" + jsonText(this->Name) + ",";
  const auto texture = [this](int index)
  { return "{\"index\":" + std::to_string(index) + this->TextureTransform + "}"; };
  return "{" + name + "\"pbrMetallicRoughness\":{\"baseColorTexture\":" + texture(this->Picture) +
    ",\"metallicFactor\":0}," +
    (this->NormalMap < 0 ? "" : "\"normalTexture\":" + texture(this->NormalMap) + ",") +
    "\"doubleSided\":true}";
}

//------------------------------------------------------------------------------
std::string GLBDocument::json() const
{
  const bool hasLevels = this->Placements.size() > 1;
  std::string used = this->Extensions;
  if (hasLevels)
  {
    separate(used);
    used += "\"MSFT_lod\"";
  }
  const std::string extensions = (used.empty() ? "" : "\"extensionsUsed\":[" + used + "],") +
    (this->Extensions.empty() ? "" : "\"extensionsRequired\":[" + this->Extensions + "],");
  const std::string wrap = std::to_string(this->RepeatsTexture ? gltf::Repeat : gltf::ClampToEdge);
  const std::string fallback = this->FallbackSize == 0
    ? ""
    : ",{\"byteLength\":" + std::to_string(this->FallbackSize) +
      ",\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
  std::string text = "{" + extensions +
    "\"asset\":{\"version\":\"2.0\",\"generator\":\"ConformalSOM\","
    "\"extras\":{\"metersPerUnit\":" +
    numberText(this->MetersPerUnit) + "}},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" +
    this->nodes() + "],\"meshes\":[" + this->Meshes + "],\"materials\":[" + this->material() +
    "],\"textures\":[" + this->Textures +
    "],\"samplers\":[{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":" + wrap +
    ",\"wrapT\":" + wrap + "}],\"images\":[" + this->Images + "],\"accessors\":[" +
    this->Accessors + "],\"bufferViews\":[" + this->Views +
    "],\"buffers\":[{\"byteLength\":" + std::to_string(this->Bytes.size()) + "}" + fallback + "]}";
  pad(text, ' ');
  return text;
}

//------------------------------------------------------------------------------
std::string GLBDocument::file() const
{
  const std::string text = this->json();
  const std::uint64_t size = 12 + 8 + text.size() + 8 + this->Bytes.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::length_error("a GLB file holds at most 4 GiB");
  }
  std::string result;
  result.reserve(size);
  appendBytes(result, Magic, false);
  appendBytes(result, std::uint32_t(2), false);
  appendBytes(result, static_cast<std::uint32_t>(size), false);
  appendBytes(result, static_cast<std::uint32_t>(text.size()), false);
  appendBytes(result, JSONChunk, false);
  result += text;
  appendBytes(result, static_cast<std::uint32_t>(this->Bytes.size()), false);
  appendBytes(result, BINChunk, false);
  result += this->Bytes;
  return result;
}
}
