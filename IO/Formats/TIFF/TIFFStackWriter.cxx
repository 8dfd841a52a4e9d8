#include "TIFF/TIFFStackWriter.h"

#include "Bytes/ByteOrder.h"
#include "TIFF/TIFFDirectory.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
// Shortest text of a number, in every locale.
std::string textOf(double value)
{
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return { text.data(), end.ptr };
}

void requireWritable(const TIFFStack& stack)
{
  const TIFFStackInfo& info = stack.Info;
  const bool isKnown = info.Type == ScalarType::UInt8 || info.Type == ScalarType::UInt16 ||
    info.Type == ScalarType::Float32;
  if (!isKnown || info.pages() == 0 || info.pixelsPerPage() == 0 ||
    stack.Values.size() != info.pixelsPerPage() * info.pages() * sizeOf(info.Type))
  {
    throw std::invalid_argument("a TIFF stack must have voxels of type UInt8, UInt16 or Float32");
  }
  for (const double spacing : info.Spacing)
  {
    if (!(spacing > 0.0 && std::isfinite(spacing)))
    {
      throw std::invalid_argument("the spacing of a TIFF stack must be positive and finite");
    }
  }
  if (!(info.FrameInterval > 0.0 && std::isfinite(info.FrameInterval)))
  {
    throw std::invalid_argument("the frame interval of a TIFF stack must be positive and finite");
  }
  constexpr double reserved = 1e6, largest = 4294967295.0 - reserved;
  constexpr double perPage = 400.0;
  if (double(stack.Values.size()) + perPage * double(info.pages()) > largest)
  {
    throw std::invalid_argument("the TIFF file would exceed 4 GB; write fewer slices");
  }
  for (const char c : info.Unit)
  {
    if (static_cast<unsigned char>(c) < ' ' || c == '=')
    {
      throw std::invalid_argument("the unit must not contain = or control characters");
    }
  }
}

// Range of the numbers, for the display of ImageJ.
std::array<double, 2> rangeOf(const TIFFStack& stack)
{
  return withType(stack.Info.Type,
    [&](auto zero)
    {
      using T = decltype(zero);
      std::array<double, 2> range = { std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() };
      for (std::size_t i = 0; i < stack.Values.size(); i += sizeof(T))
      {
        T value;
        std::memcpy(&value, stack.Values.data() + i, sizeof(T));
        if (std::isfinite(static_cast<double>(value)))
        {
          range[0] = std::min(range[0], static_cast<double>(value));
          range[1] = std::max(range[1], static_cast<double>(value));
        }
      }
      return range;
    });
}

std::string descriptionOf(const TIFFStack& stack)
{
  const TIFFStackInfo& info = stack.Info;
  std::string text = "ImageJ=1.53t\nimages=" + std::to_string(info.pages()) + "\n";
  if (info.Channels > 1)
  {
    text += "channels=" + std::to_string(info.Channels) + "\n";
  }
  if (info.Slices > 1)
  {
    text += "slices=" + std::to_string(info.Slices) + "\n";
  }
  if (info.Frames > 1)
  {
    text += "frames=" + std::to_string(info.Frames) + "\n";
  }
  if (info.Channels > 1 || info.Frames > 1)
  {
    text += "hyperstack=true\n";
  }
  if (info.Channels > 1)
  {
    text += "mode=composite\n";
  }
  if (info.Frames > 1)
  {
    text += "finterval=" + textOf(info.FrameInterval) + "\n";
  }
  text += "unit=" + (info.Unit.empty() ? "pixel" : info.Unit) + "\n";
  text += "spacing=" + textOf(info.Spacing[2]) + "\nloop=false\n";
  const std::array<double, 2> range = rangeOf(stack);
  if (range[0] <= range[1])
  {
    text += "min=" + textOf(range[0]) + "\nmax=" + textOf(range[1]) + "\n";
  }
  return text + '\0';
}

// Return a quotient of whole numbers with 32 bits. The larger of them is at least a million, so
// that the relative error is at most 5e-7.
std::array<std::uint32_t, 2> quotientOf(double value)
{
  constexpr double million = 1e6, largest = 4294967295.0;
  const bool isLarge = value >= 1.0;
  const double size = isLarge ? value : 1.0 / value;
  const double below = std::clamp(std::floor(largest / size), 1.0, million);
  const double above = std::round(below * size);
  if (!(above <= largest))
  {
    throw std::invalid_argument(
      "the spacing of a TIFF stack must be in [2.33e-10, 4.29e9]; use another unit");
  }
  const auto top = static_cast<std::uint32_t>(isLarge ? above : below);
  return { top, static_cast<std::uint32_t>(isLarge ? below : above) };
}

class Directory
{
public:
  void add(TIFFTag tag, std::uint32_t value, bool isShort)
  {
    this->entry(tag, isShort ? 3 : 4, 1);
    appendBytes(this->Entries, value, false); // a SHORT is in the lower bytes
  }
  void addAt(TIFFTag tag, int type, std::uint32_t count, std::uint32_t offset)
  {
    this->entry(tag, type, count);
    appendBytes(this->Entries, offset, false);
  }
  std::string bytes(std::uint32_t next) const
  {
    std::string all;
    appendBytes(all, this->Count, false);
    all += this->Entries;
    appendBytes(all, next, false);
    return all;
  }

private:
  void entry(TIFFTag tag, int type, std::uint32_t count)
  {
    ++this->Count;
    appendBytes(this->Entries, static_cast<std::uint16_t>(tag), false);
    appendBytes(this->Entries, static_cast<std::uint16_t>(type), false);
    appendBytes(this->Entries, count, false);
  }
  std::string Entries;
  std::uint16_t Count = 0;
};

// Places of a file: header, first directory, its texts, pages, other directories.
struct Layout
{
  std::uint32_t Resolution, Description, DescriptionBytes, Pages, PageBytes, Others;
};

constexpr std::uint32_t HeaderBytes = 8, DirectoryBytes = 2 + 15 * 12 + 4,
                        OtherBytes = 2 + 12 * 12 + 4;

std::string directoryOf(
  const TIFFStackInfo& info, const Layout& layout, std::uint32_t page, std::uint32_t next)
{
  constexpr int text = 2, rational = 5;
  const auto bits = static_cast<std::uint32_t>(8 * sizeOf(info.Type));
  const bool isFirst = page == 0;
  Directory directory;
  directory.add(TIFFTag::Width, static_cast<std::uint32_t>(info.Width), false);
  directory.add(TIFFTag::Height, static_cast<std::uint32_t>(info.Height), false);
  directory.add(TIFFTag::BitsPerSample, bits, true);
  directory.add(TIFFTag::Compression, 1, true);
  constexpr auto photometric = static_cast<TIFFTag>(262);
  directory.add(photometric, 1, true); // 0 is black
  if (isFirst)
  {
    directory.addAt(TIFFTag::Description, text, layout.DescriptionBytes, layout.Description);
  }
  directory.add(TIFFTag::StripOffsets, layout.Pages + page * layout.PageBytes, false);
  directory.add(TIFFTag::SamplesPerPixel, 1, true);
  directory.add(TIFFTag::RowsPerStrip, static_cast<std::uint32_t>(info.Height), false);
  directory.add(TIFFTag::StripByteCounts, layout.PageBytes, false);
  directory.addAt(TIFFTag::XResolution, rational, 1, layout.Resolution);
  directory.addAt(TIFFTag::YResolution, rational, 1, layout.Resolution + 8);
  if (isFirst)
  {
    directory.add(TIFFTag::PlanarConfiguration, 1, true);
    directory.add(TIFFTag::ResolutionUnit, 1, true); // the unit is in the description
  }
  directory.add(TIFFTag::SampleFormat, isFloating(info.Type) ? 3 : 1, true);
  return directory.bytes(next);
}

// Append a page in the file's byte order.
void appendPage(std::string& file, const TIFFStack& stack, std::size_t page, bool firstRowUp)
{
  const TIFFStackInfo& info = stack.Info;
  const std::size_t slice = page / info.Channels, channel = page % info.Channels,
                    bytes = sizeOf(info.Type);
  for (std::size_t row = 0; row < info.Height; ++row)
  {
    const std::size_t from = firstRowUp ? info.Height - 1 - row : row;
    for (std::size_t column = 0; column < info.Width; ++column)
    {
      const std::size_t voxel = (slice * info.Height + from) * info.Width + column;
      appendBytes(
        file, stack.Values.data() + (voxel * info.Channels + channel) * bytes, bytes, false);
    }
  }
}
}

//------------------------------------------------------------------------------
std::string makeTIFFStack(const TIFFStack& stack, bool firstRowUp, const Run& run)
{
  requireWritable(stack);
  const TIFFStackInfo& info = stack.Info;
  const std::string description = descriptionOf(stack);
  const auto pages = static_cast<std::uint32_t>(info.pages());
  Layout layout;
  layout.Resolution = HeaderBytes + DirectoryBytes;
  layout.Description = layout.Resolution + 16;
  layout.DescriptionBytes = static_cast<std::uint32_t>(description.size());
  layout.Pages = (layout.Description + layout.DescriptionBytes + 7) / 8 * 8;
  layout.PageBytes = static_cast<std::uint32_t>(info.pixelsPerPage() * sizeOf(info.Type));
  layout.Others = (layout.Pages + pages * layout.PageBytes + 7) / 8 * 8;
  std::string file("II\x2A\0", 4);
  appendBytes(file, HeaderBytes, false);
  file += directoryOf(info, layout, 0, pages > 1 ? layout.Others : 0);
  for (const double spacing : { info.Spacing[0], info.Spacing[1] })
  {
    for (const std::uint32_t number : quotientOf(1.0 / spacing))
    {
      appendBytes(file, number, false);
    }
  }
  file += description;
  file.resize(layout.Pages);
  file.reserve(layout.Others + pages * OtherBytes);
  for (std::uint32_t page = 0; page < pages; ++page)
  {
    appendPage(file, stack, page, firstRowUp);
    run.report(double(page + 1) / double(pages));
  }
  file.resize(layout.Others);
  for (std::uint32_t page = 1; page < pages; ++page)
  {
    const bool isLast = page + 1 == pages;
    file += directoryOf(info, layout, page, isLast ? 0 : layout.Others + page * OtherBytes);
  }
  return file;
}
}
