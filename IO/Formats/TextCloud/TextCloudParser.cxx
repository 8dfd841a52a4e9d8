#include "TextCloud/TextCloudParser.h"

#include "Bytes/LineReader.h"
#include "Bytes/ProgressReport.h"
#include "TextCloud/TextCloudLayout.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::size_t SampleBytes = std::size_t(4) << 20; // enough for a hundred long lines
constexpr std::size_t MaximumReservedBytes = std::size_t(64)
  << 20; // for an estimated number of lines

class TextCloudReader
{
public:
  TextCloudReader(ByteReader& input, const TextCloudOptions& options, const ParseLimits& limits,
    const Run& run, SurfaceData& data)
    : Input(input)
    , Options(options)
    , Limits(limits)
    , Data(data)
    , Lines(input)
    , Progress(input, run)
  {
  }

  void read()
  {
    this->findLayout();
    const bool hasStart = this->Options.Piece.isFirst();
    bool isCountNext = this->Layout.HasCount;
    bool isNamesNext = this->Layout.HasNames && hasStart;
    if (!hasStart)
    {
      this->goToLineFrom(this->Begin);
    }
    while (this->Lines.next() && this->Input.offset() < this->End)
    {
      const std::string_view line = this->Lines.text();
      this->Progress.tick();
      if (this->readPoint(line))
      {
        this->append();
      }
      else if (isIgnoredLine(line))
      {
        continue;
      }
      else if (isNamesNext && !startsWithNumber(line, ','))
      {
        isNamesNext = false;
      }
      else if (this->Layout.HasCount && (isCountNext || this->PointsToCome == 0))
      {
        this->readCount(line);
        isCountNext = false;
      }
      else
      {
        this->refuseLine(line);
      }
    }
    if (this->Layout.HasCount && this->PointsToCome > 0)
    {
      this->Input.fail(ParseCode::PrematureEnd,
        "the file ends, expected " + std::to_string(this->PointsToCome) + " more points");
    }
    this->Data.Points = std::move(this->Layout.Arrays.front());
    this->Layout.Arrays.erase(this->Layout.Arrays.begin());
    this->Data.PointArrays = std::move(this->Layout.Arrays);
  }

private:
  void findLayout()
  {
    this->Input.requireBytes();
    const std::string_view start = this->Input.peek(SampleBytes);
    const std::uint64_t first = this->Input.offset();
    try
    {
      this->Layout =
        findTextCloudLayout(start, start.size() == this->Input.left(), this->Options.DecimalComma);
    }
    catch (const NoTextCloud& e)
    {
      throw ParseError({ ParseCode::UnrecognizedType, e.Line, 0, e.what() });
    }
    this->Row.resize(this->Layout.Columns.size());
    this->findPiece(first + this->Layout.FirstOffset);
    const double lines =
      1.02 * static_cast<double>(this->End - this->Begin) / this->Layout.MeanLineBytes;
    std::size_t rowBytes = 1;
    for (const NamedArray& array : this->Layout.Arrays)
    {
      rowBytes += array.tupleBytes();
    }
    const std::size_t rows =
      std::min(static_cast<std::size_t>(lines + 1.0), MaximumReservedBytes / rowBytes);
    for (NamedArray& array : this->Layout.Arrays)
    {
      array.Values.reserve(rows * array.tupleBytes());
    }
  }

  // Find the range of bytes in which the lines of this piece begin.
  void findPiece(std::uint64_t firstPoint)
  {
    const FilePiece& piece = this->Options.Piece;
    const std::uint64_t size = this->Input.size();
    if (this->Layout.HasCount)
    {
      this->Begin = piece.isFirst() ? firstPoint : size;
      this->End = size;
      return;
    }
    this->Begin = firstPoint + piece.begin(size - firstPoint);
    this->End = firstPoint + piece.end(size - firstPoint);
  }

  // Advance to the first line that begins at an offset or later. The offset may be between CR and
  // LF of a line end.
  void goToLineFrom(std::uint64_t offset)
  {
    this->Input.beginBinary();
    if (offset > this->Input.offset())
    {
      this->Input.skip(offset - 1 - this->Input.offset());
      this->Lines.next();
      this->Lines.finish();
    }
  }

  // Read the numbers of a line into Row. Return false if the line is not a point.
  bool readPoint(std::string_view line)
  {
    if (this->Layout.DecimalComma)
    {
      this->Text = line;
      std::replace(this->Text.begin(), this->Text.end(), ',', '.');
      line = this->Text;
    }
    const char delimiter = this->Layout.Delimiter;
    const char* c = line.data();
    const char* const end = c + line.size();
    const auto skipBlanks = [&]()
    {
      while (c != end && isBlank(*c))
      {
        ++c;
      }
    };
    bool isFirst = true;
    for (double& value : this->Row)
    {
      skipBlanks();
      if (delimiter != ' ' && !isFirst)
      {
        if (c == end || *c != delimiter)
        {
          return false;
        }
        ++c;
        skipBlanks();
      }
      const std::size_t length =
        readNumber({ c, static_cast<std::size_t>(end - c) }, value, delimiter);
      if (length == 0)
      {
        return false;
      }
      c += length;
      isFirst = false;
    }
    skipBlanks();
    if (delimiter != ' ' && c != end && *c == delimiter) // delimiter after the last word
    {
      ++c;
      skipBlanks();
    }
    return c == end;
  }

  void append()
  {
    if (this->Layout.HasCount && this->PointsToCome-- == 0)
    {
      this->Input.fail(
        ParseCode::Malformed, "found one more point than the count before the points");
    }
    bool isFinite = true;
    for (std::size_t i = 0; i < this->Row.size(); ++i)
    {
      isFinite = isFinite && (this->Layout.Columns[i].Array > 0 || std::isfinite(this->Row[i]));
    }
    if (!isFinite)
    {
      ++this->Data.DroppedPoints;
      return;
    }
    for (NamedArray& array : this->Layout.Arrays)
    {
      array.Values.extend(array.tupleBytes());
    }
    for (std::size_t i = 0; i < this->Row.size(); ++i)
    {
      const TextCloudLayout::Column column = this->Layout.Columns[i];
      NamedArray& array = this->Layout.Arrays[column.Array];
      unsigned char* tuple = array.Values.data() + array.Values.size() - array.tupleBytes();
      if (array.Type == ScalarType::Float64)
      {
        std::memcpy(tuple + column.Component * sizeof(double), &this->Row[i], sizeof(double));
        continue;
      }
      tuple[column.Component] = this->byteOf(this->Row[i]);
    }
  }

  unsigned char byteOf(double color)
  {
    const double full = this->Layout.FullColor;
    if (!isColor(color, full))
    {
      this->Lines.failExpecting(std::string("colors as ") +
        (full > 1.0 ? "integers" : "fractions") + " in 0.." +
        std::to_string(static_cast<int>(full)) + " as in the lines before");
    }
    return static_cast<unsigned char>(std::floor(color * (255.0 / full) + 0.5));
  }

  void readCount(std::string_view line)
  {
    LineWords words(line);
    std::uint64_t count = 0;
    if (!words.next(count) || !words.next().empty())
    {
      this->Lines.failExpecting("the number of points that follow");
    }
    constexpr std::size_t minimumBytes = 5; // "0 0 0" at the end of a file
    this->PointsToCome =
      this->Limits.checkedCount(this->Input, "points", count, minimumBytes, 3 * sizeof(double));
  }

  void refuseLine(std::string_view line)
  {
    if (this->Options.SkipMalformedLines)
    {
      ++this->Data.SkippedLines;
      this->PointsToCome -= this->PointsToCome > 0 ? 1 : 0; // the count includes the line
      return;
    }
    const bool mayBeDecimal = !this->Layout.DecimalComma &&
      line.find(',') != std::string_view::npos && line.find('.') == std::string_view::npos;
    this->Input.fail(ParseCode::Malformed,
      describeNoPoint(line, this->Layout) +
        (mayBeDecimal ? "; if the commas are decimal marks, set DecimalComma" : ""));
  }

  ByteReader& Input;
  const TextCloudOptions& Options;
  const ParseLimits& Limits;
  SurfaceData& Data;
  LineReader Lines;
  ProgressReport Progress;
  TextCloudLayout Layout;
  std::vector<double> Row;
  std::string Text;
  std::uint64_t PointsToCome = 0;
  std::uint64_t Begin = 0, End = 0; ///< range of bytes of the piece
};
}

//------------------------------------------------------------------------------
SurfaceResult parseTextCloud(
  ByteReader& input, const TextCloudOptions& options, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { TextCloudReader(input, options, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikeTextCloud(std::string_view start)
{
  try
  {
    return findTextCloudLayout(start, false, false).AllLinesFit;
  }
  catch (const NoTextCloud&)
  {
    return false;
  }
}
}
