#include "TIFF/TIFFStackParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/NumberText.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace conformal
{
namespace
{
using Directories = std::vector<TIFFDirectory>;

// Values of the tag Compression.
constexpr int NoCompression = 1, AdobeDeflate = 8, OldDeflate = 32946;

[[noreturn]] void refuse(TIFFFile& file, const std::string& message)
{
  file.input().fail(ParseCode::Malformed, message);
}

// Return the text of a line "key=value" of ImageJ's description, or none.
std::optional<std::string> valueOf(const std::string& description, const std::string& key)
{
  std::size_t begin = 0;
  while (begin < description.size())
  {
    const std::size_t end = std::min(description.find('\n', begin), description.size());
    if (description.compare(begin, key.size() + 1, key + "=") == 0)
    {
      return description.substr(begin + key.size() + 1, end - begin - key.size() - 1);
    }
    begin = end + 1;
  }
  return {};
}

double numberOf(const std::string& description, const std::string& key, double otherwise)
{
  double value = otherwise;
  const std::optional<std::string> text = valueOf(description, key);
  return text && readNumber(*text, value) > 0 && std::isfinite(value) ? value : otherwise;
}

std::size_t countOf(const std::string& description, const std::string& key)
{
  constexpr double largest = 1e9;
  const double value = numberOf(description, key, 1.0);
  return value >= 1.0 && value <= largest ? static_cast<std::size_t>(value) : 1;
}

bool isOfImageJ(const TIFFDirectory& page)
{
  return page.Description.compare(0, 7, "ImageJ=") == 0;
}

ScalarType typeOf(TIFFFile& file, const TIFFDirectory& page)
{
  constexpr int isSigned = 2, isFloat = 3;
  const int format = page.whole(TIFFTag::SampleFormat, 1);
  const int bits = page.whole(TIFFTag::BitsPerSample, 1);
  if (format == isFloat && (bits == 32 || bits == 64))
  {
    return bits == 32 ? ScalarType::Float32 : ScalarType::Float64;
  }
  switch (format == isFloat ? 0 : bits)
  {
    case 8:
      return format == isSigned ? ScalarType::Int8 : ScalarType::UInt8;
    case 16:
      return format == isSigned ? ScalarType::Int16 : ScalarType::UInt16;
    case 32:
      return format == isSigned ? ScalarType::Int32 : ScalarType::UInt32;
    case 64:
      return format == isSigned ? ScalarType::Int64 : ScalarType::UInt64;
    default:
      refuse(file,
        "found numbers of " + std::to_string(bits) +
          " bits, expected 8, 16, 32 or 64 bits; convert the file");
  }
}

void requireReadable(TIFFFile& file, const TIFFDirectory& page)
{
  const int compression = page.whole(TIFFTag::Compression, NoCompression);
  if (compression != NoCompression && compression != AdobeDeflate && compression != OldDeflate)
  {
    refuse(file,
      "found compression " + std::to_string(compression) +
        ", but only uncompressed files and deflate are read; save without compression");
  }
  if (page.Numbers.count(TIFFTag::TileWidth) > 0)
  {
    refuse(file, "found tiles, but only strips are read; save without tiles");
  }
  if (page.number(TIFFTag::PlanarConfiguration, 1.0) != 1.0 &&
    page.number(TIFFTag::SamplesPerPixel, 1.0) > 1.0)
  {
    refuse(file, "found samples in separate planes; save with samples next to each other");
  }
  if (page.number(TIFFTag::Orientation, 1.0) != 1.0)
  {
    refuse(file, "found a turned picture, expected the first row at the top");
  }
  if (page.number(TIFFTag::Predictor, 1.0) > 2.0)
  {
    refuse(file, "found a predictor of floats; save without compression");
  }
}

// Return the spacing of pixels from their number in a unit, or 1.
double spacingOf(const TIFFDirectory& page, TIFFTag tag)
{
  const double resolution = page.number(tag, 0.0);
  const double spacing = resolution > 0.0 ? 1.0 / resolution : 1.0;
  return spacing > 0.0 && std::isfinite(spacing) ? spacing : 1.0;
}

// Return the length of a unit of time in seconds, or 1 if the unit is unknown.
double secondsOf(const std::string& unit)
{
  static const std::map<std::string, double> units = { { "us", 1e-6 }, { "\\u00B5s", 1e-6 },
    { "ms", 1e-3 }, { "msec", 1e-3 }, { "s", 1.0 }, { "sec", 1.0 }, { "second", 1.0 },
    { "seconds", 1.0 }, { "min", 60.0 }, { "minute", 60.0 }, { "minutes", 60.0 }, { "h", 3600.0 },
    { "hr", 3600.0 }, { "hour", 3600.0 }, { "hours", 3600.0 }, { "d", 86400.0 }, { "day", 86400.0 },
    { "days", 86400.0 } };
  const auto found = units.find(unit);
  return found == units.end() ? 1.0 : found->second;
}

void readUnits(const TIFFDirectory& page, TIFFStackInfo& info)
{
  constexpr double ofDescription = 1.0; // the resolution is in the unit of the description, if any
  const std::string unit = valueOf(page.Description, "unit").value_or("");
  const bool hasUnit = !unit.empty() && unit != "pixel";
  if (hasUnit)
  {
    info.Unit = unit == "\\u00B5m" || unit == "\xB5m" ? "micron" : unit;
  }
  if (hasUnit || page.number(TIFFTag::ResolutionUnit, 0.0) == ofDescription)
  {
    info.Spacing[0] = spacingOf(page, TIFFTag::XResolution);
    info.Spacing[1] = spacingOf(page, TIFFTag::YResolution);
  }
  const double apart = std::abs(numberOf(page.Description, "spacing", 0.0));
  info.Spacing[2] = apart > 0.0 ? apart : 1.0;
  // ImageJ states no unit of time for seconds.
  const double seconds = secondsOf(valueOf(page.Description, "tunit").value_or("sec"));
  const double interval = seconds * numberOf(page.Description, "finterval", 0.0);
  info.FrameInterval = interval > 0.0 ? interval : 1.0;
}

// Require that the file has room for pages that follow the first one without a directory.
void requireContiguous(
  TIFFFile& file, const TIFFDirectory& first, const TIFFStackInfo& info, std::size_t count)
{
  if (first.number(TIFFTag::Compression, NoCompression) != double(NoCompression))
  {
    refuse(file, "the pages without a directory are compressed");
  }
  const double bytes = double(info.pixelsPerPage()) * first.number(TIFFTag::SamplesPerPixel, 1.0) *
    double(sizeOf(info.Type));
  if (double(count) * bytes > double(file.input().size()))
  {
    file.input().fail(ParseCode::PrematureEnd,
      "the file is too small for the " + std::to_string(count) + " pages of its description");
  }
}

// Sizes that all pages share, and how pages are channels, slices and frames.
TIFFStackInfo infoOf(TIFFFile& file, const Directories& pages)
{
  TIFFStackInfo info;
  const TIFFDirectory& first = pages.front();
  requireReadable(file, first);
  constexpr double largest = 2147483647.0;
  const double width = first.number(TIFFTag::Width, 0.0),
               height = first.number(TIFFTag::Height, 0.0),
               samples = first.number(TIFFTag::SamplesPerPixel, 1.0);
  if (!(width >= 1.0 && width <= largest && height >= 1.0 && height <= largest && samples >= 1.0 &&
        width * height * samples <= largest))
  {
    refuse(file, "the size of the page is 0, or exceeds 2147483647 numbers");
  }
  info.Width = static_cast<std::size_t>(width);
  info.Height = static_cast<std::size_t>(height);
  info.Type = typeOf(file, first);
  info.Slices = pages.size();
  if (pages.size() > 1 && first.Description.find("<OME") != std::string::npos)
  {
    refuse(file,
      "the file is an OME-TIFF, whose description of channels, slices and frames is not read; save "
      "the file as TIFF in ImageJ");
  }
  if (isOfImageJ(first))
  {
    const std::size_t images = countOf(first.Description, "images");
    const bool isContiguous = pages.size() == 1 && images > 1;
    const std::size_t count = isContiguous ? images : pages.size();
    if (isContiguous)
    {
      requireContiguous(file, first, info, count);
    }
    info.Channels = countOf(first.Description, "channels");
    info.Frames = countOf(first.Description, "frames");
    info.Slices = count / (info.Channels * info.Frames);
    if (info.Slices == 0 || info.pages() != count)
    {
      refuse(file,
        "the file has " + std::to_string(count) + " pages, but its description has " +
          std::to_string(info.Channels) + " channels and " + std::to_string(info.Frames) +
          " frames");
    }
    readUnits(first, info);
  }
  info.Channels *= static_cast<std::size_t>(samples);
  return info;
}

// Bytes of one page, from its strips.
class PageReader
{
public:
  PageReader(TIFFFile& file, const TIFFStackInfo& info, std::size_t samples)
    : File(file)
    , Info(info)
    , Samples(samples)
    , Bytes(info.pixelsPerPage() * samples * sizeOf(info.Type))
  {
  }

  // Read the page of a directory. `page` counts pages that follow the first one without a
  // directory.
  const std::vector<unsigned char>& read(const TIFFDirectory& directory, std::size_t page)
  {
    requireReadable(this->File, directory);
    if (directory.number(TIFFTag::Width, 0.0) != double(this->Info.Width) ||
      directory.number(TIFFTag::Height, 0.0) != double(this->Info.Height) ||
      directory.number(TIFFTag::SamplesPerPixel, 1.0) != double(this->Samples) ||
      typeOf(this->File, directory) != this->Info.Type)
    {
      refuse(this->File, "the pages differ in size or type");
    }
    const int compression = directory.whole(TIFFTag::Compression, NoCompression);
    const std::size_t rowBytes = this->Bytes.size() / this->Info.Height;
    const double rows =
      std::clamp(directory.number(TIFFTag::RowsPerStrip, double(this->Info.Height)), 1.0,
        double(this->Info.Height));
    const std::size_t stripBytes = static_cast<std::size_t>(rows) * rowBytes;
    const std::size_t count = (this->Bytes.size() + stripBytes - 1) / stripBytes;
    const auto offsets = directory.Numbers.find(TIFFTag::StripOffsets),
               sizes = directory.Numbers.find(TIFFTag::StripByteCounts);
    if (offsets == directory.Numbers.end() || offsets->second.size() < count ||
      (compression != NoCompression &&
        (sizes == directory.Numbers.end() || sizes->second.size() < count)))
    {
      refuse(this->File, "the page lacks strips");
    }
    for (std::size_t strip = 0; strip < count; ++strip)
    {
      const std::size_t begin = strip * stripBytes;
      const std::size_t size = std::min(stripBytes, this->Bytes.size() - begin);
      if (offsets->second[strip] > double(this->File.input().size()))
      {
        this->File.input().fail(ParseCode::PrematureEnd, "the file ends before a strip");
      }
      const auto offset = static_cast<std::uint64_t>(offsets->second[strip]);
      if (compression == NoCompression)
      {
        this->copy(offset + page * this->Bytes.size(), this->Bytes.data() + begin, size);
      }
      else
      {
        this->inflateTo(offset, sizes->second[strip], this->Bytes.data() + begin, size);
      }
    }
    this->finish(directory.number(TIFFTag::Predictor, 1.0) == 2.0 && compression != NoCompression);
    return this->Bytes;
  }

private:
  void copy(std::uint64_t offset, unsigned char* to, std::size_t size)
  {
    this->File.seek(offset);
    constexpr std::size_t piece = 1 << 16;
    for (std::size_t done = 0; done < size;)
    {
      const std::size_t wanted = std::min(piece, size - done);
      const std::string_view bytes = this->File.input().peek(wanted);
      if (bytes.size() < wanted)
      {
        this->File.input().fail(ParseCode::PrematureEnd, "the file ends inside a page");
      }
      std::memcpy(to + done, bytes.data(), wanted);
      this->File.input().advance(wanted);
      done += wanted;
    }
  }

  void inflateTo(std::uint64_t offset, double stored, unsigned char* to, std::size_t size)
  {
    this->File.seek(offset);
    if (!(stored <= double(this->File.input().left())))
    {
      this->File.input().fail(ParseCode::PrematureEnd, "the file ends inside a page");
    }
    std::vector<unsigned char> packed(static_cast<std::size_t>(stored));
    this->copy(offset, packed.data(), packed.size());
    uLongf length = static_cast<uLongf>(size);
    if (uncompress(to, &length, packed.data(), static_cast<uLong>(packed.size())) != Z_OK ||
      length != size)
    {
      refuse(this->File, "found a strip that zlib cannot decompress to its size");
    }
  }

  // Convert the byte order, and undo differences between neighbors in a row.
  void finish(bool hasDifferences)
  {
    withType(this->Info.Type,
      [&](auto zero)
      {
        using T = decltype(zero);
        const std::size_t count = this->Bytes.size() / sizeof(T);
        const bool swap = this->File.isBigEndian() == isLittleEndianMachine();
        unsigned char* const bytes = this->Bytes.data();
        for (std::size_t i = 0; swap && sizeof(T) > 1 && i < count; ++i)
        {
          std::reverse(bytes + i * sizeof(T), bytes + (i + 1) * sizeof(T));
        }
        const std::size_t row = this->Info.Width * this->Samples;
        if constexpr (std::is_integral_v<T>)
        {
          for (std::size_t i = 0; hasDifferences && i < count; ++i)
          {
            if (i % row >= this->Samples)
            {
              std::make_unsigned_t<T> left, here;
              std::memcpy(&left, bytes + (i - this->Samples) * sizeof(T), sizeof(T));
              std::memcpy(&here, bytes + i * sizeof(T), sizeof(T));
              here = static_cast<std::make_unsigned_t<T>>(here + left);
              std::memcpy(bytes + i * sizeof(T), &here, sizeof(T));
            }
          }
        }
      });
  }

  TIFFFile& File;
  const TIFFStackInfo& Info;
  std::size_t Samples;
  std::vector<unsigned char> Bytes;
};

void readFrame(TIFFFile& file, const Directories& pages, const TIFFStackOptions& options,
  const ParseLimits& limits, const Run& run, TIFFStack& stack)
{
  const TIFFStackInfo& info = stack.Info;
  if (options.Frame >= info.Frames)
  {
    refuse(file, "the file has only " + std::to_string(info.Frames) + " frames");
  }
  const auto samples =
    static_cast<std::size_t>(pages.front().number(TIFFTag::SamplesPerPixel, 1.0));
  const std::size_t bytes = sizeOf(info.Type), pagesPerSlice = info.Channels / samples;
  const bool isContiguous = pages.size() == 1;
  const bool isPacked =
    pages.front().number(TIFFTag::Compression, NoCompression) != double(NoCompression);
  // Compressed pages can be much larger than the file.
  const std::uint64_t voxels = std::uint64_t(info.pixelsPerPage()) * info.Slices;
  file.seek(0);
  limits.checkedCount(file.input(), "voxels", voxels, isPacked ? 0 : bytes * info.Channels / 2,
    bytes * info.Channels);
  constexpr std::uint64_t mostInflated = 1100; // zlib makes at most 1032 bytes from one
  if (voxels * bytes * info.Channels / mostInflated > file.input().size())
  {
    file.input().fail(ParseCode::PrematureEnd, "the file is too small for its pages");
  }
  stack.Values.resize(voxels * bytes * info.Channels);
  PageReader reader(file, info, samples);
  const std::size_t count = info.Slices * pagesPerSlice;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t page = options.Frame * count + i;
    const std::vector<unsigned char>& read =
      reader.read(pages[isContiguous ? 0 : page], isContiguous ? page : 0);
    const std::size_t slice = i / pagesPerSlice, channel = i % pagesPerSlice * samples;
    for (std::size_t row = 0; row < info.Height; ++row)
    {
      const std::size_t to = options.FirstRowUp ? info.Height - 1 - row : row;
      for (std::size_t column = 0; column < info.Width; ++column)
      {
        const std::size_t voxel = (slice * info.Height + to) * info.Width + column;
        std::memcpy(stack.Values.data() + (voxel * info.Channels + channel) * bytes,
          read.data() + (row * info.Width + column) * samples * bytes, samples * bytes);
      }
    }
    run.report(double(i + 1) / double(count));
  }
}
}

//------------------------------------------------------------------------------
TIFFStackResult parseTIFFStack(
  const OpenInput& open, const TIFFStackOptions& options, const ParseLimits& limits, const Run& run)
{
  TIFFStackResult result;
  result.Status = statusOf(
    [&]()
    {
      TIFFFile file(open, limits);
      const Directories pages = file.directories(run.part(0.0, options.HeaderOnly ? 1.0 : 0.1));
      result.Stack.Info = infoOf(file, pages);
      if (!options.HeaderOnly)
      {
        readFrame(file, pages, options, limits, run.part(0.1, 1.0), result.Stack);
      }
    });
  if (!result.Status.ok())
  {
    result.Stack = {};
  }
  return result;
}
}
