// Make TIFF files, byte by byte, for tests of the parser.
#ifndef TIFFSamples_h
#define TIFFSamples_h

#include "Bytes/ByteOrder.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace samples
{
struct TIFFOptions
{
  bool IsBig = false;      ///< byte order
  bool IsLong = false;     ///< BigTIFF
  bool IsDeflated = false; ///< with differences between neighbors
  std::string Description = {};
  std::vector<std::pair<int, std::uint32_t>> Others = {}; ///< tags with a short number
  bool HasTagTwice = false;
  int Huge = 0;             ///< tag whose value is 2^64 - 1, in a BigTIFF file
  std::uint64_t Strips = 1; ///< number of offsets of strips, all in one place if there are many
  std::uint32_t Height = 2;
};

/// Return a file of pages of 3 x 2 numbers of 16 bits: 100 p + 10 r + c on page p, in row r and
/// column c. Each page has one strip, before its directory.
inline std::string TIFF(int pages, const TIFFOptions& options = {})
{
  const bool isBig = options.IsBig;
  const int wide = options.IsLong ? 8 : 4;
  std::string file = isBig ? "MM" : "II";
  const auto add = [&](std::string& to, std::uint64_t value, int bytes)
  {
    switch (bytes)
    {
      case 2:
        conformal::appendBytes(to, static_cast<std::uint16_t>(value), isBig);
        break;
      case 4:
        conformal::appendBytes(to, static_cast<std::uint32_t>(value), isBig);
        break;
      default:
        conformal::appendBytes(to, value, isBig);
    }
  };
  const auto put = [&](std::size_t at, std::uint64_t value)
  {
    std::string bytes;
    add(bytes, value, wide);
    file.replace(at, bytes.size(), bytes);
  };
  add(file, options.IsLong ? 43 : 42, 2);
  if (options.IsLong)
  {
    add(file, 8, 2);
    add(file, 0, 2);
  }
  std::size_t link = file.size();
  add(file, 0, wide);
  const std::size_t text = file.size();
  file += options.Description + '\0';
  const std::size_t ratio = file.size();
  add(file, 4, 4); // 4 / 2 pixels in a unit
  add(file, 2, 4);
  for (int p = 0; p < pages; ++p)
  {
    std::string strip;
    for (int r = 0; r < 2; ++r)
    {
      for (int c = 0; c < 3; ++c)
      {
        add(strip, options.IsDeflated && c > 0 ? 1 : 100 * p + 10 * r + c, 2);
      }
    }
    if (options.IsDeflated)
    {
      std::string packed(compressBound(strip.size()), '\0');
      uLongf size = packed.size();
      compress(reinterpret_cast<Bytef*>(&packed[0]), &size,
        reinterpret_cast<const Bytef*>(strip.data()), strip.size());
      strip = packed.substr(0, size);
    }
    const std::size_t offset = file.size();
    file += strip;
    struct Tag
    {
      int Number, Type;
      std::uint64_t Count, Value;
    };
    std::vector<Tag> tags = { { 256, 3, 1, 3 }, { 257, 4, 1, options.Height }, { 258, 3, 1, 16 },
      { 259, 3, 1, options.IsDeflated ? 8u : 1u }, { 262, 3, 1, 1 },
      { 273, 4, options.Strips, options.Strips > 1 ? 0 : offset }, { 277, 3, 1, 1 },
      { 279, 4, 1, strip.size() }, { 282, 5, 1, ratio }, { 283, 5, 1, ratio }, { 339, 3, 1, 1 },
      { 65000, 12, 9, 0 } }; // the last is unknown
    if (options.IsDeflated)
    {
      tags.push_back({ 317, 3, 1, 2 });
    }
    if (p == 0 && !options.Description.empty())
    {
      tags.push_back({ 270, 2, options.Description.size() + 1, text });
    }
    for (const auto& [number, value] : options.Others)
    {
      const auto isSame = [n = number](const Tag& tag) { return tag.Number == n; };
      tags.erase(std::remove_if(tags.begin(), tags.end(), isSame), tags.end());
      tags.push_back({ number, 3, 1, value });
    }
    for (Tag& tag : tags)
    {
      if (tag.Number == options.Huge)
      {
        tag = { tag.Number, 16, 1, ~std::uint64_t(0) };
      }
    }
    if (options.HasTagTwice)
    {
      tags.push_back(tags.front());
    }
    put(link, file.size());
    add(file, tags.size(), options.IsLong ? 8 : 2);
    for (const Tag& tag : tags)
    {
      add(file, tag.Number, 2);
      add(file, tag.Type, 2);
      add(file, tag.Count, wide);
      std::string value;
      add(value, tag.Value, tag.Type == 3 ? 2 : tag.Type == 4 ? 4 : wide);
      value.resize(wide);
      file += value;
    }
    link = file.size();
    add(file, 0, wide);
  }
  return file;
}

/// Return valid files of all kinds.
inline std::vector<std::string> TIFFFiles()
{
  TIFFOptions big, wide, packed, named;
  big.IsBig = true;
  wide.IsLong = true;
  packed.IsDeflated = true;
  named.Description = "ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\nunit=micron\nspacing=3\n";
  return { TIFF(1), TIFF(4, big), TIFF(3, wide), TIFF(2, packed), TIFF(4, named) };
}
}

#endif
