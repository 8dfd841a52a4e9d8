#include "PlateModel/PlateModelParser.h"

#include "Bytes/LineReader.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"
#include "PlateModel/CubedPlates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
// Parse the words of a line as numbers. If a word is not a number, or there are more than 4 words,
// return no numbers.
std::vector<double> numbersOf(std::string_view line)
{
  constexpr std::size_t maximum = 4;
  LineWords words(line);
  std::vector<double> numbers;
  for (LineWords rest = words; !rest.next().empty(); words = rest)
  {
    double value = 0.0;
    if (numbers.size() == maximum || !words.next(value))
    {
      return {};
    }
    numbers.push_back(value);
  }
  return numbers;
}

bool isCount(double value)
{
  constexpr double maximum = 9007199254740992.0; // maximum exact integer of doubles
  return value >= 0.0 && value <= maximum && value == std::floor(value);
}

// Test whether a text is the first line of a plate model with a tag at the begin of each row.
bool isTaggedVertex(std::string_view line)
{
  constexpr std::size_t coordinates = 3;
  LineWords words(line);
  return words.next() == "v" && numbersOf(line.substr(line.find('v') + 1)).size() == coordinates;
}

class PlateModelReader
{
public:
  PlateModelReader(ByteReader& input, const ParseLimits& limits, const Run& run, SurfaceData& data)
    : Input(input)
    , Limits(limits)
    , Data(data)
    , Lines(input)
    , Progress(input, run)
  {
  }

  void read()
  {
    this->Input.requireBytes();
    do
    {
      this->nextLine("the number of vertices");
    } while (isRemark(this->firstWord()));
    if (this->firstWord() == "v")
    {
      this->readTaggedRows();
      return;
    }
    std::vector<double> counts = numbersOf(this->Lines.text());
    if (counts.empty() || counts.size() > 2 || !std::all_of(counts.begin(), counts.end(), isCount))
    {
      this->Input.fail(ParseCode::UnrecognizedType,
        "found " + quoted(this->Lines.text()) + ", expected numbers of vertices and plates");
    }
    this->readVertices(counts[0]);
    if (counts.size() < 2)
    {
      this->nextLine("the number of plates");
      const std::vector<double> count = numbersOf(this->Lines.text());
      if (count.size() == 3 && this->VertexColumns == 3 && counts[0] > 0.0)
      {
        this->readCube(counts[0]);
        this->expectEnd();
        return;
      }
      if (count.size() != 1 || !isCount(count[0]))
      {
        this->Lines.failExpecting("the number of plates");
      }
      counts.push_back(count[0]);
    }
    this->readPlates(counts[1]);
    this->expectEnd();
  }

private:
  // Advance to the next line that is not blank.
  void nextLine(const std::string& expected)
  {
    do
    {
      if (!this->Lines.next())
      {
        this->Input.fail(ParseCode::PrematureEnd, "the file ends, expected " + expected);
      }
    } while (this->Lines.isBlankLine());
    this->Progress.tick();
  }

  std::string_view firstWord() const { return LineWords(this->Lines.text()).next(); }

  void expectEnd()
  {
    while (this->Lines.next())
    {
      if (!this->Lines.isBlankLine())
      {
        this->Lines.failExpecting("the end of the file");
      }
    }
  }

  // Reject a row. If `columns` is not 0, and the row has a different number of columns, the message
  // contains both numbers.
  [[noreturn]] void failAtRow(std::size_t columns, const std::string& expected)
  {
    std::size_t count = 0;
    for (LineWords words(this->Lines.text()); !words.next().empty();)
    {
      ++count;
    }
    if (columns > 0 && count != columns)
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + quoted(this->Lines.text()) + " with " + std::to_string(count) +
          (count == 1 ? " column" : " columns") + ", expected " + std::to_string(columns) +
          " columns as in the first row");
    }
    this->Lines.failExpecting(expected);
  }

  std::size_t checkedCount(const char* what, double count, std::size_t bytes)
  {
    constexpr std::size_t shortestRow = 5; // three digits and two blanks
    return this->Limits.checkedCount(
      this->Input, what, static_cast<std::uint64_t>(count), shortestRow, bytes);
  }

  void readVertices(double number)
  {
    const std::size_t count = this->checkedCount("vertices", number, 3 * sizeof(double));
    this->Data.Points = makeArray("Points", ScalarType::Float64, 3);
    this->Data.Points.Values.reserve(count * 3 * sizeof(double));
    for (std::size_t i = 0; i < count; ++i)
    {
      this->nextLine("vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
      this->readVertex(i);
    }
    this->NumberOfPoints = count;
  }

  // Read the current line, the row of vertex i.
  void readVertex(std::size_t i)
  {
    const std::vector<double> row = numbersOf(this->Lines.text());
    if (i == 0)
    {
      this->VertexColumns = row.size();
      this->FirstIndex = row.empty() ? 0.0 : row[0];
    }
    const std::size_t width = this->VertexColumns;
    const double first = this->FirstIndex;
    const bool hasIndex = width == 4;
    const bool isRight = row.size() == width && (width == 3 || hasIndex) &&
      (!hasIndex || ((first == 0.0 || first == 1.0) && row[0] == first + static_cast<double>(i))) &&
      std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
    if (!isRight)
    {
      this->failAtRow(
        i == 0 ? 0 : width, "X Y Z, or I X Y Z with I counting from 0 or 1, of finite numbers");
    }
    append(this->Data.Points, row.data() + (hasIndex ? 1 : 0));
  }

  // Read the rest of a model whose vertices are grids on the sides of a cube. The first `number`
  // vertices have been read, and the current line is the next vertex.
  void readCube(double number)
  {
    // A larger number could overflow, and no file has as many vertices.
    constexpr double maximum = 1e9;
    const std::size_t q = static_cast<std::size_t>(std::min(number, maximum));
    const std::size_t count = cubedSize(q);
    this->checkedCount("vertices", static_cast<double>(count - q), 3 * sizeof(double));
    for (std::size_t i = q; i < count; ++i)
    {
      if (i > q)
      {
        this->nextLine("vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
      }
      this->readVertex(i);
    }
    std::vector<double> grids(3 * count);
    std::memcpy(grids.data(), this->Data.Points.Values.data(), grids.size() * sizeof(double));
    const CubedPlates plates = connectCubedPlates(grids, q);
    this->Data.Points = makeArray("Points", ScalarType::Float64, 3);
    this->NumberOfPoints = plates.Points.size() / 3;
    for (std::size_t i = 0; i < this->NumberOfPoints; ++i)
    {
      append(this->Data.Points, plates.Points.data() + 3 * i);
    }
    this->HasZero = true;
    this->addPlates(plates.Ids);
  }

  // Read rows "v X Y Z" and "f A B C", beginning with the current line.
  void readTaggedRows()
  {
    this->Data.Points = makeArray("Points", ScalarType::Float64, 3);
    std::vector<std::int64_t> ids;
    do
    {
      this->Progress.tick();
      const std::string_view line = this->Lines.text();
      const std::string_view tag = this->firstWord();
      if (isIgnored(tag))
      {
        continue;
      }
      const bool isVertex = tag == "v" && ids.empty(), isPlate = tag == "f";
      std::vector<double> row;
      if (isVertex || isPlate)
      {
        row = numbersOf(line.substr(line.find(tag.front()) + 1));
      }
      if (row.size() != 3 ||
        !std::all_of(row.begin(), row.end(),
          [&](double x) { return isVertex ? std::isfinite(x) : isCount(x) && x >= 1.0; }))
      {
        this->Lines.failExpecting(ids.empty()
            ? "v X Y Z of finite numbers, or f A B C of numbers of vertices from 1"
            : "f A B C of numbers of vertices from 1");
      }
      if (isVertex)
      {
        append(this->Data.Points, row.data());
        ++this->NumberOfPoints;
        this->checkMemory("vertices", this->NumberOfPoints, 3 * sizeof(double));
        continue;
      }
      for (const double id : row)
      {
        this->addId(ids, id);
      }
      this->checkMemory("plates", ids.size() / 3, 4 * sizeof(std::int64_t));
    } while (this->Lines.next());
    this->addPlates(ids);
  }

  // Check the memory of records that no count announces. The check at powers of 2 is sufficient,
  // since arrays grow by factors.
  void checkMemory(const char* what, std::size_t count, std::size_t bytes)
  {
    if ((count & (count - 1)) == 0)
    {
      if (count > this->Limits.MaximumMemory / bytes)
      {
        this->Input.fail(ParseCode::OutOfMemory, std::string("too many ") + what);
      }
    }
  }

  void readPlates(double number)
  {
    const std::size_t count = this->checkedCount("plates", number, 4 * sizeof(std::int64_t));
    std::vector<std::int64_t> ids;
    ids.reserve(3 * count);
    double first = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::string expected =
        "plate " + std::to_string(i + 1) + " of " + std::to_string(count);
      this->nextLine(expected);
      std::vector<double> row = numbersOf(this->Lines.text());
      const bool isNextLine = row.size() == 1 && row[0] == 3.0;
      if (isNextLine)
      {
        this->nextLine(expected);
        row = numbersOf(this->Lines.text());
      }
      if (i == 0)
      {
        first = row.size() == 4 ? row[0] : -1.0;
      }
      const bool isIndexed = row.size() == 4 && !isNextLine;
      const bool isRight = isIndexed == (first >= 0.0) &&
        (isIndexed ? first == 3.0
              ? row[0] == 3.0
              : (first == 0.0 || first == 1.0) && row[0] == first + static_cast<double>(i)
                   : row.size() == 3) &&
        std::all_of(row.begin(), row.end(), isCount);
      if (!isRight)
      {
        this->failAtRow(isNextLine ? 3
            : i == 0               ? 0
            : first >= 0.0         ? 4
                                   : 3,
          "A B C, I A B C with I counting from 0 or 1, or 3 A B C");
      }
      for (std::size_t k = row.size() - 3; k < row.size(); ++k)
      {
        this->addId(ids, row[k]);
      }
    }
    this->addPlates(ids);
  }

  void addId(std::vector<std::int64_t>& ids, double value)
  {
    const auto id = static_cast<std::int64_t>(value);
    this->HasZero = this->HasZero || id == 0;
    const auto size = static_cast<std::int64_t>(this->NumberOfPoints);
    if (id > size || (this->HasZero && id == size))
    {
      this->Lines.failExpecting(
        "numbers of vertices up to " + std::to_string(size - (this->HasZero ? 1 : 0)));
    }
    ids.push_back(id);
  }

  void addPlates(const std::vector<std::int64_t>& ids)
  {
    PolygonList polygons(this->Input, this->NumberOfPoints, this->Data);
    polygons.reserve(ids.size() / 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      polygons.add(ids[i] - (this->HasZero ? 0 : 1));
      if (i % 3 == 2)
      {
        polygons.end();
      }
    }
  }

  ByteReader& Input;
  const ParseLimits& Limits;
  SurfaceData& Data;
  LineReader Lines;
  ProgressReport Progress;
  std::size_t NumberOfPoints = 0;
  std::size_t VertexColumns = 0; ///< number of columns of the rows of vertices
  double FirstIndex = 0.0;       ///< first number of the first row of vertices
  bool HasZero = false;          ///< vertices are numbered from 0
};

// Test whether bytes begin like a plate model. isNamed states whether the file has an extension of
// plate models.
bool beginsLikePlateModel(std::string_view start, std::uint64_t size, bool isNamed)
{
  const std::size_t startSize = start.size();
  // Get the next complete line that is not blank.
  const auto takeLine = [&](std::string_view& line)
  {
    do
    {
      const std::size_t end = start.find_first_of("\r\n");
      if (end == start.npos)
      {
        return false;
      }
      line = start.substr(0, end);
      start.remove_prefix(end + 1);
    } while (line.find_first_not_of(" \t\v\f") == line.npos);
    return true;
  };
  constexpr double minimumVertices = 3.0;
  std::string_view line;
  bool hasLine = takeLine(line);
  while (hasLine && isRemark(LineWords(line).next()))
  {
    hasLine = takeLine(line);
  }
  if (hasLine && isTaggedVertex(line))
  {
    return takeLine(line) && isTaggedVertex(line) && takeLine(line) && isTaggedVertex(line);
  }
  const std::vector<double> counts = hasLine ? numbersOf(line) : std::vector<double>();
  if (counts.empty() || counts.size() > 2 || !std::all_of(counts.begin(), counts.end(), isCount) ||
    counts[0] < (counts.size() < 2 ? 1.0 : minimumVertices))
  {
    return false;
  }
  constexpr int rows = 3;
  double first = 0.0;
  int columns = 0;
  const std::size_t before = start.size();
  for (int i = 0; i < rows; ++i)
  {
    const std::vector<double> row = takeLine(line) ? numbersOf(line) : std::vector<double>();
    first = i == 0 && !row.empty() ? row[0] : first;
    const bool isIndexed = row.size() == 4 && (first == 0.0 || first == 1.0) && row[0] == first + i;
    columns += static_cast<int>(row.size());
    if (!isIndexed && row.size() != 3)
    {
      return false;
    }
  }
  if (counts.size() > 1 || columns == 4 * rows)
  {
    return counts[0] >= minimumVertices;
  }
  // A count and rows of three numbers may also be a cloud, which has far fewer rows than grids on
  // the sides of a cube.
  const double rowBytes = static_cast<double>(before - start.size()) / rows;
  const double wanted = 6.0 * (counts[0] + 1.0) * (counts[0] + 1.0) * rowBytes;
  const auto bytes = static_cast<double>(size > 0 ? size : startSize);
  const bool isOfGrids = 0.5 * wanted < bytes && bytes < 2.0 * wanted;
  constexpr double longer = 1.3; // plates follow the vertices
  const bool hasMore = bytes > longer * counts[0] * rowBytes;
  return columns == 3 * rows && (isOfGrids || (isNamed && hasMore));
}
}

//------------------------------------------------------------------------------
SurfaceResult parsePlateModel(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { PlateModelReader(input, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikePlateModel(std::string_view start, std::uint64_t size)
{
  return beginsLikePlateModel(start, size, false);
}

//------------------------------------------------------------------------------
bool looksLikeNamedPlateModel(std::string_view start, std::uint64_t size)
{
  return beginsLikePlateModel(start, size, true);
}
}
