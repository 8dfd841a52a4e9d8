#include "E57/E57Description.h"

#include "Bytes/NumberText.h"
#include "Bytes/ParseLimits.h"
#include "Text/XMLParser.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

namespace conformal
{
namespace
{
constexpr std::size_t MaximumScans = 10000; // more than any real file has
constexpr std::size_t MaximumFields = 1000;
constexpr std::size_t MaximumDepth = 100;
constexpr std::size_t LongestNumber = 1000;

void requireOfXML(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw std::invalid_argument(message);
  }
}

template <typename T>
T numberOf(std::string_view name, std::string_view text)
{
  T value = T();
  requireOfXML(!text.empty() && readNumber(text, value) == text.size() &&
      std::isfinite(static_cast<double>(value)),
    "found " + std::string(name) + " " + quoted(text) + ", expected a number");
  return value;
}

std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && isBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

// Attributes of an element.
class Attributes
{
public:
  explicit Attributes(const char** attributes)
    : First(attributes)
  {
  }

  std::string_view find(std::string_view name) const
  {
    for (const char** a = this->First; *a; a += 2)
    {
      if (name == *a)
      {
        return a[1];
      }
    }
    return {};
  }

  template <typename T>
  void read(const char* name, T& value) const
  {
    const std::string_view text = this->find(name);
    if (!text.empty())
    {
      value = numberOf<T>(name, text);
    }
  }

private:
  const char** First;
};

// Handle the elements of the XML.
class DescriptionHandler
{
public:
  void start(std::string_view name, const char** list)
  {
    this->Path.emplace_back(name);
    this->Text.clear();
    requireOfXML(this->Path.size() <= MaximumDepth, "found elements that are nested too deeply");
    requireOfXML(this->Path.size() > 1 || name == "e57Root", "expected the element e57Root");
    const Attributes attributes(list);
    if (!this->isInScan())
    {
      return;
    }
    if (this->Path.size() == ScanDepth)
    {
      requireOfXML(this->Scans.size() < MaximumScans,
        "found more than " + std::to_string(MaximumScans) + " scans");
      this->Scans.emplace_back();
      this->Names.clear();
    }
    else if (this->Path.size() == ScanDepth + 1 && name == "points")
    {
      this->startPoints(attributes);
    }
    else if (this->Path.size() > ScanDepth + 2 && this->Path[ScanDepth] == "points" &&
      this->Path[ScanDepth + 1] == "prototype")
    {
      this->startField(attributes);
    }
  }

  void text(std::string_view text)
  {
    this->Text.append(text.substr(0, LongestNumber - std::min(LongestNumber, this->Text.size())));
  }

  void end()
  {
    if (this->isInScan() && this->Path.size() > ScanDepth + 1)
    {
      this->endNumber();
    }
    this->Path.pop_back();
    this->Text.clear();
  }

  std::vector<E57Scan> take()
  {
    for (const E57Scan& scan : this->Scans)
    {
      double square = 0.0;
      for (const double part : scan.Rotation)
      {
        square += part * part;
      }
      requireOfXML(square > 0.0 && std::isfinite(square),
        "found the rotation of a pose that is no quaternion");
    }
    return std::move(this->Scans);
  }

private:
  static constexpr std::size_t ScanDepth = 3; // e57Root, data3D, vectorChild

  bool isInScan() const
  {
    return this->Path.size() >= ScanDepth && this->Path[1] == "data3D" &&
      this->Path[2] == "vectorChild";
  }

  void startPoints(const Attributes& attributes)
  {
    requireOfXML(attributes.find("type") == "CompressedVector",
      "found points of type " + quoted(attributes.find("type")) + ", expected CompressedVector");
    requireOfXML(this->Scans.back().Section == 0, "found a scan with two elements points");
    attributes.read("fileOffset", this->Scans.back().Section);
    attributes.read("recordCount", this->Scans.back().NumberOfPoints);
    requireOfXML(this->Scans.back().Section > 0, "expected the fileOffset of points");
  }

  void startField(const Attributes& attributes)
  {
    const std::string_view type = attributes.find("type");
    if (type == "Structure" || type == "Vector")
    {
      return; // its fields follow
    }
    E57Field field;
    for (std::size_t i = ScanDepth + 2; i < this->Path.size(); ++i)
    {
      field.Name += (field.Name.empty() ? "" : "/") + this->Path[i];
    }
    field.Kind = kindOf(type, attributes.find("precision"));
    if (field.isInteger())
    {
      attributes.read("minimum", field.Minimum);
      attributes.read("maximum", field.Maximum);
      attributes.read("scale", field.Scale);
      attributes.read("offset", field.Offset);
      requireOfXML(field.Minimum <= field.Maximum,
        "found the field " + quoted(field.Name) + " with a minimum above the maximum");
    }
    auto& fields = this->Scans.back().Fields;
    requireOfXML(fields.size() < MaximumFields,
      "found a scan with more than " + std::to_string(MaximumFields) + " fields");
    requireOfXML(this->Names.insert(field.Name).second,
      "found two fields " + quoted(field.Name) + ", expected each name once");
    fields.push_back(std::move(field));
  }

  static E57Kind kindOf(std::string_view type, std::string_view precision)
  {
    if (type == "Float")
    {
      requireOfXML(precision.empty() || precision == "single" || precision == "double",
        "found precision " + quoted(precision) + ", expected single or double");
      return precision == "single" ? E57Kind::Float32 : E57Kind::Float64;
    }
    requireOfXML(type == "Integer" || type == "ScaledInteger" || type == "String",
      "found a field of type " + quoted(type) +
        ", expected Integer, ScaledInteger, Float or String");
    return type == "Integer" ? E57Kind::Integer
      : type == "String"     ? E57Kind::Text
                             : E57Kind::ScaledInteger;
  }

  // Read the number in the element that ends, if it is one of the pose or the limits of colors. An
  // empty element is the number 0.
  void endNumber()
  {
    const std::string& name = this->Path.back();
    const auto isAt = [&](std::initializer_list<std::string_view> parts)
    {
      return this->Path.size() == ScanDepth + parts.size() + 1 &&
        std::equal(parts.begin(), parts.end(), this->Path.begin() + ScanDepth);
    };
    const auto number = [&]()
    {
      const std::string_view text = trimmed(this->Text);
      return text.empty() ? 0.0 : numberOf<double>(name, text);
    };
    constexpr std::string_view axes = "wxyz";
    const std::size_t axis = name.size() == 1 ? axes.find(name[0]) : axes.npos;
    E57Scan& scan = this->Scans.back();
    if (isAt({ "colorLimits" }))
    {
      if (scan.ColorLimits.size() < MaximumFields)
      {
        scan.ColorLimits[name] = number();
      }
    }
    else if (axis < axes.size() && isAt({ "pose", "rotation" }))
    {
      scan.Rotation[axis] = number();
    }
    else if (axis < axes.size() && axis > 0 && isAt({ "pose", "translation" }))
    {
      scan.Translation[axis - 1] = number();
    }
  }

  std::vector<E57Scan> Scans;
  std::vector<std::string> Path;
  std::string Text;            ///< text since the last tag, limited to its first bytes
  std::set<std::string> Names; ///< of the fields of the last scan
};

// Parse the XML in pieces.
class DescriptionReader : private XMLHandler
{
public:
  explicit DescriptionReader(E57Pages& pages)
    : Pages(pages)
    , Parser(*this)
  {
  }

  std::vector<E57Scan> read()
  {
    constexpr std::size_t pieceBytes = 1 << 16;
    std::vector<char> piece(pieceBytes);
    this->Pages.seek(this->Pages.xmlOffset());
    for (std::uint64_t left = this->Pages.xmlBytes(); left > 0;)
    {
      const auto bytes = static_cast<std::size_t>(std::min<std::uint64_t>(left, pieceBytes));
      this->Pages.read(piece.data(), bytes);
      left -= bytes;
      this->BytesSinceTag += bytes;
      this->parse({ piece.data(), bytes }, left == 0);
    }
    if (this->Pages.xmlBytes() == 0)
    {
      this->Pages.fail(ParseCode::Malformed, "the file has no XML");
    }
    try
    {
      return this->Handler.take();
    }
    catch (const std::invalid_argument& e)
    {
      this->Pages.fail(ParseCode::Malformed, e.what());
    }
  }

private:
  void start(const char* name, const char** attributes) override
  {
    this->BytesSinceTag = 0;
    this->Handler.start(name, attributes);
  }

  void end(const char*) override
  {
    this->BytesSinceTag = 0;
    this->Handler.end();
  }

  void text(std::string_view part) override
  {
    this->BytesSinceTag = 0;
    this->Handler.text(part);
  }

  void entity() override
  {
    requireOfXML(false, "found an entity that the XML defines, which is not read");
  }

  void parse(std::string_view piece, bool isLast)
  {
    bool isValid = false;
    try
    {
      isValid = this->Parser.parse(piece, isLast);
    }
    catch (const std::invalid_argument& e)
    {
      this->Pages.fail(ParseCode::Malformed, e.what());
    }
    if (!isValid)
    {
      this->Pages.fail(ParseCode::Malformed, this->Parser.message());
    }
    if (this->BytesSinceTag > LongestLine)
    {
      this->Pages.fail(ParseCode::Malformed, tooLongMessage("a tag"));
    }
  }

  E57Pages& Pages;
  DescriptionHandler Handler;
  XMLParser Parser;
  std::size_t BytesSinceTag = 0;
};
}

//------------------------------------------------------------------------------
std::size_t E57Field::bits() const
{
  switch (this->Kind)
  {
    case E57Kind::Float32:
      return 32;
    case E57Kind::Float64:
      return 64;
    case E57Kind::Text:
      return 8;
    default:
      break;
  }
  std::size_t bits = 0;
  for (std::uint64_t range = this->range(); range > 0; range >>= 1)
  {
    ++bits;
  }
  return bits;
}

//------------------------------------------------------------------------------
const E57Field* E57Scan::find(const std::string& name) const
{
  const auto found = std::find_if(this->Fields.begin(), this->Fields.end(),
    [&](const E57Field& field) { return field.Name == name; });
  return found == this->Fields.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::vector<E57Scan> readE57Description(E57Pages& pages)
{
  return DescriptionReader(pages).read();
}
}
