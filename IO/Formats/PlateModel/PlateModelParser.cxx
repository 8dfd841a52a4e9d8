#include "PlateModel/PlateModelParser.h"

#include "Bytes/LineReader.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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
    this->nextLine("the number of vertices");
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
      if (count.size() != 1 || !isCount(count[0]))
      {
        this->Lines.failExpecting("the number of plates");
      }
      counts.push_back(count[0]);
    }
    this->readPlates(counts[1]);
    while (this->Lines.next())
    {
      if (!this->Lines.isBlankLine())
      {
        this->Lines.failExpecting("the end of the file");
      }
    }
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
    std::size_t width = 0;
    double first = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->nextLine("vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
      const std::vector<double> row = numbersOf(this->Lines.text());
      if (i == 0)
      {
        width = row.size();
        first = row.empty() ? 0.0 : row[0];
      }
      const bool hasIndex = width == 4;
      const bool isRight = row.size() == width && (width == 3 || hasIndex) &&
        (!hasIndex ||
          ((first == 0.0 || first == 1.0) && row[0] == first + static_cast<double>(i))) &&
        std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
      if (!isRight)
      {
        this->failAtRow(
          i == 0 ? 0 : width, "X Y Z, or I X Y Z with I counting from 0 or 1, of finite numbers");
      }
      append(this->Data.Points, row.data() + (hasIndex ? 1 : 0));
    }
    this->NumberOfPoints = count;
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
  bool HasZero = false; ///< vertices are numbered from 0
};
}

//------------------------------------------------------------------------------
SurfaceResult parsePlateModel(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { PlateModelReader(input, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikePlateModel(std::string_view start)
{
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
  const std::vector<double> counts = takeLine(line) ? numbersOf(line) : std::vector<double>();
  if (counts.empty() || counts.size() > 2 || !std::all_of(counts.begin(), counts.end(), isCount) ||
    counts[0] < minimumVertices)
  {
    return false;
  }
  constexpr int rows = 3;
  double first = 0.0;
  for (int i = 0; i < rows; ++i)
  {
    const std::vector<double> row = takeLine(line) ? numbersOf(line) : std::vector<double>();
    first = i == 0 && !row.empty() ? row[0] : first;
    const bool isIndexed = row.size() == 4 && (first == 0.0 || first == 1.0) && row[0] == first + i;
    if (!isIndexed && (row.size() != 3 || counts.size() < 2))
    {
      return false;
    }
  }
  return true;
}
}
