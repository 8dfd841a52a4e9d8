#include "GIFTI/GIFTIWriter.h"

#include "Bytes/FloatRange.h"
#include "Bytes/SurfaceWalk.h"
#include "Text/BinaryTextEncoder.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
const char* nameOf(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return "INT8";
    case ScalarType::UInt8:
      return "UINT8";
    case ScalarType::Int16:
      return "INT16";
    case ScalarType::UInt16:
      return "UINT16";
    case ScalarType::Int32:
      return "INT32";
    case ScalarType::UInt32:
      return "UINT32";
    case ScalarType::Int64:
      return "INT64";
    case ScalarType::UInt64:
      return "UINT64";
    case ScalarType::Float32:
      return "FLOAT32";
    case ScalarType::Float64:
      break;
  }
  return "FLOAT64";
}

// Return the number of bytes of the first character of a UTF-8 text. If the character is invalid or
// forbidden in XML, return 0.
std::size_t characterLength(std::string_view text)
{
  constexpr std::uint32_t first[] = { 0, 0x20, 0x80, 0x800,
    0x10000 }; // first character of each number of bytes
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned int lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1
    : lead < 0xC0                        ? 0
    : lead < 0xE0                        ? 2
    : lead < 0xF0                        ? 3
                                         : 4;
  if (length == 0 || lead >= 0xF8 || length > text.size())
  {
    return 0;
  }
  std::uint32_t code = length == 1 ? lead : lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(i) & 0xC0U) != 0x80U)
    {
      return 0;
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool isSurrogate = code >= 0xD800 && code < 0xE000;
  const bool isNone = code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF;
  return code < first[length] || isSurrogate || isNone ? 0 : length;
}

// Escape text for XML. Control characters and bytes that are not valid UTF-8 become "_".
std::string escaped(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t length = characterLength(std::string_view(text).substr(i));
    switch (text[i])
    {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += length > 0 ? text.substr(i, length) : "_";
    }
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

// Write metadata entries, each a name and a value. Entries without a value are omitted.
std::string metaData(const std::vector<std::pair<const char*, std::string>>& entries)
{
  std::string text;
  for (const auto& [name, value] : entries)
  {
    if (!value.empty())
    {
      text +=
        std::string("<MD><Name>") + name + "</Name><Value>" + escaped(value) + "</Value></MD>";
    }
  }
  return text.empty() ? "<MetaData/>" : "<MetaData>" + text + "</MetaData>";
}

// Array of a file, with its intent and its metadata.
struct FileArray
{
  const NamedArray& Values;
  const char* Intent;
  std::string MetaData;
};

FileArray named(const NamedArray& array, const char* intent)
{
  return { array, intent, metaData({ { "Name", array.Name } }) };
}

void appendArray(std::string& text, const FileArray& file, const Run& run)
{
  const NamedArray& array = file.Values;
  const std::string_view bytes(
    reinterpret_cast<const char*>(array.Values.data()), array.Values.size());
  text += std::string("<DataArray Intent=\"NIFTI_INTENT_") + file.Intent +
    "\" DataType=\"NIFTI_TYPE_" + nameOf(array.Type) +
    "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" +
    (array.Components > 1 ? "2" : "1") + "\" Dim0=\"" + std::to_string(array.numberOfTuples()) +
    "\"" + (array.Components > 1 ? " Dim1=\"" + std::to_string(array.Components) + "\"" : "") +
    " Encoding=\"GZipBase64Binary\" Endian=\"" +
    (isLittleEndianMachine() ? "LittleEndian" : "BigEndian") +
    "\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n" + file.MetaData + "\n<Data>" +
    encodeBinaryText(bytes, true, run) + "</Data>\n</DataArray>\n";
}

std::string makeFile(
  const std::string& fileMetaData, const std::vector<FileArray>& arrays, const Run& run)
{
  std::string text =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
    "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" +
    std::to_string(arrays.size()) + "\">\n" + fileMetaData + "\n<LabelTable/>\n";
  // Nearly all time is spent on compression. Progress is therefore divided by the sizes of the
  // arrays.
  double all = 0.0;
  for (const FileArray& array : arrays)
  {
    all += static_cast<double>(array.Values.Values.size());
  }
  all = std::max(all, 1.0);
  double done = 0.0;
  for (const FileArray& array : arrays)
  {
    const auto size = static_cast<double>(array.Values.Values.size());
    appendArray(text, array, run.part(done / all, (done + size) / all));
    done += size;
  }
  run.report(1.0);
  return text + "</GIFTI>\n";
}

NamedArray trianglesOf(const SurfaceData& surface)
{
  requireTriangles(surface);
  if (numberOfPolygons(surface) == 0)
  {
    throw std::invalid_argument("the surface has no polygons; GIFTI cannot store points alone");
  }
  NamedArray triangles = makeArray("Triangles", ScalarType::Int32, 3);
  triangles.Values.reserve(3 * numberOfPolygons(surface) * sizeof(std::int32_t));
  walk(
    surface, {}, [](std::size_t) {},
    [&](std::size_t, const std::int64_t* ids, std::size_t)
    {
      const std::int32_t triangle[] = { static_cast<std::int32_t>(ids[0]),
        static_cast<std::int32_t>(ids[1]), static_cast<std::int32_t>(ids[2]) };
      append(triangles, triangle);
    });
  return triangles;
}

// Write only the points, as floats, and the triangles.
template <typename Coordinate>
std::string makePlainSurface(const SurfaceData& surface, Coordinate coordinate, const char* type,
  const std::string& structure, const Run& run)
{
  const NamedArray triangles = trianglesOf(surface);
  const std::size_t size = 3 * surface.Points.numberOfTuples();
  requireFloatRange(size, coordinate);
  requireFinePositions(floatRoundingOf(size, coordinate));
  NamedArray points = makeArray("Points", ScalarType::Float32, 3);
  points.Values.reserve(size * sizeof(float));
  for (std::size_t i = 0; i < size; i += 3)
  {
    const float place[] = { static_cast<float>(coordinate(i)),
      static_cast<float>(coordinate(i + 1)), static_cast<float>(coordinate(i + 2)) };
    append(points, place);
  }
  return makeFile(metaData({}),
    { { points, "POINTSET",
        metaData({ { "Name", points.Name }, { "AnatomicalStructurePrimary", structure },
          { "GeometricType", type } }) },
      named(triangles, "TRIANGLE") },
    run);
}

// Return the numbers of an array as floats, the type that programs expect in a shape file.
NamedArray asFloats(const NamedArray& array)
{
  NamedArray floats = makeArray(array.Name, ScalarType::Float32, 1);
  floats.Values.reserve(array.numberOfTuples() * sizeof(float));
  for (std::size_t i = 0; i < array.numberOfTuples(); ++i)
  {
    const float number = floatOf(valueOf(array, i), array.Name);
    append(floats, &number);
  }
  return floats;
}
}

//------------------------------------------------------------------------------
std::string makeGIFTISurface(
  const SurfaceData& surface, const std::string& structure, const Run& run)
{
  const NamedArray triangles = trianglesOf(surface);
  std::vector<FileArray> arrays = {
    { surface.Points, "POINTSET",
      metaData({ { "Name", surface.Points.Name }, { "AnatomicalStructurePrimary", structure } }) },
    named(triangles, "TRIANGLE")
  };
  for (const NamedArray& array : surface.PointArrays)
  {
    const bool isShape = array.Components == 1 && isFloating(array.Type);
    arrays.push_back(named(array, isShape ? "SHAPE" : "NONE"));
  }
  return makeFile(metaData({}), arrays, run);
}

//------------------------------------------------------------------------------
std::string makeGIFTIGeometry(
  const SurfaceData& surface, const std::string& structure, const Run& run)
{
  return makePlainSurface(
    surface, [&](std::size_t i) { return valueOf(surface.Points, i); }, "Anatomical", structure,
    run);
}

//------------------------------------------------------------------------------
std::string makeGIFTISphere(
  const SurfaceData& surface, const std::string& structure, const Run& run)
{
  const CorticalSphere sphere(surface);
  return makePlainSurface(
    surface, [&](std::size_t i) { return sphere.coordinate(i); }, "Spherical", structure, run);
}

//------------------------------------------------------------------------------
std::string makeGIFTIShape(const SurfaceData& surface, const std::string& structure, const Run& run)
{
  std::vector<NamedArray> shapes;
  for (const NamedArray& array : surface.PointArrays)
  {
    if (array.Components == 1)
    {
      shapes.push_back(asFloats(array));
    }
  }
  if (shapes.empty())
  {
    throw std::invalid_argument("the surface has no point array of 1 component");
  }
  std::vector<FileArray> arrays;
  arrays.reserve(shapes.size());
  for (const NamedArray& shape : shapes)
  {
    arrays.push_back(named(shape, "SHAPE"));
  }
  return makeFile(metaData({ { "AnatomicalStructurePrimary", structure } }), arrays, run);
}
}
