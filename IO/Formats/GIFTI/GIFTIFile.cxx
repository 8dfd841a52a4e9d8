#include "GIFTI/GIFTIFile.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/NumberText.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/ProgressReport.h"
#include "GIFTI/BinaryText.h"
#include "Text/XMLParser.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace conformal
{
namespace
{
constexpr std::size_t MaximumArrays = 10000; // more than any real file has

void require(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw GIFTIError(message);
  }
}

ScalarType typeOf(std::string_view name)
{
  static const std::pair<std::string_view, ScalarType> types[] = {
    { "NIFTI_TYPE_UINT8", ScalarType::UInt8 }, { "NIFTI_TYPE_INT8", ScalarType::Int8 },
    { "NIFTI_TYPE_UINT16", ScalarType::UInt16 }, { "NIFTI_TYPE_INT16", ScalarType::Int16 },
    { "NIFTI_TYPE_UINT32", ScalarType::UInt32 }, { "NIFTI_TYPE_INT32", ScalarType::Int32 },
    { "NIFTI_TYPE_UINT64", ScalarType::UInt64 }, { "NIFTI_TYPE_INT64", ScalarType::Int64 },
    { "NIFTI_TYPE_FLOAT32", ScalarType::Float32 }, { "NIFTI_TYPE_FLOAT64", ScalarType::Float64 }
  };
  for (const auto& [known, type] : types)
  {
    if (name == known)
    {
      return type;
    }
  }
  throw GIFTIError("found DataType " + quoted(name) + ", expected a number of 1 to 8 bytes");
}

// Parse numbers from text that is added in pieces. A piece may end within a number.
class TextDecoder
{
public:
  TextDecoder(NamedArray& array, std::size_t expected)
    : Array(array)
    , Expected(expected)
  {
  }

  void add(std::string_view text)
  {
    constexpr std::size_t longestNumber = 4096;
    for (const char c : text)
    {
      if (isBlank(c))
      {
        this->endWord();
      }
      else
      {
        require(this->Word.size() < longestNumber, "found a word that is not a number");
        this->Word += c;
      }
    }
  }

  void endWord()
  {
    if (this->Word.empty())
    {
      return;
    }
    require(this->Count++ < this->Expected, "found more numbers than the dimensions require");
    withType(this->Array.Type,
      [&](auto zero)
      {
        auto value = zero;
        require(readNumber(this->Word, value) == this->Word.size(),
          "found " + quoted(this->Word) + ", expected a number of the array's type");
        this->Array.Values.extend(sizeof(value));
        std::memcpy(this->Array.Values.data() + this->Array.Values.size() - sizeof(value), &value,
          sizeof(value));
      });
    this->Word.clear();
  }

private:
  NamedArray& Array;
  const std::size_t Expected;
  std::string Word;
  std::size_t Count = 0;
};

void swapBytes(NamedArray& array)
{
  const std::size_t bytes = sizeOf(array.Type);
  for (std::size_t i = 0; i < array.Values.size(); i += bytes)
  {
    std::reverse(array.Values.data() + i, array.Values.data() + i + bytes);
  }
}

// Reorder numbers from column-major to row-major.
void transpose(NamedArray& array)
{
  const std::size_t bytes = sizeOf(array.Type);
  const std::size_t tuples = array.numberOfTuples();
  OwnedArray<unsigned char> values;
  values.resize(array.Values.size());
  for (std::size_t i = 0; i < tuples; ++i)
  {
    for (std::size_t c = 0; c < array.Components; ++c)
    {
      std::memcpy(values.data() + (i * array.Components + c) * bytes,
        array.Values.data() + (c * tuples + i) * bytes, bytes);
    }
  }
  array.Values = std::move(values);
}

// Handle the elements of the file.
class GIFTIHandler
{
public:
  GIFTIHandler(std::uint64_t fileSize, const ParseLimits& limits)
    : FileSize(fileSize)
    , Limits(limits)
  {
  }

  void start(std::string_view name, const char** attributes)
  {
    this->Path.emplace_back(name);
    this->Text.clear();
    this->TextBytes = 0;
    require(this->Path.size() > 1 || name == "GIFTI", "expected the element GIFTI");
    require(this->Path.size() < 100, "found elements that are nested too deeply");
    if (this->Path.size() == 1)
    {
      this->readCount(attributes);
    }
    else if (name == "DataArray")
    {
      require(!this->IsInArray, "found a DataArray inside another DataArray");
      require(this->Arrays.size() < this->NumberOfArrays, this->wrongCountMessage("more"));
      this->IsInArray = true;
      this->startArray(attributes);
    }
    else if (name == "Data" && this->IsInArray)
    {
      require(!this->HasData, "found a DataArray with two Data elements");
      this->HasData = true;
      this->startData();
    }
  }

  void text(std::string_view text)
  {
    if (this->Binary)
    {
      this->Binary->add(text);
    }
    else if (this->Ascii)
    {
      this->Ascii->add(text);
    }
    else
    {
      constexpr std::size_t longest = 1000; // maximum length of a name
      this->Text.append(text.substr(0, longest - std::min(longest, this->Text.size())));
      this->TextBytes += text.size();
      require(this->TextBytes <= LongestLine, tooLongMessage("text outside of a Data element"));
    }
  }

  void end(std::string_view name)
  {
    this->Path.pop_back();
    this->TextBytes = 0;
    const bool isOfArray = this->IsInArray && !this->Path.empty() && this->Path.back() == "MD";
    if (name == "Name" && isOfArray)
    {
      this->MetaName = this->Text;
    }
    else if (name == "Value" && isOfArray && this->MetaName == "Name")
    {
      this->Arrays.back().Values.Name = this->Text;
    }
    else if (name == "Data" && this->IsInArray)
    {
      this->endData();
    }
    else if (name == "DataArray")
    {
      require(this->HasData, "found a DataArray without Data");
      this->IsInArray = this->HasData = false;
    }
    else if (this->Path.empty())
    {
      require(this->Arrays.size() == this->NumberOfArrays, this->wrongCountMessage("fewer"));
    }
  }

  std::vector<GIFTIArray> take() { return std::move(this->Arrays); }

private:
  using Sizes = std::array<std::optional<std::uint64_t>, 6>;

  // Version 1.0 of the format requires the number of arrays. Without this number, a missing array
  // would not be detected.
  void readCount(const char** attributes)
  {
    std::string_view text;
    for (; *attributes; attributes += 2)
    {
      text = std::string_view(attributes[0]) == "NumberOfDataArrays" ? attributes[1] : text;
    }
    require(readNumber(text, this->NumberOfArrays) == text.size() && !text.empty() &&
        this->NumberOfArrays <= MaximumArrays,
      "found NumberOfDataArrays " + quoted(text) + " of GIFTI, expected a count of up to " +
        std::to_string(MaximumArrays));
  }

  std::string wrongCountMessage(const std::string& amount) const
  {
    return "found " + amount + " DataArrays than the " + std::to_string(this->NumberOfArrays) +
      " of NumberOfDataArrays";
  }

  void startArray(const char** attributes)
  {
    std::size_t dimensions = 0;
    Sizes sizes;
    GIFTIArray array;
    this->Encoding.clear();
    this->IsLittleEndian = isLittleEndianMachine();
    this->IsColumnMajor = false;
    bool hasType = false;
    for (; *attributes; attributes += 2)
    {
      const std::string_view name = attributes[0];
      const std::string_view value = attributes[1];
      if (name == "Intent")
      {
        constexpr std::string_view prefix = "NIFTI_INTENT_";
        array.Intent =
          value.substr(value.substr(0, prefix.size()) == prefix ? prefix.size() : 0, 100);
      }
      else if (name == "DataType")
      {
        array.Values.Type = typeOf(value);
        hasType = true;
      }
      else if (name == "Encoding")
      {
        this->Encoding = value;
      }
      else if (name == "Endian")
      {
        require(value == "LittleEndian" || value == "BigEndian",
          "found Endian " + quoted(value) + ", expected LittleEndian or BigEndian");
        this->IsLittleEndian = value == "LittleEndian";
      }
      else if (name == "ArrayIndexingOrder")
      {
        require(value == "RowMajorOrder" || value == "ColumnMajorOrder",
          "found ArrayIndexingOrder " + quoted(value) +
            ", expected RowMajorOrder or ColumnMajorOrder");
        this->IsColumnMajor = value == "ColumnMajorOrder";
      }
      else if (name == "Dimensionality")
      {
        require(readNumber(value, dimensions) == value.size() && dimensions >= 1 && dimensions <= 6,
          "found Dimensionality " + quoted(value) + ", expected 1 to 6");
      }
      else if (name.substr(0, 3) == "Dim")
      {
        std::uint64_t size = 0;
        require(readNumber(value, size) == value.size(),
          "found " + std::string(name) + " " + quoted(value) + ", expected a count");
        const std::size_t index = name.size() == 4 ? static_cast<std::size_t>(name[3] - '0') : 6;
        require(index < sizes.size(), "found " + quoted(name) + ", expected Dim0 to Dim5");
        sizes[index] = size;
      }
    }
    require(hasType, "expected a DataType");
    require(dimensions > 0, "expected a Dimensionality");
    this->setSize(array.Values, sizes, dimensions);
    this->Arrays.push_back(std::move(array));
  }

  // Maximum number of bytes to which zlib decompresses one byte.
  static constexpr std::uint64_t MaximumGrowth = 1032;

  void setSize(NamedArray& values, const Sizes& sizes, std::size_t dimensions)
  {
    const std::uint64_t maximum =
      std::min(MaximumGrowth * this->FileSize, this->Limits.MaximumMemory);
    this->NumberOfValues = 1;
    for (std::size_t i = 0; i < dimensions; ++i)
    {
      require(sizes[i].has_value(), "expected a size for each dimension");
      require(*sizes[i] == 0 || this->NumberOfValues <= maximum / *sizes[i],
        "found dimensions with more values than the file can contain");
      this->NumberOfValues *= *sizes[i];
    }
    require(this->NumberOfValues * sizeOf(values.Type) <= maximum,
      "found dimensions with more values than the file can contain");
    values.Components = *sizes[0] > 0 ? this->NumberOfValues / *sizes[0] : 1;
    require(values.Components > 0, "found a dimension of size 0 after another");
    require(values.Components <= 100000, "found tuples of more than 100000 numbers");
  }

  void startData()
  {
    NamedArray& values = this->Arrays.back().Values;
    const std::size_t bytes = this->NumberOfValues * sizeOf(values.Type);
    if (this->Encoding == "ASCII")
    {
      this->Ascii.emplace(values, this->NumberOfValues);
    }
    else
    {
      require(this->Encoding != "ExternalFileBinary",
        "found a DataArray whose data are in another file, which is not read");
      const bool isCompressed = this->Encoding == "GZipBase64Binary";
      require(isCompressed || this->Encoding == "Base64Binary",
        "found Encoding " + quoted(this->Encoding) +
          ", expected ASCII, Base64Binary or GZipBase64Binary");
      this->Binary = std::make_unique<BinaryTextDecoder>(bytes, isCompressed);
    }
  }

  void endData()
  {
    NamedArray& values = this->Arrays.back().Values;
    if (this->Binary)
    {
      values.Values = this->Binary->take();
      this->Binary.reset();
      if (this->IsLittleEndian != isLittleEndianMachine())
      {
        swapBytes(values);
      }
    }
    else
    {
      this->Ascii->endWord();
      this->Ascii.reset();
      require(values.Values.size() == this->NumberOfValues * sizeOf(values.Type),
        "found fewer numbers than the " + std::to_string(this->NumberOfValues) +
          " of the dimensions");
    }
    if (this->IsColumnMajor && values.Components > 1)
    {
      transpose(values);
    }
  }

  const std::uint64_t FileSize;
  const ParseLimits& Limits;
  std::vector<GIFTIArray> Arrays;
  std::vector<std::string> Path;
  std::string Text; ///< text since the last tag, limited to its first bytes
  std::size_t TextBytes = 0;
  std::string MetaName;
  std::string Encoding;
  std::unique_ptr<BinaryTextDecoder> Binary;
  std::optional<TextDecoder> Ascii;
  std::uint64_t NumberOfArrays = 0;
  std::uint64_t NumberOfValues = 0; ///< number of values of the current array
  bool IsLittleEndian = true;
  bool IsColumnMajor = false;
  bool IsInArray = false;
  bool HasData = false;
};

// Parse the pieces of the file. Errors of the handler get the position in the file.
class GIFTIReader : private XMLHandler
{
public:
  GIFTIReader(ByteReader& input, const ParseLimits& limits, const Run& run)
    : Input(input)
    , Progress(input, run)
    , Handler(input.size(), limits)
    , Parser(*this)
  {
  }

  std::vector<GIFTIArray> read()
  {
    this->Input.requireBytes();
    constexpr std::size_t someBytes = 1024;
    if (!looksLikeGIFTI(this->Input.peek(someBytes)))
    {
      this->Input.fail(ParseCode::UnrecognizedType,
        "found " + quoted(this->Input.peek(1).substr(0, 20)) +
          ", expected the XML of a GIFTI file");
    }
    for (bool isLast = false; !isLast;)
    {
      const std::string_view piece = this->Input.peek(1);
      isLast = piece.size() == this->Input.left();
      const bool isValid = this->Parser.parse(piece, isLast);
      this->Progress.tick();
      if (!isValid)
      {
        const bool isEnd =
          this->Parser.endsEarly() || (isLast && this->Parser.offset() >= this->Input.size());
        this->fail(isEnd ? ParseCode::PrematureEnd : ParseCode::Malformed, this->Parser.message());
      }
      this->Input.advance(piece.size());
      if (this->Input.offset() > LongestLine + this->Parser.offset())
      {
        this->fail(ParseCode::Malformed, tooLongMessage("a tag"));
      }
    }
    return this->Handler.take();
  }

private:
  void start(const char* name, const char** attributes) override
  {
    this->call([&]() { this->Handler.start(name, attributes); });
  }

  void end(const char* name) override
  {
    this->call([&]() { this->Handler.end(name); });
  }

  void text(std::string_view part) override
  {
    this->call([&]() { this->Handler.text(part); });
  }

  void entity() override
  {
    this->call([]()
      { require(false, "found an entity that the file defines; such entities are not read"); });
  }

  template <typename Function>
  void call(Function function)
  {
    try
    {
      function();
    }
    catch (const GIFTIError& e)
    {
      this->fail(ParseCode::Malformed, e.what());
    }
  }

  [[noreturn]] void fail(ParseCode code, const std::string& message) const
  {
    throw ParseError({ code, this->Parser.line(), this->Parser.offset(), message });
  }

  ByteReader& Input;
  ProgressReport Progress;
  GIFTIHandler Handler;
  XMLParser Parser;
};
}

//------------------------------------------------------------------------------
bool looksLikeGIFTI(std::string_view start)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  start.remove_prefix(start.substr(0, mark.size()) == mark ? mark.size() : 0);
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  return start.substr(0, 1) == "<" && start.find("<GIFTI") != std::string_view::npos;
}

//------------------------------------------------------------------------------
std::vector<GIFTIArray> readGIFTIFile(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return GIFTIReader(input, limits, run).read();
}
}
