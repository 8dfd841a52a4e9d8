#include "SPHARM/SPHARMMesh.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"
#include "Bytes/SurfaceWalk.h"
#include "Bytes/UnitVectors.h"

#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::string_view Magic = "# vtk DataFile Version ";

std::string inUpperCase(std::string_view word)
{
  std::string result(word);
  for (char& c : result)
  {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return result;
}

// Data from the start of a file, up to the type of its data set.
struct MeshHeader
{
  bool IsBinary = false;
  bool IsPolyData = false;
};

class MeshReader
{
public:
  MeshReader(ByteReader& input, const ParseLimits& limits, const Run& run, SurfaceData& data)
    : Input(input)
    , Limits(limits)
    , Progress(input, run)
    , Data(data)
  {
  }

  MeshHeader readHeader()
  {
    this->Input.requireBytes();
    if (this->Input.peek(Magic.size()).substr(0, Magic.size()) != Magic)
    {
      this->Input.fail(
        ParseCode::UnrecognizedType, "expected \"" + std::string(Magic) + "\" and a number");
    }
    this->skipLine(); // version
    this->skipLine(); // title
    MeshHeader header;
    const std::string encoding = this->nextWord();
    header.IsBinary = encoding == "BINARY";
    if (!header.IsBinary && encoding != "ASCII")
    {
      this->failAtWord("ASCII or BINARY");
    }
    this->takeWord();
    this->takeKeyword("DATASET");
    header.IsPolyData = this->nextWord() == "POLYDATA";
    return header;
  }

  void read()
  {
    const MeshHeader header = this->readHeader();
    if (!header.IsPolyData)
    {
      this->failAtWord("POLYDATA");
    }
    this->takeWord();
    this->IsBinary = header.IsBinary;
    if (this->IsBinary)
    {
      this->Input.beginBinary();
    }
    for (std::string word = this->nextWord();
         !word.empty() && word != "POINT_DATA" && word != "CELL_DATA" && word != "FIELD";
         word = this->nextWord())
    {
      if (word == "METADATA")
      {
        this->skipToBlankLine();
      }
      else if (word == "POINTS" && !this->HasPoints)
      {
        this->takeWord();
        this->readPoints();
      }
      else if (this->HasPoints && (word == "POLYGONS" || word == "VERTICES" || word == "LINES"))
      {
        this->takeWord();
        this->readCells(word == "POLYGONS");
      }
      else
      {
        this->failAtWord(
          this->HasPoints ? "POLYGONS, VERTICES, LINES or arrays" : "POINTS before all else");
      }
    }
    if (!this->HasPoints)
    {
      this->failAtWord("POINTS before all else");
    }
  }

private:
  //----------------------------------------------------------------------------
  // Read the words between the data. They are text, also in a binary file.
  std::string_view peekWord()
  {
    constexpr std::size_t longest = 256;
    TextValues(this->Input).skipBlanks();
    const std::string_view text = this->Input.peek(longest + 1);
    const std::size_t length = std::find_if(text.begin(), text.end(), isBlank) - text.begin();
    return text.substr(0, std::min(length, longest));
  }

  std::string nextWord() { return inUpperCase(this->peekWord()); }

  void takeWord() { this->Input.advance(this->peekWord().size()); }

  void takeKeyword(const std::string& keyword)
  {
    if (this->nextWord() != keyword)
    {
      this->failAtWord(keyword);
    }
    this->takeWord();
  }

  [[noreturn]] void failAtWord(const std::string& expected)
  {
    const std::string_view word = this->peekWord();
    if (word.empty())
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends, expected " + expected);
    }
    this->Input.fail(ParseCode::Malformed, "found " + quoted(word) + ", expected " + expected);
  }

  // Skip the current line. Return whether the line had only blanks.
  bool skipLine()
  {
    bool isBlankLine = true;
    for (std::size_t length = 0;; ++length)
    {
      const std::string_view text = this->Input.peek(1);
      if (text.empty())
      {
        return isBlankLine;
      }
      if (length > LongestLine)
      {
        this->Input.fail(ParseCode::Malformed, tooLongMessage("a line"));
      }
      const char c = text[0];
      this->Input.advance(1);
      if (c == '\n')
      {
        return isBlankLine;
      }
      isBlankLine = isBlankLine && isBlank(c);
    }
  }

  void skipToBlankLine()
  {
    while (!this->skipLine() && !this->Input.peek(1).empty())
    {
      this->Progress.tick();
    }
  }

  std::uint64_t nextCount() { return TextValues(this->Input).next<std::uint64_t>(); }

  //----------------------------------------------------------------------------
  // Call `use` with a reader of numbers, as text or as big-endian bytes. Bytes begin after the end
  // of the current line.
  template <typename Use>
  void withValues(Use use)
  {
    if (this->IsBinary)
    {
      this->skipLine();
      BinaryValues values(this->Input, isLittleEndianMachine());
      use(values);
    }
    else
    {
      TextValues values(this->Input);
      use(values);
    }
  }

  void readPoints()
  {
    const std::uint64_t stated = this->nextCount();
    const std::string type = this->nextWord();
    if (type != "FLOAT" && type != "DOUBLE")
    {
      this->failAtWord("float or double");
    }
    this->takeWord();
    this->HasPoints = true;
    if (type == "FLOAT")
    {
      this->readPoints<float>(stated, ScalarType::Float32);
    }
    else
    {
      this->readPoints<double>(stated, ScalarType::Float64);
    }
  }

  template <typename T>
  void readPoints(std::uint64_t stated, ScalarType type)
  {
    const std::uint64_t minimumBytes = this->IsBinary ? 3 * sizeof(T) : 5;
    const std::size_t count =
      this->Limits.checkedCount(this->Input, "points", stated, minimumBytes, 3 * sizeof(T));
    this->Data.Points = makeArray("Points", type, 3);
    this->Data.Points.Values.reserve(count * 3 * sizeof(T));
    this->withValues(
      [&](auto& values)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          std::array<T, 3> p;
          for (T& coordinate : p)
          {
            coordinate = values.template next<T>();
          }
          if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
          {
            this->Input.fail(ParseCode::Malformed,
              "found coordinates of point " + std::to_string(i) + " that are not finite");
          }
          append(this->Data.Points, p.data());
          this->Progress.tick();
        }
      });
  }

  //----------------------------------------------------------------------------
  // Read cells. The two counts before the cells have different meanings, which the next word
  // defines.
  void readCells(bool isKept)
  {
    const std::uint64_t first = this->nextCount(), second = this->nextCount();
    if (this->IsBinary ? this->hasOffsetsBehindLine() : this->nextWord() == "OFFSETS")
    {
      this->readCellsByOffsets(first, second, isKept);
    }
    else
    {
      this->readCellsBySizes(first, second, isKept);
    }
  }

  // Test whether the next line begins with OFFSETS. Binary data cannot be mistaken for this
  // keyword, since the first number would be billions of points.
  bool hasOffsetsBehindLine()
  {
    constexpr std::string_view keyword = "OFFSETS";
    std::string_view text = this->Input.peek(keyword.size() + 2);
    text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    return text.substr(0, keyword.size()) == keyword;
  }

  // Read cells by sizes: the number of ids precedes the ids of each cell. In binary files, all
  // numbers are 4-byte integers.
  void readCellsBySizes(std::uint64_t statedCells, std::uint64_t statedNumbers, bool isKept)
  {
    const std::uint64_t bytes = this->IsBinary ? sizeof(std::int32_t) : 2;
    const std::size_t numbers = this->Limits.checkedCount(
      this->Input, "numbers of cells", statedNumbers, bytes, sizeof(std::int64_t));
    const std::size_t cells =
      this->Limits.checkedCount(this->Input, "cells", statedCells, bytes, sizeof(std::int64_t));
    std::size_t left = numbers;
    PolygonList polygons(this->Input, this->Data.Points.numberOfTuples(), this->Data);
    this->withValues(
      [&](auto& values)
      {
        for (std::size_t i = 0; i < cells; ++i)
        {
          const auto size = left > 0 ? values.template next<std::int32_t>() : -1;
          if (size < 0 || static_cast<std::size_t>(size) >= left)
          {
            this->Input.fail(ParseCode::Malformed,
              "found cell " + std::to_string(i) + " of " + std::to_string(size) +
                " ids, expected at most the remaining numbers");
          }
          left -= 1 + static_cast<std::size_t>(size);
          this->readCell(values, polygons, size, isKept, std::int32_t());
        }
      });
    if (left > 0)
    {
      this->Input.fail(
        ParseCode::Malformed, "found " + std::to_string(left) + " numbers of cells too many");
    }
  }

  // Read cells by offsets: all offsets precede all ids. In binary files, all numbers are 8-byte
  // integers.
  void readCellsByOffsets(std::uint64_t statedOffsets, std::uint64_t statedIds, bool isKept)
  {
    const std::vector<std::int64_t> offsets = this->readOffsets(statedOffsets);
    this->takeKeyword("CONNECTIVITY");
    this->takeIntegerType();
    const std::size_t ids = this->Limits.checkedCount(this->Input, "ids of cells", statedIds,
      this->IsBinary ? sizeof(std::int64_t) : 2, sizeof(std::int64_t));
    bool isRight = offsets.empty() || offsets.front() == 0;
    for (std::size_t i = 1; i < offsets.size(); ++i)
    {
      isRight = isRight && offsets[i] >= offsets[i - 1];
    }
    const std::int64_t end = offsets.empty() ? 0 : offsets.back();
    if (!isRight || end != static_cast<std::int64_t>(ids))
    {
      this->Input.fail(ParseCode::Malformed,
        "found offsets of cells that do not increase from 0 to the number of their ids");
    }
    PolygonList polygons(this->Input, this->Data.Points.numberOfTuples(), this->Data);
    this->withValues(
      [&](auto& values)
      {
        for (std::size_t i = 1; i < offsets.size(); ++i)
        {
          this->readCell(values, polygons, offsets[i] - offsets[i - 1], isKept, std::int64_t());
        }
      });
  }

  std::vector<std::int64_t> readOffsets(std::uint64_t stated)
  {
    this->takeKeyword("OFFSETS");
    this->takeIntegerType();
    const std::size_t count = this->Limits.checkedCount(this->Input, "offsets of cells", stated,
      this->IsBinary ? sizeof(std::int64_t) : 2, 2 * sizeof(std::int64_t));
    std::vector<std::int64_t> offsets;
    offsets.reserve(count);
    this->withValues(
      [&](auto& values)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          offsets.push_back(values.template next<std::int64_t>());
          this->Progress.tick();
        }
      });
    return offsets;
  }

  void takeIntegerType()
  {
    const std::string type = this->nextWord();
    if (type != "VTKTYPEINT64" && !(type == "VTKIDTYPE" && !this->IsBinary))
    {
      this->failAtWord("vtktypeint64");
    }
    this->takeWord();
  }

  template <typename Values, typename Id>
  void readCell(Values& values, PolygonList& polygons, std::int64_t size, bool isKept, Id)
  {
    for (std::int64_t k = 0; k < size; ++k)
    {
      const auto id = values.template next<Id>();
      if (isKept)
      {
        polygons.add(id);
      }
      this->Progress.tick();
    }
    if (isKept)
    {
      polygons.end();
    }
  }

  ByteReader& Input;
  const ParseLimits& Limits;
  ProgressReport Progress;
  SurfaceData& Data;
  bool IsBinary = false;
  bool HasPoints = false;
};

//------------------------------------------------------------------------------
std::string makeMesh(
  const SurfaceData& surface, const NamedArray& points, const char* title, const Run& run)
{
  requireTriangles(surface);
  const bool isFloat = points.Type == ScalarType::Float32;
  std::string text = "# vtk DataFile Version 3.0\n" + std::string(title) +
    "\nASCII\nDATASET POLYDATA\nPOINTS " + std::to_string(points.numberOfTuples()) +
    (isFloat ? " float\n" : " double\n");
  const std::size_t polygons = numberOfPolygons(surface);
  walk(
    surface, run,
    [&](std::size_t point)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        text += c > 0 ? " " : "";
        const double value = valueOf(points, 3 * point + c);
        isFloat ? appendNumber(text, static_cast<float>(value)) : appendNumber(text, value);
      }
      text += '\n';
    },
    [&](std::size_t polygon, const std::int64_t* ids, std::size_t count)
    {
      if (polygon == 0)
      {
        text += "POLYGONS " + std::to_string(polygons) + " " + std::to_string(4 * polygons) + "\n";
      }
      appendNumber(text, count);
      for (std::size_t c = 0; c < count; ++c)
      {
        text += ' ';
        appendNumber(text, ids[c]);
      }
      text += '\n';
    });
  return text;
}
}

//------------------------------------------------------------------------------
SurfaceResult parseSPHARMMesh(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface([&](SurfaceData& data) { MeshReader(input, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikeSPHARMMesh(std::string_view start)
{
  ByteReader input(start);
  SurfaceData data;
  bool isMesh = false;
  statusOf([&]() { isMesh = MeshReader(input, {}, {}, data).readHeader().IsPolyData; });
  return isMesh;
}

//------------------------------------------------------------------------------
std::string sphereNameOf(const std::string& path)
{
  constexpr std::string_view surface = "_surf";
  const std::size_t folder = path.find_last_of("/\\") + 1; // 0 without a folder
  const std::size_t point = path.rfind('.');
  const std::size_t end = point == std::string::npos || point < folder ? path.size() : point;
  const bool isSurface = end >= folder + surface.size() &&
    std::string_view(path).substr(end - surface.size(), surface.size()) == surface;
  return path.substr(0, end - (isSurface ? surface.size() : 0)) + "_para" + path.substr(end);
}

//------------------------------------------------------------------------------
std::string makeSPHARMSurface(const SurfaceData& surface, const Run& run)
{
  return makeMesh(surface, surface.Points, "surface", run);
}

//------------------------------------------------------------------------------
std::string makeSPHARMSphere(const SurfaceData& surface, const Run& run)
{
  const NamedArray* sphere = findSpherePositions(surface);
  if (!sphere)
  {
    throw std::invalid_argument("the surface has no array \"SpherePosition\" of 3 numbers");
  }
  NamedArray unit = makeArray("SpherePosition", ScalarType::Float64, 3);
  for (std::size_t i = 0; i < sphere->numberOfTuples(); ++i)
  {
    const std::array<double, 3> n = { valueOf(*sphere, 3 * i), valueOf(*sphere, 3 * i + 1),
      valueOf(*sphere, 3 * i + 2) };
    append(unit, n.data());
  }
  makeUnitVectors(unit);
  return makeMesh(surface, unit, "sphere", run);
}
}
