// Make valid and broken PCD files for tests.
#ifndef PCDSamples_h
#define PCDSamples_h

#include "../Bytes/MadeBytes.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace samples
{
inline const std::string& AsciiPCD()
{
  static const std::string text =
    "# .PCD v.7 - Point Cloud Data file format\nVERSION .7\nFIELDS x y z rgb label\n"
    "SIZE 4 4 4 4 2\nTYPE F F F U I\nCOUNT 1 1 1 1 1\nWIDTH 3\nHEIGHT 1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n"
    "0.5 1.5 2.5 66051 -1\nnan nan nan 0 0\n7 8 9 16711680 32767\n";
  return text;
}

// Return a header of an old version without WIDTH. The header has fields of several numbers,
// padding, and fields of 8 bytes.
inline std::string PCDHead(const std::string& format)
{
  return "VERSION 0.5\nCOLUMNS normal_x x y z _ normal_y normal_z rgba pair stamp\n"
         "SIZE 4 4 4 4 1 4 4 4 2 8\nTYPE F F F F U F F F I U\nCOUNT 1 1 1 1 3 1 1 1 2 1\n"
         "POINTS 4\nDATA " +
    format + "\n";
}

struct PCDPoint
{
  float Normal[3];
  float Point[3];
  std::uint32_t Color;
  std::int16_t Pair[2];
  std::uint64_t Stamp;
};

inline std::vector<PCDPoint> PCDPoints()
{
  std::vector<PCDPoint> points;
  for (int i = 0; i < 4; ++i)
  {
    const float x = i == 1 ? std::numeric_limits<float>::quiet_NaN() : 0.5F * static_cast<float>(i);
    points.push_back({ { 0, 0, 1 }, { x, 1, 0.1F }, 0x80010203U + static_cast<std::uint32_t>(i),
      { std::int16_t(-i), 300 }, (std::uint64_t(1) << 40) + static_cast<std::uint64_t>(i) });
  }
  return points;
}

inline std::string BinaryPCD()
{
  Bytes file(false, PCDHead("binary"));
  for (const PCDPoint& p : PCDPoints())
  {
    file.add(p.Normal[0]).add(p.Point[0]).add(p.Point[1]).add(p.Point[2]).text("pad");
    file.add(p.Normal[1]).add(p.Normal[2]).add(p.Color).add(p.Pair[0]).add(p.Pair[1]).add(p.Stamp);
  }
  return file.bytes();
}

// Compress bytes in the format of LibLZF. The slow search finds the longest match in the last 8192
// bytes.
inline std::string CompressedLZF(const std::string& bytes)
{
  std::string result;
  std::string literals;
  const auto flush = [&]()
  {
    for (std::size_t i = 0; i < literals.size(); i += 32)
    {
      const std::string part = literals.substr(i, 32);
      result += static_cast<char>(part.size() - 1) + part;
    }
    literals.clear();
  };
  for (std::size_t at = 0; at < bytes.size();)
  {
    std::size_t length = 0;
    std::size_t distance = 0;
    for (std::size_t from = at - std::min<std::size_t>(at, 8192); from < at; ++from)
    {
      std::size_t same = 0;
      while (at + same < bytes.size() && same < 264 && bytes[from + same] == bytes[at + same])
      {
        ++same;
      }
      if (same > length)
      {
        length = same;
        distance = at - from - 1;
      }
    }
    if (length < 3)
    {
      literals += bytes[at++];
      continue;
    }
    flush();
    const std::size_t code = length - 2;
    result += static_cast<char>((std::min<std::size_t>(code, 7) << 5) | (distance >> 8));
    result += code >= 7 ? std::string(1, static_cast<char>(code - 7)) : "";
    result += static_cast<char>(distance & 255);
    at += length;
  }
  flush();
  return result;
}

inline std::string CompressedPCD()
{
  Bytes fields(false);
  const std::vector<PCDPoint> points = PCDPoints();
  const auto each = [&](auto get)
  {
    for (const PCDPoint& p : points)
    {
      fields.add(get(p));
    }
  };
  each([](const PCDPoint& p) { return p.Normal[0]; });
  for (int c = 0; c < 3; ++c)
  {
    each([&](const PCDPoint& p) { return p.Point[c]; });
  }
  each([](const PCDPoint& p) { return p.Normal[1]; });
  each([](const PCDPoint& p) { return p.Normal[2]; });
  each([](const PCDPoint& p) { return p.Color; });
  for (const PCDPoint& p : points)
  {
    fields.add(p.Pair[0]).add(p.Pair[1]);
  }
  each([](const PCDPoint& p) { return p.Stamp; });
  const std::string compressed = CompressedLZF(fields.bytes());
  return Bytes(false, PCDHead("binary_compressed"))
    .add(static_cast<std::uint32_t>(compressed.size()))
    .add(static_cast<std::uint32_t>(fields.bytes().size()))
    .text(compressed)
    .bytes();
}

inline std::vector<std::string> PCDFiles()
{
  return { AsciiPCD(), BinaryPCD(), CompressedPCD(),
    "FIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadPCDFiles()
{
  const auto& ascii = AsciiPCD();
  const std::string binary = BinaryPCD();
  const std::string compressed = CompressedPCD();
  return { replaced(ascii, "VERSION .7", "VERSION .8"),
    replaced(ascii, "VERSION .7", "VERSION seven"), replaced(ascii, "SIZE", "SIZES"),
    replaced(ascii, "HEIGHT 1", "WIDTH 1"), replaced(ascii, "WIDTH 3", "WIDTH -3"),
    replaced(ascii, "WIDTH 3", "WIDTH 4"),
    replaced(ascii, "HEIGHT 1", "HEIGHT 18446744073709551615"),
    replaced(ascii, "POINTS 3", "POINTS 4"),
    replaced(ascii, "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n", ""),
    replaced(ascii, "SIZE 4 4 4 4 2", "SIZE 4 4 4 4"),
    replaced(ascii, "SIZE 4 4 4 4 2", "SIZE 4 4 4 4 3"),
    replaced(ascii, "SIZE 4 4 4 4 2", "SIZE 4 4 4 4 -2"),
    replaced(ascii, "SIZE 4 4 4 4 2", "SIZE 4 4 4 4 0"),
    replaced(ascii, "TYPE F F F U I", "TYPE F F F U X"),
    replaced(ascii, "TYPE F F F U I", "TYPE F F F U"),
    replaced(ascii, "COUNT 1 1 1 1 1", "COUNT 1 1 1 1 4000000000"),
    replaced(ascii, "COUNT 1 1 1 1 1", "COUNT 2 1 1 1 1"),
    replaced(ascii, "COUNT 1 1 1 1 1", "COUNT 1 1 1 1 2"),
    replaced(ascii, "FIELDS x y z", "FIELDS x y w"), replaced(ascii, "FIELDS x y z", "FIELDS x y"),
    replaced(ascii, "FIELDS x y z", "FIELDS x x z"),
    replaced(ascii, "FIELDS x y z rgb", "FIELDS x y z x"),
    replaced(ascii, "rgb label", "label label"),
    replaced(compressed, "POINTS 4", "POINTS 4000000000000"),
    replaced(ascii, "DATA ascii", "DATA text"), replaced(ascii, "DATA ascii", "DATA"),
    replaced(ascii, "POINTS 3", "POINTS 3x"),
    replaced(ascii, "DATA ascii", "DATA binary_compressed"), replaced(ascii, "1.5", "1.2.3"),
    replaced(ascii, "1.5", "--5"), replaced(ascii, "1.5", "0x1p3"), replaced(ascii, "1.5", "1e999"),
    replaced(ascii, "1.5", "one"), replaced(ascii, "1.5", ""), replaced(ascii, "32767", "32768"),
    replaced(ascii, "32767", "32767 1"), replaced(ascii, "32767", "32767\n1 2 3 4 5"),
    binary.substr(0, binary.size() - 1), replaced(binary, "POINTS 4", "POINTS 400"),
    replaced(binary, "POINTS 4", "POINTS 99999999999999"),
    compressed.substr(0, compressed.size() - 1), replaced(compressed, "POINTS 4", "POINTS 5"),
    replaced(compressed, "POINTS 4", "POINTS 3"),
    compressed.substr(0, compressed.size() - 20) + std::string(20, '\xE0') };
}
}

#endif
