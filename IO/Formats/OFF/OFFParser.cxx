#include "OFF/OFFParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/ColorList.h"
#include "Bytes/FileValues.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace conformal
{
namespace
{
// Properties of the file that the keyword states. If there is no keyword, all properties are false,
// and the file is text.
struct OFFKeyword
{
  bool HasTCoords = false;
  bool HasColors = false;
  bool HasNormals = false;
  bool IsHomogeneous = false;
  bool HasDimension = false;
  bool IsThere = false;
};

OFFKeyword keywordOf(std::string_view word)
{
  OFFKeyword keyword;
  const auto take = [&](std::string_view prefix)
  {
    const bool has = word.substr(0, prefix.size()) == prefix;
    word.remove_prefix(has ? prefix.size() : 0);
    return has;
  };
  // Programs write these prefixes in any order; the order of the data is always the same.
  constexpr int prefixes = 3;
  for (int i = 0; i < prefixes; ++i)
  {
    keyword.HasTCoords = take("ST") || keyword.HasTCoords;
    keyword.HasColors = take("C") || keyword.HasColors;
    keyword.HasNormals = take("N") || keyword.HasNormals;
  }
  keyword.IsHomogeneous = take("4");
  keyword.HasDimension = take("n");
  keyword.IsThere = word == "OFF";
  return keyword.IsThere ? keyword : OFFKeyword();
}

class OFFReader
{
public:
  OFFReader(ByteReader& input, const ParseLimits& limits, const Run& run, SurfaceData& data)
    : Input(input)
    , Limits(limits)
    , Data(data)
    , Progress(input, run)
    , Colors(input)
    , PolygonColors(input)
  {
  }

  void read()
  {
    this->Input.requireBytes();
    this->readKeyword();
    if (this->isBinary())
    {
      this->Input.beginBinary();
      this->readBody<float>(BinaryValues(this->Input, isLittleEndianMachine()));
    }
    else
    {
      this->readBody<double>(TextValues(this->Input, true));
    }
  }

private:
  void readKeyword()
  {
    constexpr std::size_t longest = 16; // length of a keyword and the next bytes
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (this->Input.peek(mark.size()).substr(0, mark.size()) == mark)
    {
      this->Input.advance(mark.size());
    }
    TextValues(this->Input, true).skipBlanks();
    const std::string_view start = this->Input.peek(longest);
    const std::string_view word(
      start.data(), std::find_if(start.begin(), start.end(), isBlank) - start.begin());
    this->Keyword = keywordOf(word);
    const bool startsWithCount = !word.empty() && word[0] >= '0' && word[0] <= '9';
    if (!this->Keyword.IsThere && !startsWithCount)
    {
      this->Input.fail(ParseCode::UnrecognizedType, "found " + quoted(word) + ", expected OFF");
    }
    this->Input.advance(this->Keyword.IsThere ? word.size() : 0);
  }

  // Test whether BINARY follows the keyword. If it does, skip the rest of its line.
  bool isBinary()
  {
    constexpr std::string_view binary = "BINARY";
    TextValues text(this->Input);
    if (text.isLineEnd() || this->Input.peek(binary.size()).substr(0, binary.size()) != binary)
    {
      return false;
    }
    this->Input.advance(binary.size());
    text.endRecord();
    const std::string_view end = this->Input.peek(2).substr(0, 2);
    this->Input.advance(std::min<std::size_t>(end.size(), end == "\r\n" ? 2 : 1));
    return true;
  }

  template <typename T, typename Values>
  void readBody(Values values)
  {
    if (this->Keyword.HasDimension && values.template next<std::int32_t>() != 3)
    {
      this->Input.fail(ParseCode::Malformed, "expected 3 dimensions");
    }
    this->readCounts(values);
    this->readPoints<T>(values);
    this->readPolygons(values);
    this->finish();
  }

  // The number of edges is not used. If a line has only two numbers, the number of edges is
  // missing.
  void readCounts(TextValues& text)
  {
    this->NumberOfPoints = text.next<std::uint64_t>();
    const bool isOnePerLine = text.isLineEnd();
    this->NumberOfPolygons = text.next<std::uint64_t>();
    if (isOnePerLine || !text.isLineEnd())
    {
      text.next<std::int64_t>();
    }
  }

  void readCounts(BinaryValues& values)
  {
    for (std::uint64_t* count : { &this->NumberOfPoints, &this->NumberOfPolygons })
    {
      const auto value = values.next<std::int32_t>();
      if (value < 0)
      {
        this->Input.fail(ParseCode::Malformed,
          "found a count of " + std::to_string(value) + ", expected 0 or more");
      }
      *count = static_cast<std::uint64_t>(value);
    }
    values.next<std::int32_t>();
  }

  //----------------------------------------------------------------------------
  template <typename T, typename Values>
  void readPoints(Values& values)
  {
    const ScalarType type = sizeof(T) == sizeof(float) ? ScalarType::Float32 : ScalarType::Float64;
    const std::size_t coordinates = this->Keyword.IsHomogeneous ? 4 : 3;
    const std::size_t numbers = coordinates + (this->Keyword.HasNormals ? 3 : 0);
    const bool isText = std::is_same<Values, TextValues>::value;
    const std::size_t count = this->Limits.checkedCount(this->Input, "points", this->NumberOfPoints,
      numbers * values.minimumBytes(type) - (isText ? 1 : 0), 6 * sizeof(T));
    NamedArray normals = makeArray("Normals", type, 3);
    NamedArray tcoords = makeArray("TCoords", type, 2);
    this->Data.Points = makeArray("Points", type, 3);
    this->Data.Points.Values.reserve(count * 3 * sizeof(T));
    for (std::size_t i = 0; i < count; ++i)
    {
      std::array<T, 4> p = { T(0), T(0), T(0), T(1) };
      for (std::size_t c = 0; c < coordinates; ++c)
      {
        p[c] = values.template next<T>();
      }
      std::array<T, 3> n;
      for (std::size_t c = 0; c < (this->Keyword.HasNormals ? 3 : 0); ++c)
      {
        n[c] = values.template next<T>();
      }
      const std::vector<double>& extras = this->extrasOfPoint(values, i);
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] /= p[3];
      }
      this->Progress.tick();
      if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
      {
        this->dropPoint(i);
        continue;
      }
      append(this->Data.Points, p.data());
      if (this->Keyword.HasNormals)
      {
        append(normals, n.data());
      }
      const std::size_t colors = extras.size() - (this->Keyword.HasTCoords ? 2 : 0);
      if (colors > 0)
      {
        this->Colors.add(extras.data(), colors);
      }
      if (this->Keyword.HasTCoords)
      {
        const std::array<T, 2> st = { static_cast<T>(extras[colors]),
          static_cast<T>(extras[colors + 1]) };
        append(tcoords, st.data());
      }
    }
    if (this->Keyword.HasNormals)
    {
      this->Data.PointArrays.push_back(std::move(normals));
    }
    if (this->Keyword.HasTCoords)
    {
      this->Data.PointArrays.push_back(std::move(tcoords));
    }
  }

  void dropPoint(std::size_t point)
  {
    if (this->NumberOfPolygons > 0)
    {
      this->Input.fail(ParseCode::Malformed,
        "found coordinates of point " + std::to_string(point) + " that are not finite");
    }
    ++this->Data.DroppedPoints;
  }

  // Read the numbers after the normals: colors and texture coordinates. All points must have
  // equally many.
  const std::vector<double>& extrasOfPoint(TextValues& text, std::size_t point)
  {
    this->readLine(text);
    const std::size_t colors = this->Extras.size() - (this->Keyword.HasTCoords ? 2 : 0);
    const bool isRight = point > 0
      ? this->Extras.size() == this->ExtrasOfPoints
      : colors == 3 || colors == 4 || (colors == 0 && !this->Keyword.HasColors);
    if (!isRight)
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + std::to_string(this->Extras.size()) +
          " numbers after the coordinates of a point, expected colors and texture coordinates as "
          "in the keyword, as many for each point");
    }
    this->ExtrasOfPoints = this->Extras.size();
    return this->Extras;
  }

  const std::vector<double>& extrasOfPoint(BinaryValues& values, std::size_t)
  {
    this->Extras.resize((this->Keyword.HasColors ? 4 : 0) + (this->Keyword.HasTCoords ? 2 : 0));
    for (double& extra : this->Extras)
    {
      extra = static_cast<double>(values.next<float>());
    }
    return this->Extras;
  }

  // Read the rest of a line into Extras.
  void readLine(TextValues& text)
  {
    constexpr std::size_t maximum = 6;
    this->Extras.clear();
    while (!text.isLineEnd())
    {
      if (this->Extras.size() == maximum)
      {
        text.endRecord();
      }
      this->Extras.push_back(text.next<double>());
    }
  }

  //----------------------------------------------------------------------------
  template <typename Values>
  void readPolygons(Values& values)
  {
    const bool isText = std::is_same<Values, TextValues>::value;
    const std::size_t count = this->Limits.checkedCount(this->Input, "faces",
      this->NumberOfPolygons, isText ? 1 : 2 * sizeof(std::int32_t), 4 * sizeof(std::int64_t));
    PolygonList polygons(this->Input, this->NumberOfPoints, this->Data);
    polygons.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto length = values.template next<std::int32_t>();
      if (length < 0)
      {
        this->Input.fail(ParseCode::Malformed,
          "found a face of " + std::to_string(length) + " ids, expected 0 or more");
      }
      const std::size_t corners =
        this->Limits.checkedCount(this->Input, "ids of a face", static_cast<std::uint64_t>(length),
          values.minimumBytes(ScalarType::Int32), sizeof(std::int64_t));
      for (std::size_t c = 0; c < corners; ++c)
      {
        polygons.add(values.template next<std::int32_t>());
        this->Progress.tick();
      }
      this->readColorOfPolygon(values);
      if (polygons.end())
      {
        this->addColorOfPolygon();
      }
    }
    this->endBody(values);
  }

  void readColorOfPolygon(TextValues& text) { this->readLine(text); }

  void readColorOfPolygon(BinaryValues& values)
  {
    const auto count = values.next<std::int32_t>();
    if (count < 0 || count > 4 || count == 2)
    {
      this->Input.fail(ParseCode::Malformed,
        "found a color of " + std::to_string(count) + " numbers, expected 0, 1, 3 or 4");
    }
    this->Extras.resize(static_cast<std::size_t>(count));
    for (double& extra : this->Extras)
    {
      extra = count == 1 ? static_cast<double>(values.next<std::int32_t>())
                         : static_cast<double>(values.next<float>());
    }
  }

  void addColorOfPolygon()
  {
    std::int32_t index = -1;
    if (this->Extras.size() == 3 || this->Extras.size() == 4)
    {
      this->PolygonColors.add(this->Extras.data(), this->Extras.size());
    }
    else
    {
      this->PolygonColors.addMissing();
      const bool hasIndex = this->Extras.size() == 1 && this->Extras[0] >= 0.0 &&
        this->Extras[0] <= std::numeric_limits<std::int32_t>::max() &&
        this->Extras[0] == std::floor(this->Extras[0]);
      if (!this->Extras.empty() && !hasIndex)
      {
        this->Input.fail(ParseCode::Malformed,
          "found " + std::to_string(this->Extras.size()) +
            " numbers after the ids of a face, expected an index or a color of 3 or 4");
      }
      index = hasIndex ? static_cast<std::int32_t>(this->Extras[0]) : index;
      this->HasIndex = this->HasIndex || hasIndex;
    }
    append(this->PolygonIndex, &index);
  }

  void endBody(TextValues& text) { text.endFile(); }
  void endBody(BinaryValues&) {}

  void finish()
  {
    if (this->Colors.hasAny())
    {
      this->Data.PointArrays.push_back(this->Colors.take());
    }
    if (this->PolygonColors.hasAny())
    {
      this->Data.PolygonArrays.push_back(this->PolygonColors.take());
    }
    if (this->HasIndex)
    {
      this->Data.PolygonArrays.push_back(std::move(this->PolygonIndex));
    }
  }

  ByteReader& Input;
  const ParseLimits& Limits;
  SurfaceData& Data;
  ProgressReport Progress;
  ColorList Colors;
  ColorList PolygonColors;
  NamedArray PolygonIndex = makeArray("ColorIndex", ScalarType::Int32, 1);
  OFFKeyword Keyword;
  std::vector<double> Extras;
  std::size_t ExtrasOfPoints = 0;
  std::uint64_t NumberOfPoints = 0;
  std::uint64_t NumberOfPolygons = 0;
  bool HasIndex = false;
};
}

//------------------------------------------------------------------------------
SurfaceResult parseOFF(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface([&](SurfaceData& data) { OFFReader(input, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikeOFF(std::string_view start)
{
  ByteReader input(start);
  TextValues(input, true).skipBlanks();
  const std::string_view rest = input.peek(1);
  return keywordOf(
    { rest.data(),
      static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), isBlank) - rest.begin()) })
    .IsThere;
}
}
