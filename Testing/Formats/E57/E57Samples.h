// Make valid and broken E57 files for tests.
#ifndef E57Samples_h
#define E57Samples_h

#include "../Bytes/MadeBytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace samples
{
constexpr std::size_t E57PageContents = 1020;

// Return the checksum CRC-32C, computed bit by bit.
inline std::uint32_t SlowCRC32C(const std::string& bytes)
{
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes)
  {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = (sum & 1U) != 0 ? (sum >> 1) ^ 0x82F63B78U : sum >> 1;
    }
  }
  return ~sum;
}

inline std::uint64_t E57PhysicalOffset(std::uint64_t logical)
{
  return logical / E57PageContents * 1024 + logical % E57PageContents;
}

// Pack numbers of a few bits each, beginning with the least significant bit of the first byte.
inline std::string PackedBits(const std::vector<std::uint64_t>& values, unsigned bits)
{
  std::string bytes((values.size() * bits + 7) / 8, '\0');
  std::size_t at = 0;
  for (const std::uint64_t value : values)
  {
    for (unsigned bit = 0; bit < bits; ++bit, ++at)
    {
      if (((value >> bit) & 1U) != 0)
      {
        bytes[at / 8] =
          static_cast<char>(static_cast<unsigned char>(bytes[at / 8]) | (1U << (at % 8)));
      }
    }
  }
  return bytes;
}

struct E57Sample
{
  std::string More;      // XML of a scan before its points
  std::string Prototype; // XML of the fields
  std::size_t Points = 0;
  std::vector<std::string> Streams; // bytes of each field
  std::size_t PacketBytes = 1000;   // maximum length of a field in a packet
};

// Return the section with the points of a scan. Each data packet follows packets that readers skip.
inline std::string E57SectionOf(const E57Sample& scan, std::uint64_t logical)
{
  Bytes packets(false);
  std::size_t longest = 0;
  for (const std::string& stream : scan.Streams)
  {
    longest = std::max(longest, stream.size());
  }
  for (std::size_t at = 0; at < longest; at += scan.PacketBytes)
  {
    packets.text(std::string("\2\0\7\0", 4) + "skip")
      .text(std::string("\0\0\17\0", 4) + std::string(12, '\0'));
    Bytes parts(false);
    std::string text;
    for (const std::string& stream : scan.Streams)
    {
      const std::string part =
        at < stream.size() ? stream.substr(at, scan.PacketBytes) : std::string();
      parts.add(static_cast<std::uint16_t>(part.size()));
      text += part;
    }
    std::string data = parts.bytes() + text;
    data.resize((data.size() + 6 + 3) / 4 * 4 - 6);
    packets.text(std::string("\1\0", 2))
      .add(static_cast<std::uint16_t>(data.size() + 5))
      .add(static_cast<std::uint16_t>(scan.Streams.size()))
      .text(data);
  }
  return Bytes(false, std::string("\1\0\0\0\0\0\0\0", 8))
    .add(std::uint64_t(32 + packets.bytes().size()))
    .add(E57PhysicalOffset(logical + 32))
    .add(std::uint64_t(0))
    .text(packets.bytes())
    .bytes();
}

// Divide the contents of a file into pages with checksums.
inline std::string E57PagesOf(std::string contents)
{
  contents.resize((contents.size() + E57PageContents - 1) / E57PageContents * E57PageContents);
  std::string file;
  for (std::size_t at = 0; at < contents.size(); at += E57PageContents)
  {
    const std::string page = contents.substr(at, E57PageContents);
    file += page + Bytes(true).add(SlowCRC32C(page)).bytes();
  }
  return file;
}

// Return a file with the length and the checksums of its contents, which may have been changed.
inline std::string E57WithChecksums(const std::string& file)
{
  std::string contents;
  for (std::size_t page = 0; page < file.size(); page += 1024)
  {
    contents += file.substr(page, E57PageContents);
  }
  constexpr std::size_t lengthOffset = 16;
  const std::uint64_t pages = (contents.size() + E57PageContents - 1) / E57PageContents;
  const std::string length = Bytes(false).add(1024 * pages).bytes();
  if (contents.size() >= lengthOffset + length.size())
  {
    contents.replace(lengthOffset, length.size(), length);
  }
  return E57PagesOf(contents);
}

// Return the file of scans. The second text replaces the first in the XML.
inline std::string E57FileOf(
  const std::vector<E57Sample>& scans, const std::string& from = "<>", const std::string& to = "")
{
  std::string contents(48, '\0');
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" "
                    "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\" "
                    "xmlns:nor=\"http://www.libe57.org/E57_NOR_surface_normals.txt\">\n"
                    "<data3D type=\"Vector\" allowHeterogeneousChildren=\"1\">\n";
  for (const E57Sample& scan : scans)
  {
    const std::uint64_t logical = contents.size();
    contents += E57SectionOf(scan, logical);
    xml += "<vectorChild type=\"Structure\">" + scan.More + "<points type=\"CompressedVector\" " +
      "fileOffset=\"" + std::to_string(E57PhysicalOffset(logical)) + "\" recordCount=\"" +
      std::to_string(scan.Points) + "\">\n<prototype type=\"Structure\">\n" + scan.Prototype +
      "</prototype>\n</points></vectorChild>\n";
  }
  xml = replaced(xml + "</data3D></e57Root>\n", from, to);
  const std::uint64_t pages =
    (contents.size() + xml.size() + E57PageContents - 1) / E57PageContents;
  const std::string head = Bytes(false, "ASTM-E57")
                             .add(std::uint32_t(1))
                             .add(std::uint32_t(0))
                             .add(1024 * pages)
                             .add(E57PhysicalOffset(contents.size()))
                             .add(std::uint64_t(xml.size()))
                             .add(std::uint64_t(1024))
                             .bytes();
  return E57PagesOf(head + contents.substr(head.size()) + xml);
}

inline std::string E57FloatField(const std::string& name, bool isSingle = true)
{
  return "<" + name + " type=\"Float\"" + (isSingle ? " precision=\"single\"" : "") + "/>\n";
}

inline std::string E57IntegerField(const std::string& name, const std::string& minimum,
  const std::string& maximum, const std::string& scale = "")
{
  return "<" + name + " type=\"" + (scale.empty() ? "Integer" : "ScaledInteger") + "\" minimum=\"" +
    minimum + "\" maximum=\"" + maximum + "\"" + (scale.empty() ? "" : " scale=\"" + scale + "\"") +
    "/>\n";
}

inline std::string E57Pose(const std::vector<std::string>& numbers) // w, x, y, z; x, y, z
{
  return "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">" + numbers[0] +
    "</w><x type=\"Float\">" + numbers[1] + "</x><y type=\"Float\">" + numbers[2] +
    "</y><z type=\"Float\">" + numbers[3] + "</z></rotation><translation type=\"Structure\">" +
    "<x type=\"Float\">" + numbers[4] + "</x><y type=\"Float\">" + numbers[5] +
    "</y><z type=\"Float\">" + numbers[6] + "</z></translation></pose>";
}

// Return a scan of floats (i, 2 i, 0.5), with colors (i, 200, 7) and an intensity of 10 bits, i
// - 5.
inline E57Sample E57FloatScan(std::size_t points, const std::string& more = "")
{
  E57Sample scan;
  scan.More = more;
  scan.Points = points;
  Bytes x(false), y(false), z(false);
  std::vector<std::uint64_t> red, green, blue, intensity;
  for (std::size_t i = 0; i < points; ++i)
  {
    x.add(static_cast<float>(i));
    y.add(2.0F * static_cast<float>(i));
    z.add(0.5F);
    red.push_back(i % 256);
    green.push_back(200);
    blue.push_back(7);
    intensity.push_back(i % 1001);
  }
  scan.Prototype = E57FloatField("cartesianX") + E57FloatField("cartesianY") +
    E57FloatField("cartesianZ") + E57IntegerField("colorRed", "0", "255") +
    E57IntegerField("colorGreen", "0", "255") + E57IntegerField("colorBlue", "7", "7") +
    E57IntegerField("intensity", "-5", "995");
  scan.Streams = { x.bytes(), y.bytes(), z.bytes(), PackedBits(red, 8), PackedBits(green, 8), "",
    PackedBits(intensity, 10) };
  return scan;
}

// Return a scan in spherical coordinates of double precision, with a row and a column.
inline E57Sample E57SphericalScan()
{
  E57Sample scan;
  const double pi = 3.14159265358979323846;
  scan.Points = 4;
  scan.Prototype = E57FloatField("sphericalRange", false) +
    E57FloatField("sphericalAzimuth", false) + E57FloatField("sphericalElevation", false) +
    E57IntegerField("sphericalInvalidState", "0", "2") + E57IntegerField("rowIndex", "0", "1") +
    E57IntegerField("columnIndex", "-1", "40000") + "<remark type=\"String\"/>\n";
  scan.Streams = { Bytes(false).add(std::vector<double>{ 2, 3, 4, 5 }).bytes(),
    Bytes(false).add(std::vector<double>{ 0, pi / 2, 1, 0 }).bytes(),
    Bytes(false).add(std::vector<double>{ 0, 0, 1, pi / 2 }).bytes(), PackedBits({ 0, 0, 2, 0 }, 2),
    PackedBits({ 0, 0, 1, 1 }, 1), PackedBits({ 0, 1, 2, 40001 }, 16), "" };
  return scan;
}

inline std::string FromBase64(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('=')))
  {
    bits = (bits << 6) | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>((bits >> count) & 255U);
    }
  }
  return bytes;
}

// Return a file that pye57 0.4.19 wrote. Its 5 points are ((i - 2) 1.25, 0.001 i, -i), as integers
// of 0.001, with the state (0, 0, 2, 0, 1), intensity i / 4, color (60 i, 255 - i, i), row i,
// column 7, normal (1, 0, 0) and time i / 10. The pose has the quaternion (1, 1, 1, 1) / 2, which
// maps (x, y, z) to (z, x, y), and the translation (10, 20, 30).
inline std::string E57FromPye57()
{
  return FromBase64(
    "QVNUTS1FNTcBAAAAAAAAAAAMAAAAAAAAHAEAAAAAAADwCAAAAAAAAAAEAAAAAAAAAQAAAAAAAADsAAAAAAAAAFAA"
    "AAAAAAAAAAAAAAAAAAABAMsADgAKAAoACgACABQABQAFAAUAAgAAABQAFAAUACgAxImpgzipYUwdAIhT4qQ4LU6M"
    "EwCIE+iDu0Af6AMAIAEAAAAAAACAPgAAAD8AAEA/AACAPwA8eLTw//79/PsAAQIDBIhGAACAPwAAgD8AAIA/AACA"
    "PwAAgD8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACamZmZmZm5P5qZmZmZ"
    "mck/NDMzMzMz0z+amZmZmZnZPwA8P3htbCB2ZXJzaW9uPSIxLjAiIGVuY29kaW5nPSJVVEYtOCI/Pgo8ZTU3Um9v"
    "dCB0eXBlPSJTdHJ1Y3R1cmUiCiAgICAgICAgIHhtbG5zPSJodHRwOi8vd3d3LmFzdG0ub3JnL0NPTU1JVC9FNTcv"
    "MjAxMC1lNTctdjEuMCIKICAgICAgICAgeG1sbnM6bm9yPSJodHRwOi8vd3d3LmxpYmU1Ny5vcmcvRTU3X05PUl9z"
    "dXJmYWNlX25vcm1hbHMudHh0Ij4KICA8Zm9ybWF0TmFtZSB0eXBlPSJTdHJpbmciPjwhW0NEQVRBW0FTVE0gRTU3"
    "IDNEIEltYWdpbmcgRGF0YSBGaWxlXV0+PC9mb3JtYXROYW1lPgogIDxndWlkIHR5cGU9IlN0cmluZyI+PCFbQ0RB"
    "VEFbe0F9XV0+PC9ndWlkPgogIDx2ZXJzaW9uTWFqb3IgdHlwZT0iSW50ZWdlciI+MTwvdmVyc2lvbk1ham9yPgog"
    "IDxkYXRhM0QgdHlwZT0iVmVjdG9yIiBhbGxvd0hldGVyb2dlbmVvdXNDaGlsZHJlbj0iMSI+CiAgICA8dmVjdG9y"
    "Q2hpbGQgdHlwZT0iU3RydWN0dXJlIj4KICAgICAgPGd1aWQgdHlwZT0iU3RyaW5nIj48IVtDREFUQVt7Qn1dXT48"
    "L2d1aWQ+CiAgICAgIDxwb3NlIHR5cGU9IlN0cnVjdHVyZSI+CiAgICAgICAgPHJvdGF0aW9uIHR5cGU9IlN0cnVj"
    "dHVyZSI+CiAgICAgICAgICA8dyB0eXBlPSJGbG9hdCI+NWUtMDE8L3c+CiAgICAgICAgICA8eCB0eXBlPSJGbG9h"
    "dCI+NWUtMDE8L3g+CiAgICAgICAgICA8eSB0eXBlPSJGbG9hdCI+NWUtMDE8L3k+CiAgICAgICAgICA8eiB0eXBl"
    "PSJGbG9hdCI+NWUtMDE8L3o+CiAgICAgICAgPC9yWaRka290YXRpb24+CiAgICAgICAgPHRyYW5zbGF0aW9uIHR5"
    "cGU9IlN0cnVjdHVyZSI+CiAgICAgICAgICA8eCB0eXBlPSJGbG9hdCI+MWUrMDE8L3g+CiAgICAgICAgICA8eSB0"
    "eXBlPSJGbG9hdCI+MmUrMDE8L3k+CiAgICAgICAgICA8eiB0eXBlPSJGbG9hdCI+M2UrMDE8L3o+CiAgICAgICAg"
    "PC90cmFuc2xhdGlvbj4KICAgICAgPC9wb3NlPgogICAgICA8cG9pbnRzIHR5cGU9IkNvbXByZXNzZWRWZWN0b3Ii"
    "IGZpbGVPZmZzZXQ9IjQ4IiByZWNvcmRDb3VudD0iNSI+CiAgICAgICAgPHByb3RvdHlwZSB0eXBlPSJTdHJ1Y3R1"
    "cmUiPgogICAgICAgICAgPGNhcnRlc2lhblggdHlwZT0iU2NhbGVkSW50ZWdlciIgbWluaW11bT0iLTUwMDAiIG1h"
    "eGltdW09IjUwMDAiIHNjYWxlPSIxLjAwMDAwMDAwMDAwMDAwMDAyZS0wMyIvPgogICAgICAgICAgPGNhcnRlc2lh"
    "blkgdHlwZT0iU2NhbGVkSW50ZWdlciIgbWluaW11bT0iLTUwMDAiIG1heGltdW09IjUwMDAiIHNjYWxlPSIxLjAw"
    "MDAwMDAwMDAwMDAwMDAyZS0wMyIvPgogICAgICAgICAgPGNhcnRlc2lhblogdHlwZT0iU2NhbGVkSW50ZWdlciIg"
    "bWluaW11bT0iLTUwMDAiIG1heGltdW09IjUwMDAiIHNjYWxlPSIxLjAwMDAwMDAwMDAwMDAwMDAyZS0wMyIvPgog"
    "ICAgICAgICAgPGNhcnRlc2lhbkludmFsaWRTdGF0ZSB0eXBlPSJJbnRlZ2VyIiBtaW5pbXVtPSIwIiBtYXhpbXVt"
    "PSIyIi8+CiAgICAgICAgICA8aW50ZW5zaXR5IHR5cGU9IkZsb2F0IiBwcmVjaXNpb249InNpbmdsZSIgbWluaW11"
    "bT0iMCIgbWF4aW11bT0iMSIvPgogICAgICAgICAgPGNvbG9yUmVkIHR5cGU9IkludGVnZXIiIG1pbmltdW09IjAi"
    "IG1heGltdW09IjI1NSIvPgogICAgICAgICAgPGNvbG9yR3JlZW4gdHlwZT0iSW50ZWdlciIgbWluaW11bT0iMCIg"
    "bWF4aW11bT0iMjU1Ii8+CiAgICAgICAgICA8Y29sb3JCbHVlIHR5cGU9IkludGVnZXIiIG1pbmltdW09IjAiIG1h"
    "eGltdW09IjI1NSIvPgogICAgICAgICAgPHJvd0luZGV4IHR5cGU9IkludGVnZXIiIG1pbmltdW09IjAiIG1heKRc"
    "lxppbXVtPSI0Ii8+CiAgICAgICAgICA8Y29sdW1uSW5kZXggdHlwZT0iSW50ZWdlciIgbWluaW11bT0iNyIgbWF4"
    "aW11bT0iNyI+NzwvY29sdW1uSW5kZXg+CiAgICAgICAgICA8bm9yOm5vcm1hbFggdHlwZT0iRmxvYXQiIHByZWNp"
    "c2lvbj0ic2luZ2xlIiBtaW5pbXVtPSItMSIgbWF4aW11bT0iMSIvPgogICAgICAgICAgPG5vcjpub3JtYWxZIHR5"
    "cGU9IkZsb2F0IiBwcmVjaXNpb249InNpbmdsZSIgbWluaW11bT0iLTEiIG1heGltdW09IjEiLz4KICAgICAgICAg"
    "IDxub3I6bm9ybWFsWiB0eXBlPSJGbG9hdCIgcHJlY2lzaW9uPSJzaW5nbGUiIG1pbmltdW09Ii0xIiBtYXhpbXVt"
    "PSIxIi8+CiAgICAgICAgICA8dGltZVN0YW1wIHR5cGU9IkZsb2F0Ii8+CiAgICAgICAgPC9wcm90b3R5cGU+CiAg"
    "ICAgICAgPGNvZGVjcyB0eXBlPSJWZWN0b3IiIGFsbG93SGV0ZXJvZ2VuZW91c0NoaWxkcmVuPSIxIj4KICAgICAg"
    "ICA8L2NvZGVjcz4KICAgICAgPC9wb2ludHM+CiAgICA8L3ZlY3RvckNoaWxkPgogIDwvZGF0YTNEPgo8L2U1N1Jv"
    "b3Q+CiAgZXNpYW5aIHR5cGU9IlNjYWxlZEludGVnZXIiIG1pbmltdW09Ii01MDAwIiBtYXhpbXVtPSI1MDAwIiBz"
    "Y2FsZT0iMS4wMDAwMDAwMDAwMDAwMDAwMmUtMDMiLz4KICAgICAgICAgIDxjYXJ0ZXNpYW5JbnZhbGlkU3RhdGUg"
    "dHlwZT0iSW50ZWdlciIgbWluaW11bT0iMCIgbWF4aW11bT0iMiIvPgogICAgICAgICAgPGludGVuc2l0eSB0eXBl"
    "PSJGbG9hdCIgcHJlY2lzaW9uPSJzaW5nbGUiIG1pbmltdW09IjAiIG1heGltdW09IjEiLz4KICAgICAgICAgIDxj"
    "b2xvclJlZCB0eXBlPSJJbnRlZ2VyIiBtaW5pbXVtPSIwIiBtYXhpbXVtPSIyNTUiLz4KICAgICAgICAgIDxjb2xv"
    "ckdyZWVuIHR5cGU9IkludGVnZXIiIG1pbmltdW09IjAiIG1heGltdW09IjI1NSIvPgogICAgICAgICAgPGNvbG9y"
    "Qmx1ZSB0eXBlPSJJbnRlZ2VyIiBtaW5pbXVtPSIwIiBtYXhpbXVtPSIyNTUiLz4KICAgICAgICAgIDxyb3dJbmRl"
    "eCB0eXBlPSJJbnRlZ2VyIiBtaW5pbXVtPSIwIiBtYXjS3qw5");
}

inline std::vector<std::string> E57Files()
{
  const std::string pose = E57Pose({ "1", "0", "0", "0", "412000", "5318000", "500" });
  return { E57FromPye57(),
    E57FileOf({ E57FloatScan(3, pose), E57FloatScan(2, pose), E57FloatScan(0) }),
    E57FileOf({ E57SphericalScan() }) };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadE57Files()
{
  const E57Sample scan =
    E57FloatScan(3, "<description type=\"String\">" + std::string(1500, 'd') + "</description>");
  const std::string good = E57FileOf({ scan });
  const auto changed = [&](std::size_t at, const std::string& bytes) // with a right checksum
  {
    std::string contents;
    for (std::size_t page = 0; page < good.size(); page += 1024)
    {
      contents += good.substr(page, E57PageContents);
    }
    return E57PagesOf(contents.replace(at, bytes.size(), bytes));
  };
  const auto with = [&](const std::string& from, const std::string& to)
  { return E57FileOf({ scan }, from, to); };
  E57Sample large = scan;
  large.Streams[6] = PackedBits({ 0, 1, 1023 }, 10);
  E57Sample shortened = scan;
  shortened.Streams[1].resize(8);
  E57Sample lengthened = scan;
  lengthened.Streams[0] += std::string(12, '\0');
  E57Sample constant = scan;
  constant.Prototype = E57IntegerField("cartesianX", "1", "1") +
    E57IntegerField("cartesianY", "1", "1") + E57IntegerField("cartesianZ", "1", "1");
  constant.Streams = { "", "", "" };
  constant.Points = 4000000000;
  const std::string shared =
    "<vectorChild type=\"Structure\"><points type=\"CompressedVector\" "
    "fileOffset=\"48\" recordCount=\"200\"><prototype type=\"Structure\">" +
    scan.Prototype + "</prototype></points></vectorChild>";
  std::string damaged = good;
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  return { good.substr(0, good.size() - 1), good.substr(0, 1024), good + std::string(1024, '\0'),
    "ASTM-E57", damaged, changed(8, std::string("\2", 1)), changed(40, std::string("\0\2", 2)),
    changed(24, std::string("\375\3", 2)), changed(24, std::string(8, '\377')),
    changed(32, std::string(8, '\0')), changed(32, std::string(8, '\377')),
    changed(48, std::string("\0", 1)), changed(56, std::string("\40", 1)),
    changed(56, std::string(8, '\377')), changed(64, std::string(8, '\377')),
    changed(80, std::string("\3", 1)), changed(82, std::string("\6", 1)),
    changed(108, std::string("\10", 1)), changed(110, std::string("\377\377", 2)),
    with("recordCount=\"3\"", "recordCount=\"4\""),
    with("recordCount=\"3\"", "recordCount=\"18446744073709551615\""),
    with("recordCount=\"3\"", "recordCount=\"-3\""), with("fileOffset=\"48\"", "fileOffset=\"49\""),
    with("fileOffset=\"48\"", ""), with("fileOffset=\"48\"", "fileOffset=\"1021\""),
    with("CompressedVector", "Vector"), with("cartesianZ", "cartesianW"),
    with("cartesianZ", "cartesianX"), with("single", "triple"),
    with("type=\"Float\"", "type=\"Blob\""), with("minimum=\"-5\"", "minimum=\"996\""),
    with("maximum=\"995\"", "maximum=\"many\""), with("<e57Root", "<root"), with("</e57Root>", ""),
    with("<data3D", "<!DOCTYPE a [<!ENTITY b \"c\">]><data3D"),
    replaced(with("<e57Root", "<!DOCTYPE a [<!ENTITY b \"c\">]><e57Root"), "<>", ""),
    E57FileOf({ E57FloatScan(1, E57Pose({ "0", "0", "0", "0", "1", "2", "3" })) }),
    E57FileOf({ E57FloatScan(1, E57Pose({ "one", "0", "0", "0", "1", "2", "3" })) }),
    E57FileOf({ E57FloatScan(200) }, "</data3D>", shared + shared + shared + shared + "</data3D>"),
    E57FileOf({ large }), E57FileOf({ shortened }), E57FileOf({ lengthened }),
    E57FileOf({ constant }) };
}
}

#endif
