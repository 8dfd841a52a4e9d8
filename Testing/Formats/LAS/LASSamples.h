// Make valid and broken LAS files for tests.
#ifndef LASSamples_h
#define LASSamples_h

#include "../E57/E57Samples.h" // FromBase64

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace samples
{
constexpr std::size_t LASRecordBytes[] = { 20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67 };

// Return a file of 3 points of a format. Coordinates are (i, -2 i, 1000 i) times 0.001 plus the
// offset. The other numbers are those that TestLASParser.cxx expects.
inline std::string LASFileOf(unsigned format, unsigned minor, std::size_t extraBytes = 0,
  const std::array<double, 3>& offset = { 1.0, 2.0, 3.0 })
{
  const std::uint16_t headerBytes = minor < 3 ? 227 : minor == 3 ? 235 : 375;
  const std::size_t recordBytes = LASRecordBytes[format] + extraBytes;
  Bytes file(false, "LASF");
  file.text(std::string(20, '\0')).add(std::uint8_t(1)).add(static_cast<std::uint8_t>(minor));
  file.text(std::string(68, ' ')).add(headerBytes).add(std::uint32_t(headerBytes + 5));
  file.add(std::uint32_t(0)).add(static_cast<std::uint8_t>(format));
  file.add(static_cast<std::uint16_t>(recordBytes)).add(std::uint32_t(minor < 4 ? 3 : 0));
  file.text(std::string(20, '\0')).add(std::vector<double>(3, 0.001));
  file.add(std::vector<double>(offset.begin(), offset.end())).text(std::string(48, '\0'));
  if (minor >= 3)
  {
    file.add(std::uint64_t(0));
  }
  if (minor >= 4)
  {
    file.add(std::uint64_t(0)).add(std::uint32_t(0)).add(std::uint64_t(3));
    file.text(std::string(120, '\0'));
  }
  file.text("space"); // as records of variable length would be
  const bool isNew = format >= 6;
  const auto isOneOf = [&](const std::vector<unsigned>& formats)
  { return std::find(formats.begin(), formats.end(), format) != formats.end(); };
  for (std::uint16_t i = 0; i < 3; ++i)
  {
    const std::size_t start = file.bytes().size();
    file.add(std::int32_t(i)).add(std::int32_t(-2 * i)).add(std::int32_t(1000 * i));
    file.add(static_cast<std::uint16_t>(65533 + i));
    file.add(static_cast<std::uint8_t>(isNew ? (i + 1) | (15U << 4) : (i + 1) | (7U << 3) | 0xC0U));
    if (isNew)
    {
      file.text("f").add(static_cast<std::uint8_t>(200 + i)).text("uaa");
    }
    else
    {
      file.add(static_cast<std::uint8_t>((29 + i) | 0xE0)).text("au");
    }
    file.add(static_cast<std::uint16_t>(300 + i));
    if (isNew || isOneOf({ 1, 3, 4, 5 }))
    {
      file.add(0.5 + i);
    }
    if (isOneOf({ 2, 3, 5, 7, 8, 10 }))
    {
      file.add(static_cast<std::uint16_t>(256 * i))
        .add(std::uint16_t(65535))
        .add(std::uint16_t(255));
    }
    if (isOneOf({ 8, 10 }))
    {
      file.add(static_cast<std::uint16_t>(1000 + i));
    }
    file.text(std::string(start + recordBytes - file.bytes().size(), 'w'));
  }
  return file.bytes();
}

// Return a file of version 1.4 that laspy 2.7.0 wrote, in point format 7, with 3 points:
// (412001.25, 5318000, 500), (412002.5, 5318001, 501.5), (411996.25, 5318002, 502).
inline std::string LASFromLaspy()
{
  return FromBase64(
    "TEFTRgAAAAAAAAAAAAAAAAAAAAAAAAAAAQRPVEhFUgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAGxhc3B5IDIu"
    "Ny4wAAAAAAAAAAAAAAAAAAAAAAAAAAAASgHqB3cBdwEAAAAAAAAHJAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAB7"
    "FK5H4XqEP3sUrkfheoQ/exSuR+F6hD8AAAAAgCUZQQAAAABcSVRBAAAAAAAAAAAAAAAAiiUZQQAAAABxJRlBAAAA"
    "gFxJVEEAAAAAXElUQQAAAAAAYH9AAAAAAABAf0AAAAAAAAAAAAAAAAAAAAAAAAAAAAMAAAAAAAAAAQAAAAAAAAAB"
    "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
    "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAfQAAAAAAAABQwwAAAQAhAAIAAAAH"
    "AAAAAAAAAOA/AAEAAP8A+gAAAGQAAADmwwAAAgAiAB8AAAAIAAAAAAAAAPg/AAIAAQABif7//8gAAAAYxAAA////"
    "AMgAAAAJAAAAAAAAAARA//8AAgEB");
}

inline std::vector<std::string> LASFiles()
{
  std::vector<std::string> files = { LASFromLaspy(), LASFileOf(3, 2, 0, { 412000, 5318000, 500 }),
    LASFileOf(0, 0) };
  for (const unsigned format : { 1U, 2U, 4U, 5U })
  {
    files.push_back(LASFileOf(format, 3));
  }
  for (const unsigned format : { 6U, 7U, 8U, 9U, 10U })
  {
    files.push_back(LASFileOf(format, 4, 2));
  }
  return files;
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadLASFiles()
{
  const std::string old = LASFileOf(3, 2);
  const std::string recent = LASFileOf(7, 4);
  const auto changed = [](std::string file, std::size_t at, const std::string& bytes)
  { return file.replace(at, bytes.size(), bytes); };
  const auto number = [](double value) { return Bytes(false).add(value).bytes(); };
  const std::string nan = number(std::numeric_limits<double>::quiet_NaN());
  return { "LASF", old.substr(0, 226), old.substr(0, 231), old.substr(0, old.size() - 1),
    recent.substr(0, 300), recent.substr(0, recent.size() - 1), changed(old, 24, "\2"),
    changed(old, 25, "\5"), changed(old, 25, "\3"), changed(old, 94, std::string("\342", 1)),
    changed(recent, 94, std::string("\343\0", 2)), changed(old, 96, std::string("\1\0", 2)),
    changed(old, 96, std::string("\377\377\377\177", 4)), changed(old, 104, "\13"),
    changed(old, 104, "\203"), changed(old, 104, "\103"), changed(old, 105, "\41"),
    changed(old, 107, "\4"), changed(old, 107, "\377\377\377\377"),
    changed(recent, 247, std::string(8, '\377')), changed(old, 131, number(0.0)),
    changed(old, 139, nan), changed(old, 147, number(1e300)), changed(old, 155, nan) };
}
}

#endif
