#include "GIFTI/GIFTIWriter.h"

#include "Bytes/SurfaceWalk.h"
#include "GIFTI/BinaryText.h"

#include <stdexcept>
#include <string_view>

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

// Text as XML may hold it; control characters have no way into XML.
std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
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
        result += static_cast<unsigned char>(c) < ' ' ? '_' : c;
    }
  }
  return result;
}

void appendArray(
  std::string& text, const NamedArray& array, const char* intent, const ParseProgress& progress)
{
  const std::string_view bytes(
    reinterpret_cast<const char*>(array.Values.data()), array.Values.size());
  text += std::string("<DataArray Intent=\"NIFTI_INTENT_") + intent + "\" DataType=\"NIFTI_TYPE_" +
    nameOf(array.Type) + "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" +
    (array.Components > 1 ? "2" : "1") + "\" Dim0=\"" + std::to_string(array.numberOfTuples()) +
    "\"" + (array.Components > 1 ? " Dim1=\"" + std::to_string(array.Components) + "\"" : "") +
    " Encoding=\"GZipBase64Binary\" Endian=\"" +
    (isLittleEndianMachine() ? "LittleEndian" : "BigEndian") +
    "\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData><MD><Name>Name</Name><Value>" +
    escaped(array.Name) + "</Value></MD></MetaData>\n<Data>" +
    encodeBinaryText(bytes, true, progress) + "</Data>\n</DataArray>\n";
}
}

//------------------------------------------------------------------------------
std::string makeGIFTI(const SurfaceData& surface, const ParseProgress& progress)
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
  std::string text =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
    "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" +
    std::to_string(2 + surface.PointArrays.size()) + "\">\n<MetaData/>\n<LabelTable/>\n";
  // Compressing takes nearly all of the time.
  double all = static_cast<double>(surface.Points.Values.size() + triangles.Values.size());
  for (const NamedArray& array : surface.PointArrays)
  {
    all += static_cast<double>(array.Values.size());
  }
  double done = 0.0;
  const auto add = [&](const NamedArray& array, const char* intent)
  {
    const auto size = static_cast<double>(array.Values.size());
    const ParseProgress adding = [&](double part)
    { return !progress || progress((done + part * size) / all); };
    appendArray(text, array, intent, adding);
    done += size;
  };
  add(surface.Points, "POINTSET");
  add(triangles, "TRIANGLE");
  for (const NamedArray& array : surface.PointArrays)
  {
    const bool isShape = array.Components == 1 && isFloating(array.Type);
    add(array, isShape ? "SHAPE" : "NONE");
  }
  report(progress, 1.0);
  return text + "</GIFTI>\n";
}
}
