#include "TIFF/TIFFDirectory.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace conformal
{
namespace
{
// Numbers of the types of TIFF: bytes of one number, or 0 for a type that is skipped.
int bytesOfType(std::uint16_t type)
{
  switch (type)
  {
    case 1: // BYTE
    case 2: // ASCII
      return 1;
    case 3: // SHORT
      return 2;
    case 4: // LONG
      return 4;
    case 5:  // RATIONAL: two LONG
    case 16: // LONG8 of BigTIFF
      return 8;
    default:
      return 0;
  }
}

bool isRead(std::uint16_t tag)
{
  for (const TIFFTag known : { TIFFTag::Width, TIFFTag::Height, TIFFTag::BitsPerSample,
         TIFFTag::Compression, TIFFTag::Description, TIFFTag::StripOffsets, TIFFTag::Orientation,
         TIFFTag::SamplesPerPixel, TIFFTag::RowsPerStrip, TIFFTag::StripByteCounts,
         TIFFTag::XResolution, TIFFTag::YResolution, TIFFTag::PlanarConfiguration,
         TIFFTag::ResolutionUnit, TIFFTag::Predictor, TIFFTag::TileWidth, TIFFTag::SampleFormat })
  {
    if (tag == static_cast<std::uint16_t>(known))
    {
      return true;
    }
  }
  return false;
}

// Whether a tag describes the whole stack, so that only that of the first page is used.
bool isOfStack(TIFFTag tag)
{
  return tag == TIFFTag::Description || tag == TIFFTag::XResolution || tag == TIFFTag::YResolution;
}

bool isArray(TIFFTag tag)
{
  return tag == TIFFTag::StripOffsets || tag == TIFFTag::StripByteCounts;
}
}

//------------------------------------------------------------------------------
int TIFFDirectory::whole(TIFFTag tag, int otherwise) const
{
  const double value = this->number(tag, otherwise);
  return static_cast<int>(std::min(value, double(std::numeric_limits<int>::max())));
}

//------------------------------------------------------------------------------
double TIFFDirectory::number(TIFFTag tag, double otherwise) const
{
  const auto found = this->Numbers.find(tag);
  return found == this->Numbers.end() || found->second.empty() ? otherwise : found->second.front();
}

//------------------------------------------------------------------------------
TIFFFile::TIFFFile(OpenInput open, const ParseLimits& limits)
  : Open(std::move(open))
  , Limits(limits)
{
  this->seek(0);
  this->Input.requireBytes();
  const std::string_view start = this->Input.peek(4);
  if (!looksLikeTIFF(start))
  {
    this->Input.fail(ParseCode::UnrecognizedType, "found no TIFF file");
  }
  this->IsBig = start[0] == 'M';
  this->HasLongOffsets = (this->IsBig ? start[3] : start[2]) == 43;
  this->seek(4);
  if (this->HasLongOffsets)
  {
    constexpr std::uint64_t bytesOfOffsets = 8;
    if (this->number(2) != bytesOfOffsets || this->number(2) != 0)
    {
      this->Input.fail(ParseCode::Malformed, "found a BigTIFF file with offsets of another size");
    }
  }
  this->First = this->number(this->HasLongOffsets ? 8 : 4);
}

//------------------------------------------------------------------------------
void TIFFFile::seek(std::uint64_t offset)
{
  if (this->Input.size() > 0 && this->Input.seek(offset))
  {
    return;
  }
  if (this->Input.size() == 0 || offset < this->Input.offset())
  {
    ByteReader fresh;
    const ParseStatus status = this->Open(fresh);
    if (!status.ok())
    {
      throw ParseError(status);
    }
    this->Input = std::move(fresh);
    this->Input.beginBinary();
  }
  if (!this->Input.skip(offset - this->Input.offset()))
  {
    this->Input.fail(ParseCode::PrematureEnd,
      "the file ends before byte " + std::to_string(offset) + ", to which it refers");
  }
}

//------------------------------------------------------------------------------
std::uint64_t TIFFFile::number(int bytes)
{
  BinaryValues values(this->Input, this->IsBig == isLittleEndianMachine());
  switch (bytes)
  {
    case 1:
      return values.next<std::uint8_t>();
    case 2:
      return values.next<std::uint16_t>();
    case 4:
      return values.next<std::uint32_t>();
    default:
      return values.next<std::uint64_t>();
  }
}

//------------------------------------------------------------------------------
std::vector<TIFFDirectory> TIFFFile::directories(const Run& run)
{
  constexpr std::size_t pagesPerReport = 256;
  std::vector<TIFFDirectory> all;
  std::set<std::uint64_t> visited;
  for (std::uint64_t next = this->First; next != 0;)
  {
    if (!visited.insert(next).second)
    {
      this->Input.fail(ParseCode::Malformed, "the pages of the file refer to each other in a loop");
    }
    all.push_back(this->directory(next));
    if (all.size() % pagesPerReport == 0)
    {
      run.report(
        double(std::min(this->BytesOfTags, this->Input.size())) / double(this->Input.size()));
    }
  }
  if (all.empty())
  {
    this->Input.fail(ParseCode::Malformed, "the file has no page");
  }
  return all;
}

//------------------------------------------------------------------------------
void TIFFFile::count(std::uint64_t records, std::uint64_t bytes)
{
  const std::uint64_t left = this->Input.size() - std::min(this->Input.size(), this->BytesOfTags);
  if (records > left / bytes)
  {
    this->Input.fail(ParseCode::Malformed, "the tags of the pages exceed the size of the file");
  }
  this->BytesOfTags += records * bytes;
}

//------------------------------------------------------------------------------
TIFFDirectory TIFFFile::directory(std::uint64_t& next)
{
  struct Entry
  {
    std::uint16_t Tag, Type;
    std::uint64_t Count, Offset;
  };
  TIFFDirectory result;
  result.Offset = next;
  this->seek(next);
  const int wide = this->HasLongOffsets ? 8 : 4;
  const std::uint64_t size = this->number(this->HasLongOffsets ? 8 : 2);
  const std::uint64_t begin = this->Input.offset(), entryBytes = 4 + 2 * wide;
  this->Limits.checkedCount(this->Input, "tags", size, entryBytes, sizeof(Entry));
  this->count(size, entryBytes);
  std::vector<Entry> entries;
  std::set<std::uint16_t> known;
  for (std::uint64_t i = 0; i < size; ++i)
  {
    this->seek(begin + i * entryBytes);
    Entry entry;
    entry.Tag = static_cast<std::uint16_t>(this->number(2));
    entry.Type = static_cast<std::uint16_t>(this->number(2));
    entry.Count = this->number(wide);
    entry.Offset = this->Input.offset();
    const auto bytes = static_cast<std::uint64_t>(bytesOfType(entry.Type));
    if (bytes == 0 || !isRead(entry.Tag) || entry.Count == 0)
    {
      continue;
    }
    if (!known.insert(entry.Tag).second)
    {
      this->Input.fail(
        ParseCode::Malformed, "found tag " + std::to_string(entry.Tag) + " twice in a page");
    }
    if (entry.Count > static_cast<std::uint64_t>(wide) / bytes)
    {
      entry.Offset = this->number(wide);
    }
    entries.push_back(entry);
  }
  this->seek(begin + size * entryBytes);
  next = this->number(wide);
  for (const Entry& entry : entries)
  {
    this->readEntry(result, static_cast<TIFFTag>(entry.Tag), entry.Type, entry.Count, entry.Offset);
  }
  return result;
}

//------------------------------------------------------------------------------
void TIFFFile::readEntry(
  TIFFDirectory& result, TIFFTag tag, std::uint16_t type, std::uint64_t count, std::uint64_t offset)
{
  constexpr std::uint16_t text = 2, rational = 5;
  const bool isText = tag == TIFFTag::Description;
  if (isText != (type == text) || (isOfStack(tag) && result.Offset != this->First))
  {
    return;
  }
  if (isText || isArray(tag))
  {
    this->count(count, bytesOfType(type));
  }
  else
  {
    count = 1;
  }
  this->seek(offset);
  const int bytes = bytesOfType(type);
  this->Limits.checkedCount(
    this->Input, "numbers of a tag", count, static_cast<std::uint64_t>(bytes), sizeof(double));
  if (isText)
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      result.Description += static_cast<char>(this->number(1));
    }
    result.Description = result.Description.substr(0, result.Description.find('\0'));
    return;
  }
  std::vector<double>& numbers = result.Numbers[tag];
  numbers.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    auto value = static_cast<double>(this->number(type == rational ? 4 : bytes));
    if (type == rational)
    {
      const auto below = static_cast<double>(this->number(4));
      value = below > 0.0 ? value / below : 0.0;
    }
    numbers.push_back(value);
  }
}

//------------------------------------------------------------------------------
bool looksLikeTIFF(std::string_view start)
{
  const std::string_view magic = start.substr(0, 4);
  return magic == std::string_view("II\x2A\0", 4) || magic == std::string_view("MM\0\x2A", 4) ||
    magic == std::string_view("II\x2B\0", 4) || magic == std::string_view("MM\0\x2B", 4);
}
}
