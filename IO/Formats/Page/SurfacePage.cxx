#include "Page/SurfacePage.h"

#include "Bytes/SurfaceWalk.h"
#include "Page/PageNumbers.h"
#include "Page/PageTemplate.h"
#include "Text/BinaryTextEncoder.h"
#include "Text/JSONText.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
using Codes = std::vector<std::uint32_t>;

template <std::size_t Size>
std::string jsonNumbers(const std::array<double, Size>& values)
{
  std::string text = "[";
  for (const double value : values)
  {
    text += text.size() > 1 ? "," : "";
    appendNumber(text, value);
  }
  return text + "]";
}

std::string jsonRange(const PageRange& range)
{
  return jsonNumbers(std::array<double, 2>{ range.Low, range.High });
}

// Return one component of an array, in the given order of the points.
std::vector<double> component(
  const NamedArray& array, std::size_t which, const std::vector<std::size_t>& order)
{
  std::vector<double> values;
  values.reserve(order.size());
  for (const std::size_t point : order)
  {
    values.push_back(valueOf(array, point * array.Components + which));
  }
  return values;
}

// Compute the lengths of the tuples of an array, in the given order of the points.
std::vector<double> lengths(const NamedArray& array, const std::vector<std::size_t>& order)
{
  std::vector<double> values(order.size(), 0.0);
  for (std::size_t c = 0; c < array.Components; ++c)
  {
    const std::vector<double> more = component(array, c, order);
    std::transform(values.begin(), values.end(), more.begin(), values.begin(),
      [](double a, double b) { return std::isnan(b) ? b : std::hypot(a, b); });
  }
  return values;
}

// Return the values of an array that the page shows by the colors of a palette.
std::vector<double> shownValues(const NamedArray& array, const std::vector<std::size_t>& order)
{
  return array.Components == 1 ? component(array, 0, order) : lengths(array, order);
}

// Compute the range of shown values. Values that differ only by rounding count as constant, so that
// noise is not amplified.
PageRange shownRange(const NamedArray& array, const std::vector<double>& values)
{
  PageRange range = rangeOf(values);
  const double rounding = array.Type == ScalarType::Float32 ? 1e-6 : 1e-12;
  if (isFloating(array.Type) &&
    range.High / 2.0 - range.Low / 2.0 <=
      rounding * std::max(std::abs(range.Low), std::abs(range.High)))
  {
    range.Low = range.High;
  }
  return range;
}

bool isConstant(const NamedArray& array)
{
  std::vector<std::size_t> all(array.numberOfTuples());
  std::iota(all.begin(), all.end(), std::size_t(0));
  const PageRange range = shownRange(array, shownValues(array, all));
  return range.Low == range.High;
}

// Builder of the binary data of a page and of their description in JSON.
class PageBuilder
{
public:
  std::string Bytes;
  std::string Description;

  PageBuilder(const SurfaceData& surface, const NamedArray& sphere)
    : Surface(surface)
  {
    const std::size_t count = surface.Points.numberOfTuples();
    std::vector<std::pair<std::uint32_t, std::size_t>> places;
    places.reserve(count);
    this->SphereCodes.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->SphereCodes.push_back(octahedralCode(
        valueOf(sphere, 3 * i), valueOf(sphere, 3 * i + 1), valueOf(sphere, 3 * i + 2)));
      places.emplace_back(mortonCode(this->SphereCodes.back()), i);
    }
    std::sort(places.begin(), places.end());
    this->Order.reserve(count);
    for (const auto& place : places)
    {
      this->Order.push_back(place.second);
    }
    this->Description = "{\"points\":" + std::to_string(count) +
      ",\"triangles\":" + std::to_string(numberOfPolygons(surface));
  }

  void add(const char* name, const std::string& json)
  {
    this->Description += std::string(",\"") + name + "\":" + json;
  }

  // Append the codes of each component of an array, and describe the ranges of the components.
  void addPlaces(const char* name, const NamedArray& array, const char* what)
  {
    std::string ranges;
    for (std::size_t c = 0; c < array.Components; ++c)
    {
      const std::vector<double> values = component(array, c, this->Order);
      if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
      {
        throw std::invalid_argument(std::string("a ") + what + " is not finite");
      }
      const PageRange range = rangeOf(values);
      ranges += (c > 0 ? "," : "[") + jsonRange(range);
      Codes codes(values.size());
      std::transform(values.begin(), values.end(), codes.begin(),
        [&](double value) { return codeOf(value, range, PositionSteps); });
      appendCodes(this->Bytes, codes, 2);
    }
    this->add(name, ranges + "]");
  }

  void addSphere()
  {
    for (const std::size_t c : { 0, 1 })
    {
      Codes codes;
      codes.reserve(this->Order.size());
      for (const std::size_t point : this->Order)
      {
        codes.push_back(this->SphereCodes[point][c]);
      }
      appendCodes(this->Bytes, codes, 2);
    }
  }

  // Append the triangles. The corners of each triangle are rotated so that the smallest is first.
  // The triangles are then sorted by their corners.
  void addTriangles()
  {
    Codes places(this->Order.size());
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      places[this->Order[i]] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::array<std::uint32_t, 3>> triangles(numberOfPolygons(this->Surface));
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      std::array<std::uint32_t, 3>& corners = triangles[i];
      for (std::size_t c = 0; c < 3; ++c)
      {
        corners[c] = places[this->Surface.PolygonIds[3 * i + c]];
      }
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    }
    std::sort(triangles.begin(), triangles.end());
    Codes codes;
    codes.reserve(3 * triangles.size());
    for (const std::array<std::uint32_t, 3>& corners : triangles)
    {
      codes.insert(codes.end(), corners.begin(), corners.end());
    }
    appendCodes(this->Bytes, codes, 4);
  }

  // Append an array, and return its description.
  std::string addArray(const NamedArray& array)
  {
    const std::string head = "{\"name\":" + jsonText(array.Name);
    const bool isColor = isByte(array.Type) && (array.Components == 3 || array.Components == 4);
    if (isColor)
    {
      for (const std::size_t c : { 0, 1, 2 })
      {
        const std::vector<double> values = component(array, c, this->Order);
        appendCodes(this->Bytes, Codes(values.begin(), values.end()), 1);
      }
      return head + ",\"kind\":\"colors\"}";
    }
    const std::vector<double> values = shownValues(array, this->Order);
    const PageRange range = shownRange(array, values);
    constexpr double exact = 9007199254740992.0; // maximum exact integer of doubles
    const double length = range.High - range.Low;
    const bool isWhole = array.Components == 1 && !isFloating(array.Type) && -exact <= range.Low &&
      range.High <= exact && length < std::numeric_limits<std::uint32_t>::max();
    const std::uint32_t steps = isWhole ? static_cast<std::uint32_t>(length) : PositionSteps - 1;
    const std::size_t width = steps < 255 ? 1 : steps < 65535 ? 2 : 4;
    std::size_t missing = 0;
    Codes codes;
    codes.reserve(values.size());
    for (const double value : values)
    {
      const bool isMissing = !std::isfinite(value);
      missing += isMissing ? 1 : 0;
      codes.push_back(isMissing ? steps + 1 : codeOf(value, range, steps));
    }
    appendCodes(this->Bytes, codes, width);
    return head + ",\"kind\":\"numbers\",\"components\":" + std::to_string(array.Components) +
      ",\"range\":" + jsonRange(range) + ",\"steps\":" + std::to_string(steps) +
      ",\"width\":" + std::to_string(width) + ",\"whole\":" + (isWhole ? "true" : "false") +
      ",\"missing\":" + std::to_string(missing) + "}";
  }

private:
  const SurfaceData& Surface;
  std::vector<std::array<std::uint32_t, 2>> SphereCodes; // codes of the points of the surface
  std::vector<std::size_t> Order; // point of the surface for each point of the page
};

// Return the place of an array in the list of a page: colors, numbers, vectors, integers, ids.
int placeInList(const NamedArray& array)
{
  const std::string& name = array.Name;
  const auto endsWith = [&](const std::string& end)
  {
    return name.size() >= end.size() &&
      name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  const bool isScalar = array.Components == 1;
  if (isByte(array.Type) && !isScalar)
  {
    return 0;
  }
  if (isFloating(array.Type))
  {
    return isScalar ? 1 : 2;
  }
  return isScalar && !endsWith("Id") && !endsWith("Ids") ? 3 : 4;
}

// Return the arrays that the page can show as color. People need ids least; these are last.
std::vector<const NamedArray*> shownArrays(const SurfaceData& surface)
{
  const char* const others[] = { "SpherePosition", "Normals", "TCoords", "vtkGhostType" };
  std::vector<const NamedArray*> arrays;
  for (const NamedArray& array : surface.PointArrays)
  {
    const bool isOther = std::any_of(
      std::begin(others), std::end(others), [&](const char* name) { return array.Name == name; });
    if (!isOther && array.Components > 0)
    {
      arrays.push_back(&array);
    }
  }
  std::stable_sort(arrays.begin(), arrays.end(),
    [](const NamedArray* a, const NamedArray* b) { return placeInList(*a) < placeInList(*b); });
  return arrays;
}

// Find the index of the array that is shown first. The index is -1 if the picture is shown, or if
// there is nothing to show.
int firstShown(
  const std::vector<const NamedArray*>& arrays, const std::string& wanted, bool hasPicture)
{
  const auto find = [&](const std::string& name)
  {
    const auto found = std::find_if(
      arrays.begin(), arrays.end(), [&](const NamedArray* array) { return array->Name == name; });
    return found == arrays.end() ? -1 : static_cast<int>(found - arrays.begin());
  };
  if (!wanted.empty())
  {
    const int index = find(wanted);
    if (index < 0)
    {
      throw std::invalid_argument(
        "the surface has no point array " + quoted(wanted) + " that can be shown");
    }
    return index;
  }
  if (hasPicture)
  {
    return -1;
  }
  const int colors = std::max(find("RGB"), find("RGBA"));
  if (colors >= 0)
  {
    return colors;
  }
  // The array "OutsideImage" refers to a picture. Without a picture, the array has no meaning.
  const auto varying = std::find_if_not(arrays.begin(), arrays.end(),
    [](const NamedArray* array) { return array->Name == "OutsideImage" || isConstant(*array); });
  return varying == arrays.end() ? -1 : static_cast<int>(varying - arrays.begin());
}

std::string htmlText(std::string_view text)
{
  const std::map<char, const char*> escapes = { { '&', "&amp;" }, { '<', "&lt;" }, { '>', "&gt;" },
    { '"', "&quot;" } };
  std::string result;
  for (const char c : validUTF8(text))
  {
    const auto escape = escapes.find(c);
    const bool isControl = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    result += escape != escapes.end() ? escape->second : std::string(1, isControl ? ' ' : c);
  }
  return result;
}

// Replace each {{NAME}} of a template by its text. Inserted text is not searched for further names.
std::string filled(std::string_view text, const std::map<std::string, std::string_view>& parts)
{
  std::string result;
  std::size_t size = text.size();
  for (const auto& part : parts)
  {
    size += part.second.size();
  }
  result.reserve(size);
  for (std::size_t begin = text.find("{{"); begin != std::string_view::npos;
       begin = text.find("{{"))
  {
    const std::size_t end = text.find("}}", begin);
    result += text.substr(0, begin);
    result += parts.at(std::string(text.substr(begin + 2, end - begin - 2)));
    text.remove_prefix(end + 2);
  }
  return result.append(text);
}
}

//------------------------------------------------------------------------------
const NamedArray& requirePageSurface(const SurfaceData& surface)
{
  if (numberOfPolygons(surface) == 0)
  {
    throw std::invalid_argument("the surface has no polygons");
  }
  requireTriangles(surface);
  if (surface.Points.numberOfTuples() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("the surface has too many points for 32-bit ids");
  }
  const NamedArray* sphere = findSpherePositions(surface);
  if (!sphere)
  {
    throw std::invalid_argument("the surface has no array \"SpherePosition\" of 3 numbers");
  }
  return *sphere;
}

//------------------------------------------------------------------------------
std::string makeSurfacePage(const SurfaceData& surface, std::string_view jpeg,
  std::string_view threeJS, const SurfacePageOptions& options, const Run& run)
{
  run.report(0.0);
  const NamedArray& sphere = requirePageSurface(surface);
  const NamedArray* texCoords = findArray(surface.PointArrays, "TCoords", 2, isFloating);
  if (!jpeg.empty() && !texCoords)
  {
    throw std::invalid_argument("the surface has no texture coordinates of 2 numbers");
  }
  const std::vector<const NamedArray*> arrays = shownArrays(surface);
  const int first = firstShown(arrays, options.ColorArrayName, !jpeg.empty());

  PageBuilder builder(surface, sphere);
  run.report(0.1);
  builder.addPlaces("bounds", surface.Points, "coordinate");
  builder.addSphere();
  run.report(0.15);
  builder.addTriangles();
  run.report(0.25);
  if (!jpeg.empty())
  {
    builder.addPlaces("textureBounds", *texCoords, "texture coordinate");
    builder.add("repeatsTexture", options.RepeatsTexture ? "true" : "false");
  }
  std::string list;
  for (const NamedArray* array : arrays)
  {
    list += (list.empty() ? "" : ",") + builder.addArray(*array);
    run.report(0.3);
  }
  builder.add("arrays", "[" + list + "]");
  builder.add("first", std::to_string(first));
  builder.add("surfaceAxes", jsonNumbers(options.SurfaceAxes));
  builder.add("sphereAxes", jsonNumbers(options.SphereAxes));

  builder.Description += "}";
  const std::string title = htmlText(options.Title);
  const std::string data = encodeBinaryText(builder.Bytes, true, run.part(0.3, 0.8));
  const std::string library = encodeBinaryText(threeJS, true, run.part(0.8, 0.95));
  const std::string picture = encodeBinaryText(jpeg, false);
  run.report(1.0);
  return filled(PageHTML,
    { { "title", title }, { "style", PageCSS }, { "description", builder.Description },
      { "data", data }, { "picture", picture }, { "three", library }, { "program", PageScript } });
}
}
