#include "PLY/PLYHeader.h"

#include "Bytes/ParseLimits.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace conformal
{
namespace
{
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t SomeBytes = 4096;
constexpr std::size_t MaximumNames =
  100000; // names of elements and properties; more than in any real file

// Return the first words of a line. The maximum is one word more than any header line may have.
std::vector<std::string_view> wordsOf(std::string_view line)
{
  constexpr std::size_t maximum = 6;
  constexpr std::string_view blanks = " \t\v\f";
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(blanks);
  while (begin != std::string_view::npos && words.size() < maximum)
  {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

void skipByteOrderMark(std::string_view& start)
{
  if (start.substr(0, ByteOrderMark.size()) == ByteOrderMark)
  {
    start.remove_prefix(ByteOrderMark.size());
  }
}

bool startsWithPLY(std::string_view start)
{
  constexpr std::string_view magic = "ply";
  return start.substr(0, magic.size()) == magic &&
    (start.size() == magic.size() || std::string_view(" \t\r\n").find(start[3]) < 4);
}

std::optional<ScalarType> typeOf(std::string_view name)
{
  static const std::pair<std::string_view, ScalarType> names[] = {
    { "char", ScalarType::Int8 },
    { "int8", ScalarType::Int8 },
    { "uchar", ScalarType::UInt8 },
    { "uint8", ScalarType::UInt8 },
    { "short", ScalarType::Int16 },
    { "int16", ScalarType::Int16 },
    { "ushort", ScalarType::UInt16 },
    { "uint16", ScalarType::UInt16 },
    { "int", ScalarType::Int32 },
    { "int32", ScalarType::Int32 },
    { "uint", ScalarType::UInt32 },
    { "uint32", ScalarType::UInt32 },
    { "float", ScalarType::Float32 },
    { "float32", ScalarType::Float32 },
    { "double", ScalarType::Float64 },
    { "float64", ScalarType::Float64 },
  };
  for (const auto& entry : names)
  {
    if (entry.first == name)
    {
      return entry.second;
    }
  }
  return {};
}

class HeaderReader
{
public:
  explicit HeaderReader(ByteReader& input)
    : Input(input)
  {
  }

  PLYHeader read()
  {
    this->Input.requireBytes();
    std::string_view start = this->Input.peek(SomeBytes);
    const std::size_t whole = start.size();
    skipByteOrderMark(start);
    if (!startsWithPLY(start))
    {
      this->Input.fail(ParseCode::UnrecognizedType,
        "found " + quoted(start.substr(0, start.find_first_of("\r\n"))) + ", expected \"ply\"");
    }
    this->Input.advance(whole - start.size());
    this->nextLine();
    this->expectWords(1, "nothing after \"ply\"");
    PLYHeader header;
    for (;;)
    {
      this->nextLine();
      if (this->Words.empty() || this->Words[0] == "comment")
      {
        continue;
      }
      if (this->Words[0] == "end_header")
      {
        this->expectWords(1, "nothing after end_header");
        this->check(this->HasFormat, "a line \"format\" before end_header");
        return header;
      }
      this->readKeyword(header);
    }
  }

private:
  void readKeyword(PLYHeader& header)
  {
    const std::string_view keyword = this->Words[0];
    if (keyword == "format")
    {
      this->readFormat(header);
    }
    else if (keyword == "obj_info")
    {
      this->readInfo(header);
    }
    else if (keyword == "element")
    {
      this->readElement(header);
    }
    else if (keyword == "property")
    {
      this->check(!header.Elements.empty(), "an element before its properties");
      this->readProperty(header.Elements.back());
    }
    else
    {
      this->check(false, "a keyword of a PLY header");
    }
  }

  void readFormat(PLYHeader& header)
  {
    this->check(!this->HasFormat, "one line \"format\" only");
    this->expectWords(3, "format NAME 1.0");
    this->check(this->Words[2] == "1.0", "version 1.0");
    const std::string_view name = this->Words[1];
    this->check(name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian",
      "ascii, binary_little_endian or binary_big_endian");
    header.Format = name == "ascii" ? PLYFormat::Ascii
      : name == "binary_big_endian" ? PLYFormat::BinaryBigEndian
                                    : PLYFormat::BinaryLittleEndian;
    this->HasFormat = true;
  }

  // Read a line "obj_info". The line is free text, except for the size of the grid of a scanner.
  void readInfo(PLYHeader& header)
  {
    if (this->Words.size() == 3 && this->Words[1] == "num_cols")
    {
      header.GridColumns = this->count();
    }
    else if (this->Words.size() == 3 && this->Words[1] == "num_rows")
    {
      header.GridRows = this->count();
    }
  }

  void readElement(PLYHeader& header)
  {
    this->expectWords(3, "element NAME COUNT");
    PLYElement element;
    element.Name = this->Words[1];
    element.Count = this->count();
    this->check(this->ElementNames.insert(element.Name).second, "an element's name once");
    this->check(++this->NumberOfNames <= MaximumNames, "fewer elements");
    this->PropertyNames.clear();
    header.Elements.push_back(std::move(element));
  }

  void readProperty(PLYElement& element)
  {
    PLYProperty property;
    property.IsList = this->Words.size() > 1 && this->Words[1] == "list";
    this->expectWords(property.IsList ? 5 : 3,
      property.IsList ? "property list COUNT_TYPE TYPE NAME" : "property TYPE NAME");
    if (property.IsList)
    {
      property.CountType = this->type(this->Words[2]);
      this->check(!isFloating(property.CountType), "an integer type for a list's length");
    }
    property.Type = this->type(this->Words[this->Words.size() - 2]);
    property.Name = this->Words.back();
    this->check(this->PropertyNames.insert(property.Name).second, "a property's name once");
    this->check(++this->NumberOfNames <= MaximumNames, "fewer properties");
    element.Properties.push_back(std::move(property));
  }

  // Parse the third word as a count.
  std::uint64_t count()
  {
    const std::string_view text = this->Words[2];
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    this->check(
      error == std::errc() && end == text.data() + text.size(), "a count, from 0 to 2^64 - 1");
    return value;
  }

  ScalarType type(std::string_view name)
  {
    const std::optional<ScalarType> type = typeOf(name);
    this->check(type.has_value(), "a type (char ... double, int8 ... float64)");
    return *type;
  }

  // Read the next line into Text and Words, without its line end. If a line ends with the input,
  // the line may be incomplete. This is permitted only for the last line of a header.
  void nextLine()
  {
    this->Text.clear();
    this->Offset = this->Input.offset();
    ++this->Line;
    for (;;)
    {
      const std::string_view window = this->Input.peek(SomeBytes);
      if (window.empty() && this->Text != "end_header")
      {
        this->fail(ParseCode::PrematureEnd, "the header has no end_header");
      }
      const std::size_t length = std::min(window.find_first_of("\r\n"), window.size());
      if (this->Text.size() + length > LongestLine)
      {
        this->fail(ParseCode::Malformed, tooLongMessage("a line"));
      }
      this->Text.append(window.substr(0, length));
      this->Input.advance(length);
      if (length < window.size() || window.empty())
      {
        break;
      }
    }
    this->takeLineEnd();
    this->Words = wordsOf(this->Text);
  }

  // If the first line ends with CR alone, all lines of the header do. An LF after the last line is
  // then binary data.
  void takeLineEnd()
  {
    const std::string_view end = this->Input.peek(2);
    const bool pair = end.substr(0, 2) == "\r\n";
    if (this->Line == 1)
    {
      this->LoneCR = !pair && end[0] == '\r';
    }
    this->Input.advance(std::min<std::size_t>(end.size(), pair && !this->LoneCR ? 2 : 1));
  }

  void expectWords(std::size_t count, const std::string& expected)
  {
    this->check(this->Words.size() == count, expected);
  }

  void check(bool isRight, const std::string& expected)
  {
    if (!isRight)
    {
      this->fail(ParseCode::Malformed, "found " + quoted(this->Text) + ", expected " + expected);
    }
  }

  [[noreturn]] void fail(ParseCode code, const std::string& message)
  {
    throw ParseError({ code, this->Line, this->Offset, message });
  }

  ByteReader& Input;
  std::string Text;
  std::vector<std::string_view> Words;
  std::uint64_t Line = 0; ///< counted here, since ByteReader::line() at every line is slow
  std::uint64_t Offset = 0;
  bool LoneCR = false;
  bool HasFormat = false;
  std::size_t NumberOfNames = 0;
  std::set<std::string> ElementNames;
  std::set<std::string> PropertyNames;
};
}

//------------------------------------------------------------------------------
bool PLYElement::hasLists() const
{
  return std::any_of(this->Properties.begin(), this->Properties.end(),
    [](const PLYProperty& property) { return property.IsList; });
}

//------------------------------------------------------------------------------
bool looksLikePLY(std::string_view start)
{
  skipByteOrderMark(start);
  const std::size_t lineEnd = start.find_first_of("\r\n");
  if (!startsWithPLY(start) || lineEnd == std::string_view::npos)
  {
    return false;
  }
  start.remove_prefix(std::min(start.find_first_not_of("\r\n", lineEnd), start.size()));
  const auto words = wordsOf(start.substr(0, start.find_first_of("\r\n")));
  return !words.empty() &&
    (words[0] == "format" || words[0] == "comment" || words[0] == "obj_info");
}

//------------------------------------------------------------------------------
PLYHeader readPLYHeader(ByteReader& input)
{
  return HeaderReader(input).read();
}
}
