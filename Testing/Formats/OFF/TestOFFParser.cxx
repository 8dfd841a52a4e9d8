#include "OFF/OFFParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "OFFSamples.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::Ids;
using samples::polygonIds;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseOFF(input);
}

void ExpectTetrahedron(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text() << "\n" << bytes.substr(0, 200);
  EXPECT_EQ(values<double>(result.Data.Points),
    (std::vector<double>{ 0, 0, 0, 1.5, 0, 0, 0, 1, 0, 0, 0, 1e-3 }));
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
  EXPECT_TRUE(result.Data.PointArrays.empty() && result.Data.PolygonArrays.empty());
}

void ExpectRefused(
  const std::string& bytes, ParseCode code, std::uint64_t line, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text() << "\n" << bytes.substr(0, 200);
  EXPECT_EQ(result.Status.Line, line) << result.Status.text() << "\n" << bytes.substr(0, 200);
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}

using samples::replaced;
}

TEST(OFFParser, ReadsAPlainFileHoweverItIsWritten)
{
  const CommaLocale locale;
  const std::string& plain = samples::PlainOFF();
  ExpectTetrahedron(plain);
  for (const std::string end : { "\r\n", "\r", "\n\n", " \t\n", " # a remark\n#another\n" })
  {
    ExpectTetrahedron(replaced(plain, "\n", end));
  }
  ExpectTetrahedron("\xEF\xBB\xBF# first\n" + plain);
  ExpectTetrahedron(plain.substr(0, plain.size() - 1));
  ExpectTetrahedron(plain.substr(4)); // without its keyword
  ExpectTetrahedron(replaced(plain, "OFF\n", "OFF "));
  ExpectTetrahedron(replaced(plain, "4 4 6", "4 4"));
  ExpectTetrahedron(replaced(plain, "4 4 6", "4\n4\n6"));
  ExpectTetrahedron(replaced(plain, "0 0 0\n", "0\n0\n0\n"));
  ExpectTetrahedron(replaced(plain, "\n", std::string(1 << 20, ' ') + "\n"));
}

TEST(OFFParser, ReadsWhatEveryPrefixSays)
{
  const SurfaceResult rich = parse(samples::RichOFF());
  ASSERT_TRUE(rich.Status.ok()) << rich.Status.text();
  ExpectArray<double>(rich.Data.PointArrays, "Normals", ScalarType::Float64, 3,
    { 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, -1 });
  ExpectArray<double>(
    rich.Data.PointArrays, "TCoords", ScalarType::Float64, 2, { 0, 0.25, 0, 0.5, 1, 0.75, 1, 1 });
  ExpectArray<std::uint8_t>(rich.Data.PointArrays, "RGBA", ScalarType::UInt8, 4,
    { 255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 255, 255, 255, 255, 0 });
  ExpectArray<std::uint8_t>(rich.Data.PolygonArrays, "RGB", ScalarType::UInt8, 3,
    { 255, 128, 0, 255, 255, 255, 255, 255, 255 });
  ExpectArray<std::int32_t>(
    rich.Data.PolygonArrays, "ColorIndex", ScalarType::Int32, 1, { -1, -1, 7 });
  const SurfaceResult plain = parse(samples::OFFFiles().back());
  ExpectArray<std::uint8_t>(
    plain.Data.PointArrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 3, 4, 5, 6, 7, 8, 9 });
  const SurfaceResult homogeneous = parse(samples::OFFFiles()[4]);
  EXPECT_EQ(
    values<double>(homogeneous.Data.Points), (std::vector<double>{ 0, 0, 0, 1, 0, 0, 0, 0.5, 0 }));
}

TEST(OFFParser, PrefixesMayBeInAnyOrder)
{
  const std::string body = "OFF\n1 0 0\n0 0 0  0 0 1  255 0 0 255  0.5 0.25\n";
  for (const char* prefixes : { "STCN", "CSTN", "NCST", "CNST", "NSTC", "STNC" })
  {
    const SurfaceResult result = parse(prefixes + body);
    ASSERT_TRUE(result.Status.ok()) << prefixes << result.Status.text();
    ExpectArray<double>(result.Data.PointArrays, "Normals", ScalarType::Float64, 3, { 0, 0, 1 });
    ExpectArray<double>(result.Data.PointArrays, "TCoords", ScalarType::Float64, 2, { 0.5, 0.25 });
  }
}

TEST(OFFParser, IndicesOfColorsAreWholeNumbers)
{
  const std::string mesh = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  EXPECT_TRUE(parse(mesh + "7\n").Status.ok());
  for (const char* index : { "0.5", "-1", "7.25", "3e9", "nan" })
  {
    EXPECT_EQ(parse(mesh + index + "\n").Status.Code, ParseCode::Malformed) << index;
  }
}

TEST(OFFParser, ReadsBinaryFiles)
{
  const SurfaceResult result = parse(samples::BinaryOFF());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<float>(result.Data.Points),
    (std::vector<float>{ 0, 0, 0.1F, 0.5F, 1, 0.1F, 1, 0, 0.1F }));
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 1, 2 }));
  ExpectArray<float>(
    result.Data.PointArrays, "Normals", ScalarType::Float32, 3, { 0, 0, 1, 0, 0, 1, 0, 0, 1 });
  ExpectArray<std::uint8_t>(result.Data.PointArrays, "RGBA", ScalarType::UInt8, 4,
    { 255, 128, 0, 255, 255, 128, 0, 255, 255, 128, 0, 255 });
  ExpectArray<std::uint8_t>(result.Data.PolygonArrays, "RGB", ScalarType::UInt8, 3, { 0, 255, 0 });
  const std::string file = samples::BinaryOFF();
  const std::size_t body = file.find('\n') + 1;
  for (std::size_t size = body; size < file.size(); ++size)
  {
    EXPECT_EQ(parse(file.substr(0, size)).Status.Code, ParseCode::PrematureEnd) << size;
  }
  const auto word = [&](std::size_t index, std::int32_t value)
  {
    std::string broken = file;
    const std::size_t at = body + 4 * index;
    broken.replace(at, 4, samples::Bytes(true).add(value).bytes());
    return broken;
  };
  ExpectRefused(word(0, -1), ParseCode::Malformed, 0, "-1");
  ExpectRefused(word(0, 2147483647), ParseCode::Malformed, 0, "2147483647");
  ExpectRefused(word(1, 2147483647), ParseCode::Malformed, 0, "2147483647");
  ExpectRefused(word(33, -3), ParseCode::Malformed, 0, "-3");
  ExpectRefused(word(34, 3), ParseCode::Malformed, 0, "found id 3");
  ExpectRefused(word(37, 2), ParseCode::Malformed, 0, "color of 2");
}

TEST(OFFParser, DropsPolygonsAndPointsThatAreNone)
{
  std::string bytes = replaced(samples::PlainOFF(), "3 0 2 1\n", "2 0 2\n");
  bytes = replaced(bytes, "3 1 2 3\n", "3 1 2 1\n");
  const SurfaceResult polygons = parse(bytes);
  EXPECT_EQ(polygons.Data.DroppedPolygons, 2u);
  EXPECT_EQ(polygonIds(polygons.Data), (Ids{ 0, 1, 3, 2, 0, 3 }));
  const SurfaceResult points = parse("OFF\n2 0 0\nnan 0 0 1 2 3\n1 1 1 4 5 6\n");
  EXPECT_EQ(points.Data.DroppedPoints, 1u);
  ExpectArray<std::uint8_t>(points.Data.PointArrays, "RGB", ScalarType::UInt8, 3, { 4, 5, 6 });
}

TEST(OFFParser, RefusesBrokenFilesWithTheirLine)
{
  const std::string& plain = samples::PlainOFF();
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("ply\n", ParseCode::UnrecognizedType, 1, "ply");
  ExpectRefused("OFFX\n", ParseCode::UnrecognizedType, 1, "OFFX");
  ExpectRefused("# only remarks\n", ParseCode::UnrecognizedType, 2, "OFF");
  ExpectRefused("nOFF 4\n1 0 0\n0 0 0 0\n", ParseCode::Malformed, 1, "3 dimensions");
  ExpectRefused(replaced(plain, "4 4 6", "5 4 6"), ParseCode::Malformed, 7, "numbers after");
  ExpectRefused(replaced(plain, "4 4 6", "4 5 6"), ParseCode::PrematureEnd, 11, "ends");
  ExpectRefused(replaced(plain, "4 4 6", "4 3 6"), ParseCode::Malformed, 10, "end of the file");
  ExpectRefused(replaced(plain, "4 4 6", "-4 4 6"), ParseCode::Malformed, 2, "-4");
  ExpectRefused(replaced(plain, "4 4 6", "4000000000 4"), ParseCode::Malformed, 2, "4000000000");
  ExpectRefused(replaced(plain, "4 4 6", "4 4000000000"), ParseCode::Malformed, 6, "4000000000");
  for (const char* word : { "1.2.3", "--5", "0x1p3", "1e999", "1,5", "one" })
  {
    ExpectRefused(replaced(plain, "1.5", word), ParseCode::Malformed, 4, word);
  }
  ExpectRefused(replaced(plain, "1.5", "nan"), ParseCode::Malformed, 4, "not finite");
  ExpectRefused(replaced(plain, "3 1 2 3", "3 1 2 4"), ParseCode::Malformed, 9, "found id 4");
  ExpectRefused(replaced(plain, "3 1 2 3", "-3 1 2 3"), ParseCode::Malformed, 9, "-3");
  ExpectRefused(replaced(plain, "3 1 2 3", "3 1 2 3 1 1"), ParseCode::Malformed, 9, "color");
  ExpectRefused(replaced(plain, "3 1 2 3", "3 1 2 3 1 1 300"), ParseCode::Malformed, 9, "300");
  ExpectRefused(replaced(plain, "3 1 2 3", "3 1 2 3 1 1 1 1 1 1 1"), ParseCode::Malformed, 9, "1");
  ExpectRefused(replaced(plain, "OFF\n", "COFF\n"), ParseCode::Malformed, 3, "colors");
  ExpectRefused(replaced(plain, "OFF\n", "STOFF\n"), ParseCode::Malformed, 3, "coordinates");
}

TEST(OFFParser, ReadsTheSameFromPiecesAsFromMemory)
{
  const int count = 60000;
  std::string bytes = "COFF\n" + std::to_string(count) + " " + std::to_string(count) + " 0\n";
  for (int i = 0; i < count; ++i)
  {
    bytes += std::to_string(i * 0.37) + " 0 " + std::to_string(-i) + " 1 2 " +
      std::to_string(i % 256) + " 255\n";
  }
  for (int i = 0; i < count; ++i)
  {
    bytes += "3 " + std::to_string(i) + " " + std::to_string((i + 1) % count) + " " +
      std::to_string((i + 2) % count) + " # face\r\n";
  }
  conformal::ByteReader pieces = samples::InPieces(bytes);
  const SurfaceResult windowed = conformal::parseOFF(pieces);
  const SurfaceResult whole = parse(bytes);
  ASSERT_TRUE(windowed.Status.ok()) << windowed.Status.text();
  EXPECT_TRUE(samples::AreSame(windowed.Data.Points, whole.Data.Points));
  EXPECT_TRUE(samples::AreSame(windowed.Data.PointArrays[0], whole.Data.PointArrays[0]));
  EXPECT_TRUE(polygonIds(windowed.Data) == polygonIds(whole.Data));
  EXPECT_EQ(whole.Data.PolygonIds.size(), std::size_t(3) * count);
}

TEST(OFFParser, IsKnownByItsKeyword)
{
  for (const std::string& file : samples::OFFFiles())
  {
    EXPECT_TRUE(conformal::looksLikeOFF(file)) << file;
  }
  for (const char* other : { "", "O", "OFFICE\n", "4 4 6\n0 0 0\n", "FOFF\n", "ply\n" })
  {
    EXPECT_FALSE(conformal::looksLikeOFF(other)) << other;
  }
}
