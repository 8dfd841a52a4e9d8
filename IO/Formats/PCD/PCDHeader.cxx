#include "PCD/PCDHeader.h"

#include "Bytes/LineReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace conformal
{
namespace
{
constexpr std::size_t MaximumNumbers = 100000; // numbers of a point; more than in any real file
constexpr std::string_view Keywords[] = { "VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT",
  "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA" };

std::optional<ScalarType> typeOf(char kind, std::size_t size)
{
  static const struct
  {
    char Kind;
    std::size_t Size;
    ScalarType Type;
  } types[] = { { 'I', 1, ScalarType::Int8 }, { 'I', 2, ScalarType::Int16 },
    { 'I', 4, ScalarType::Int32 }, { 'I', 8, ScalarType::Int64 }, { 'U', 1, ScalarType::UInt8 },
    { 'U', 2, ScalarType::UInt16 }, { 'U', 4, ScalarType::UInt32 }, { 'U', 8, ScalarType::UInt64 },
    { 'F', 4, ScalarType::Float32 }, { 'F', 8, ScalarType::Float64 } };
  for (const auto& entry : types)
  {
    if (entry.Kind == kind && entry.Size == size)
    {
      return entry.Type;
    }
  }
  return {};
}

class HeaderReader
{
public:
  explicit HeaderReader(ByteReader& input)
    : Input(input)
    , Lines(input)
  {
  }

  PCDHeader read()
  {
    while (this->Lines.next())
    {
      LineWords words(this->Lines.text());
      const std::string_view keyword = words.next();
      if (isIgnored(keyword))
      {
        continue;
      }
      this->readLine(keyword, words);
      if (keyword == "DATA")
      {
        this->finish();
        this->Lines.finish();
        return std::move(this->Header);
      }
    }
    this->Input.fail(ParseCode::PrematureEnd, "the header has no line DATA");
  }

private:
  void readLine(std::string_view keyword, LineWords words)
  {
    const auto place = std::find(std::begin(Keywords), std::end(Keywords), keyword);
    if (place == std::end(Keywords))
    {
      this->Input.fail(this->HasKeyword ? ParseCode::Malformed : ParseCode::UnrecognizedType,
        "found " + quoted(this->Lines.text()) + ", expected a keyword of a PCD header");
    }
    bool& isSeen = this->Seen[static_cast<std::size_t>(place - std::begin(Keywords))];
    this->check(!isSeen, "each keyword once");
    isSeen = this->HasKeyword = true;
    if (keyword == "VERSION")
    {
      double version = 0.0;
      this->check(words.next(version) && version >= 0.5 && version <= 0.7, "a version of .5 to .7");
    }
    else if (keyword == "FIELDS" || keyword == "COLUMNS")
    {
      this->readFields(words);
    }
    else if (keyword == "SIZE")
    {
      this->readNumbers(words, this->Sizes);
    }
    else if (keyword == "COUNT")
    {
      this->readNumbers(words, this->Counts);
    }
    else if (keyword == "TYPE")
    {
      for (std::string_view word = words.next(); !word.empty(); word = words.next())
      {
        this->check(word.size() == 1, "types I, U or F");
        this->Kinds += word[0];
      }
    }
    else if (keyword == "WIDTH" || keyword == "HEIGHT" || keyword == "POINTS")
    {
      std::uint64_t count = 0;
      this->check(words.next(count) && words.next().empty(), "a count, from 0 to 2^64 - 1");
      (keyword == "WIDTH"       ? this->Width
          : keyword == "HEIGHT" ? this->Height
                                : this->Points) = count;
    }
    else if (keyword == "VIEWPOINT")
    {
      this->readViewPoint(words);
    }
    else if (keyword == "DATA")
    {
      const std::string_view format = words.next();
      this->check(format == "ascii" || format == "binary" || format == "binary_compressed",
        "ascii, binary or binary_compressed");
      this->Header.Format = format == "ascii" ? PCDFormat::Ascii
        : format == "binary"                  ? PCDFormat::Binary
                                              : PCDFormat::BinaryCompressed;
    }
  }

  // Read the position. Files with words that are not numbers are read without it.
  void readViewPoint(LineWords& words)
  {
    std::vector<double> position(3);
    const auto isNumber = [&](double& x) { return words.next(x) && std::isfinite(x); };
    if (std::all_of(position.begin(), position.end(), isNumber))
    {
      this->Header.ScannerPosition = position;
    }
  }

  void readFields(LineWords& words)
  {
    this->check(this->Header.Fields.empty(), "the names of fields once");
    std::set<std::string_view> names;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
      this->check(this->Header.Fields.size() < MaximumNumbers, "fewer fields");
      if (word != PCDField::Padding && !names.insert(word).second)
      {
        this->Input.fail(ParseCode::Malformed,
          "found two fields " + quoted(word) +
            ", expected each name once (but for padding, \"_\")");
      }
      this->Header.Fields.emplace_back();
      this->Header.Fields.back().Name = word;
    }
  }

  void readNumbers(LineWords& words, std::vector<std::size_t>& numbers)
  {
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
      std::uint32_t number = 0;
      this->check(readNumber(word, number) == word.size() && number > 0, "numbers greater than 0");
      numbers.push_back(number);
    }
  }

  void finish()
  {
    auto& fields = this->Header.Fields;
    const auto checkSize = [&](std::size_t size, const char* keyword)
    {
      this->checkHeader(size == 0 || size == fields.size(),
        "as many words of " + std::string(keyword) + " as of FIELDS");
    };
    checkSize(this->Sizes.size(), "SIZE");
    checkSize(this->Kinds.size(), "TYPE");
    checkSize(this->Counts.size(), "COUNT");
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      const std::size_t size = this->Sizes.empty() ? sizeof(float) : this->Sizes[i];
      const std::optional<ScalarType> type =
        typeOf(this->Kinds.empty() ? 'F' : this->Kinds[i], size);
      this->checkHeader(type.has_value(), "types I and U of 1, 2, 4 or 8 bytes, F of 4 or 8");
      fields[i].Type = *type;
      fields[i].Count = this->Counts.empty() ? 1 : this->Counts[i];
      numbers += fields[i].Count;
      this->checkHeader(numbers <= MaximumNumbers,
        "no more than " + std::to_string(MaximumNumbers) + " numbers a point");
    }
    const bool hasSize = this->Width && this->Height;
    this->checkHeader(hasSize || this->Points.has_value(), "POINTS, or WIDTH and HEIGHT");
    const bool isTooLarge = hasSize && *this->Height > 0 &&
      *this->Width > std::numeric_limits<std::uint64_t>::max() / *this->Height;
    this->checkHeader(
      !isTooLarge && (!hasSize || !this->Points || *this->Points == *this->Width * *this->Height),
      "as many POINTS as WIDTH times HEIGHT");
    this->Header.NumberOfPoints = this->Points ? *this->Points : *this->Width * *this->Height;
    auto& scanner = this->Header.ScannerPosition;
    const auto isZero = [](double x) { return x == 0.0; };
    if (this->Height.value_or(1) <= 1 && std::all_of(scanner.begin(), scanner.end(), isZero))
    {
      scanner.clear();
    }
  }

  void check(bool isRight, const std::string& expected) const
  {
    if (!isRight)
    {
      this->Lines.failExpecting(expected);
    }
  }

  void checkHeader(bool isRight, const std::string& expected) const
  {
    if (!isRight)
    {
      this->Input.fail(ParseCode::Malformed, "the header is not valid: expected " + expected);
    }
  }

  ByteReader& Input;
  LineReader Lines;
  PCDHeader Header;
  std::array<bool, std::size(Keywords)> Seen = {};
  bool HasKeyword = false;
  std::vector<std::size_t> Sizes;
  std::vector<std::size_t> Counts;
  std::string Kinds;
  std::optional<std::uint64_t> Width;
  std::optional<std::uint64_t> Height;
  std::optional<std::uint64_t> Points;
};
}

//------------------------------------------------------------------------------
bool looksLikePCD(std::string_view start)
{
  ByteReader input(start);
  LineReader lines(input);
  while (lines.next())
  {
    LineWords words(lines.text());
    const std::string_view keyword = words.next();
    if (keyword == "VERSION")
    {
      double version = 0.0;
      return words.next(version) && version >= 0.5 && version <= 0.7;
    }
    if (!isIgnored(keyword))
    {
      const bool isFields = keyword == "FIELDS" || keyword == "COLUMNS";
      return isFields && !words.next().empty();
    }
  }
  return false;
}

//------------------------------------------------------------------------------
PCDHeader readPCDHeader(ByteReader& input)
{
  input.requireBytes();
  return HeaderReader(input).read();
}
}
