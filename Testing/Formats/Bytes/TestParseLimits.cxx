// What a file costs: hostile ones no more than their limits, large ones in proportion.
#include "Bytes/ParseLimits.h"

#include "Bytes/LineReader.h"
#include "FreeSurfer/FreeSurferParser.h"
#include "GIFTI/GIFTIParser.h"
#include "GuMesh/GuMeshParser.h"
#include "MadeBytes.h"
#include "OFF/OFFParser.h"
#include "PCD/PCDParser.h"
#include "PLY/PLYParser.h"
#include "SPHARM/SPHARMCoefficients.h"
#include "SPHARM/SPHARMMesh.h"
#include "StanfordScans/AlignedScans.h"
#include "TextCloud/TextCloudParser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using conformal::ByteReader;
using conformal::LongestLine;
using conformal::ParseCode;
using conformal::SurfaceResult;

namespace
{
using Parse = std::function<SurfaceResult(ByteReader&)>;

SurfaceResult parseScans(ByteReader& input)
{
  const auto open = [](const std::string& name)
  {
    conformal::OpenedScan scan;
    scan.Identity = name;
    scan.Input = ByteReader(std::string_view("ply\nformat ascii 1.0\nelement vertex 1\n"
                                             "property float x\nproperty float y\n"
                                             "property float z\nend_header\n1 2 3\n"));
    return scan;
  };
  return conformal::parseAlignedScans(input, open);
}

SurfaceResult parseLenientText(ByteReader& input)
{
  conformal::TextCloudOptions options;
  options.SkipMalformedLines = true;
  return conformal::parseTextCloud(input, options);
}

const Parse PLY = [](ByteReader& input) { return conformal::parsePLY(input); };
const Parse PCD = [](ByteReader& input) { return conformal::parsePCD(input); };
const Parse OFF = [](ByteReader& input) { return conformal::parseOFF(input); };
const Parse GuMesh = [](ByteReader& input) { return conformal::parseGuMesh(input); };
const Parse Text = [](ByteReader& input) { return conformal::parseTextCloud(input); };
const Parse Shape = [](ByteReader& input) { return conformal::parseGIFTIArrays(input); };
const Parse Surface = [](ByteReader& input) { return conformal::parseGIFTISurface(input); };
const Parse SPHARMCoefficients = [](ByteReader& input)
{ return conformal::parseSPHARMCoefficients(input); };
const Parse SPHARMMesh = [](ByteReader& input) { return conformal::parseSPHARMMesh(input); };
const Parse FreeSurfer = [](ByteReader& input) { return conformal::parseFreeSurferSurface(input); };

// A file of 5 GB: a start, then one byte for ever. Counts what is read of it.
ByteReader endless(const std::string& start, char filler, std::uint64_t& numberRead)
{
  numberRead = 0;
  return ByteReader(
    [start, filler, &numberRead](char* buffer, std::size_t size)
    {
      std::memset(buffer, filler, size);
      const std::size_t there = std::min<std::uint64_t>(numberRead, start.size());
      std::memcpy(buffer, start.data() + there, std::min(size, start.size() - there));
      numberRead += size;
      return size;
    },
    std::uint64_t(5) << 30);
}

double secondsOf(const Parse& parse, const std::string& bytes)
{
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i)
  {
    ByteReader input{ std::string_view(bytes) };
    const std::clock_t begin = std::clock(); // of this process, whatever else the machine does
    const SurfaceResult result = parse(input);
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    EXPECT_TRUE(result.Status.ok()) << result.Status.text();
  }
  return best;
}

using MakeFile = std::function<std::string(int)>;

// 16 times the size takes 16 times as long, or 256 times where costs are quadratic.
void ExpectLinear(const Parse& parse, const MakeFile& make, int size)
{
  const double small = secondsOf(parse, make(size));
  const double large = secondsOf(parse, make(16 * size));
  testing::Test::RecordProperty("seconds", std::to_string(small) + " " + std::to_string(large));
  EXPECT_LT(large, 64.0 * std::max(small, 1e-4));
}

std::string repeated(int count, const std::function<std::string(int)>& make)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += make(i);
  }
  return text;
}

std::string numbered(const char* before, int i, const char* after = "")
{
  return before + std::to_string(i) + after;
}

std::string plyOf(int count, const std::function<std::string(int)>& property)
{
  return "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
         "property float y\nproperty float z\n" +
    repeated(count, [&](int i) { return "property float " + property(i) + "\n"; }) +
    "end_header\n" + std::string(4 * (static_cast<std::size_t>(count) + 3), '\0');
}

std::string pcdOf(int count, const char* sizeOfX)
{
  const auto words = [&](const std::string& start, const std::string& word)
  { return start + repeated(count, [&](int) { return word; }) + "\n"; };
  return "FIELDS x y z" + repeated(count, [](int i) { return numbered(" p", i); }) + "\nSIZE " +
    sizeOfX + words(" 4 4", " 4") + words("TYPE F F F", " F") + "POINTS 1\nDATA binary\n" +
    std::string(4 * (static_cast<std::size_t>(count) + 4), '\0');
}
}

TEST(ParseLimits, EndlessLinesAreRefusedBeforeTheyAreInMemory)
{
  const std::string ply = "ply\nformat ascii 1.0\n";
  const std::string vertices = "element vertex 1\nproperty float x\nproperty float y\n"
                               "property float z\nend_header\n";
  const std::string tag = "<?xml version=\"1.0\"?><GIFTI Version=\"1.0\" ";
  const std::vector<std::pair<Parse, std::vector<std::string>>> starts = {
    { PLY,
      { "", "ply", ply, ply + "comment ", ply + "element ", ply + vertices,
        ply + vertices + "1 2 " } },
    { PCD, { "", "# ", "VERSION .7\n", "VERSION .7\nFIELDS x y z ", "VERSION .7\n# " } },
    { OFF,
      { "", "# ", "OFF", "OFF # ", "OFF\n1 0 0\n", "OFF\n1 0 0\n0 0 0 # ",
        "OFF\n2 0 0\n0 0 0\n" } },
    { GuMesh,
      { "", "# ", "Vertex ", "Vertex 1 0 0 0 {", "Vertex 1 0 0 0\n", "Vertex 1 0 0 0\nEdge " } },
    { parseScans, { "", "# ", "camera ", "mesh a 0 0 0 0 0 0 1\n", "mesh " } },
    { Text,
      { "", "# ", "1 2 3\n", "1 2 3\n# ", "x y z ", "1\n1 2 3\n",
        repeated(1000, [](int) { return "1 2 3\n"; }) } },
    { parseLenientText, { "", "1 2 3\n", repeated(1000, [](int) { return "1 2 3\n"; }) } },
    { Surface,
      { "", "<", tag, tag + "NumberOfDataArrays=\"", tag + "NumberOfDataArrays=\"2\">",
        tag + "NumberOfDataArrays=\"2\"><!--" } },
    { SPHARMCoefficients, { "", "{", "{ 4,{", "{ 4,{1, 2" } },
    { SPHARMMesh,
      { "", "# vtk DataFile Version 3.0\n", "# vtk DataFile Version 3.0\ntitle\nASCII\n",
        "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n" } },
    { FreeSurfer,
      { "", "\xFF\xFF\xFE",
        "\xFF\xFF\xFE"
        "by me\n" } },
  };
  std::size_t number = 0;
  for (const auto& [parse, texts] : starts)
  {
    for (const std::string& start : texts)
    {
      for (const char filler : { '\0', ' ', '7', '-' })
      {
        std::uint64_t numberRead = 0;
        ByteReader input = endless(start, filler, numberRead);
        const SurfaceResult result = parse(input);
        SCOPED_TRACE(std::to_string(number) + " " + start + filler + ": " + result.Status.text());
        EXPECT_FALSE(result.Status.ok());
        EXPECT_TRUE(result.Status.Code == ParseCode::Malformed ||
          result.Status.Code == ParseCode::UnrecognizedType);
        EXPECT_LE(numberRead, 2 * LongestLine);
      }
    }
    ++number;
  }
}

TEST(ParseLimits, TheLongestLineIsTheSameWhereverItLies)
{
  for (const std::size_t before : { 0, 1, 1000000, (1 << 20) - 1, 3000000 })
  {
    for (const std::size_t length : { LongestLine - 1, LongestLine, LongestLine + 1 })
    {
      for (const char* end : { "\n", "\r\n", "\r", "" })
      {
        const std::string bytes =
          std::string(before, 'b') + "\n" + std::string(length, 'a') + end + "rest";
        std::size_t position = 0;
        ByteReader input(
          [&](char* buffer, std::size_t size)
          {
            const std::size_t count = std::min(size, bytes.size() - position);
            std::memcpy(buffer, bytes.data() + position, count);
            position += count;
            return count;
          },
          bytes.size());
        conformal::LineReader lines(input);
        ASSERT_TRUE(lines.next());
        const std::size_t whole = length + (*end ? 0 : 4);
        if (whole > LongestLine)
        {
          EXPECT_THROW(lines.next(), conformal::ParseError) << before << " " << length;
          continue;
        }
        ASSERT_TRUE(lines.next());
        EXPECT_EQ(lines.text().size(), whole);
      }
    }
  }
}

TEST(ParseLimits, PolygonOfAMillionCornersIsALine)
{
  constexpr int corners = 1000000;
  const std::string bytes =
    repeated(corners, [](int i) { return numbered("Vertex ", i, " 0 0 0\n"); }) + "Face 1" +
    repeated(corners, [](int i) { return numbered(" ", i); }) + "\n";
  ByteReader input{ std::string_view(bytes) };
  const SurfaceResult result = conformal::parseGuMesh(input);
  EXPECT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(result.Data.PolygonIds.size(), static_cast<std::size_t>(corners));
}

TEST(ParseLimits, NumbersAreReadWholeOrNotAtAll)
{
  const std::string head = "OFF\n1 0 0\n0 0 ";
  for (const std::size_t blanks : { 0, 1040000, 1045000, 1048000 }) // up to the end of a window
  {
    for (const std::size_t digits : { 4094, 4095, 20000 })
    {
      const std::string bytes =
        "#" + std::string(blanks, ' ') + "\n" + head + "0." + std::string(digits, '0') + "1\n";
      std::size_t position = 0;
      ByteReader input(
        [&](char* buffer, std::size_t size)
        {
          const std::size_t count = std::min(size, bytes.size() - position);
          std::memcpy(buffer, bytes.data() + position, count);
          position += count;
          return count;
        },
        bytes.size());
      const SurfaceResult result = conformal::parseOFF(input);
      EXPECT_EQ(result.Status.ok(), digits + 3 <= 4096) << result.Status.text();
    }
  }
}

TEST(ParseLimits, HeadersCostInProportionToTheirProperties)
{
  constexpr int size = 5000;
  const MakeFile plain = [](int count)
  { return plyOf(count, [](int i) { return numbered("p", i); }); };
  const MakeFile pairs = [](int count)
  {
    return plyOf(
      count, [](int i) { return "p" + std::to_string(i / 2) + "_" + std::to_string(i % 2); });
  };
  const MakeFile elements = [](int count)
  {
    return "ply\nformat ascii 1.0\n" +
      repeated(count, [](int i) { return numbered("element e", i, " 0\nproperty int a\n"); }) +
      "element vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n1 2 3\n";
  };
  ExpectLinear(PLY, plain, size);
  ExpectLinear(PLY, pairs, size);
  ExpectLinear(PLY, elements, size / 2);
  ExpectLinear(
    PCD, [](int count) { return pcdOf(count, "4"); }, size);
  ExpectLinear(
    PCD, [](int count) { return pcdOf(count, "8"); }, size);
}

TEST(ParseLimits, ArraysOfOneNameCostInProportion)
{
  const MakeFile shapes = [](int count)
  {
    return numbered("<GIFTI Version=\"1.0\" NumberOfDataArrays=\"", count, "\">") +
      repeated(count,
        [](int)
        {
          return "<DataArray Intent=\"NIFTI_INTENT_SHAPE\" DataType=\"NIFTI_TYPE_UINT8\" "
                 "Dimensionality=\"1\" Dim0=\"1\" Encoding=\"ASCII\"><Data>1</Data></DataArray>";
        }) +
      "</GIFTI>";
  };
  ExpectLinear(Shape, shapes, 150);
}

TEST(ParseLimits, NoIdsOfVerticesAreSlow)
{
  // Multiples of a prime: all in one bucket of a hash table of that size.
  for (const std::int64_t step : { 1, 3, 172933, 107897 })
  {
    const MakeFile mesh = [&](int count)
    {
      return "Vertex -5 0 0 0\n" +
        repeated(count, [&](int i) { return "Vertex " + std::to_string(step * i) + " 0 0 0\n"; });
    };
    ExpectLinear(GuMesh, mesh, 6000);
  }
}
