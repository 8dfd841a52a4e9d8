#include "PLY/PLYParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/FilePieces.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "PLY/PLYHeader.h"
#include "PLYSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceData;
using samples::AreSame;
using samples::ExpectArray;
using samples::find;
using samples::Ids;
using samples::polygonIds;
using samples::polygonOffsets;
using samples::values;

namespace
{
conformal::SurfaceResult parsePLY(std::string_view bytes, const conformal::PLYOptions& options = {},
  const conformal::ParseLimits& limits = {}, const conformal::Run& run = {})
{
  conformal::ByteReader input(bytes);
  return conformal::parsePLY(input, options, limits, run);
}

void ExpectTetrahedron(const conformal::SurfaceResult& result)
{
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const SurfaceData& data = result.Data;
  EXPECT_EQ(data.Points.Type, ScalarType::Float32);
  EXPECT_EQ(values<float>(data.Points), (std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }));
  EXPECT_EQ(polygonOffsets(data), (Ids{ 0, 3, 6, 9, 12 }));
  EXPECT_EQ(polygonIds(data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
  ExpectArray<std::uint8_t>(
    data.PointArrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 3, 4, 5, 6, 7, 8, 9, 250, 251, 252 });
  ExpectArray<double>(
    data.PointArrays, "confidence", ScalarType::Float64, 1, { 0.5, 0.25, 0.125, 1e-3 });
  ExpectArray<std::int16_t>(data.PointArrays, "label", ScalarType::Int16, 1, { -1, -2, -3, 32767 });
  ExpectArray<std::int32_t>(data.PolygonArrays, "group", ScalarType::Int32, 1, { 7, 8, 9, 10 });
}

// The refusal of a file: code, line and a part of the message.
void ExpectRefused(
  const std::string& bytes, ParseCode code, std::uint64_t line, const std::string& part)
{
  const conformal::SurfaceResult result = parsePLY(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_EQ(result.Status.Line, line) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
  EXPECT_EQ(result.Data.PolygonIds.size(), 0u);
}

std::string cloudOf(const std::string& properties, int count, const std::string& body)
{
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
    "end_header\n" + body;
}
const std::string XYZ = "property float x\nproperty float y\nproperty float z\n";
}

// What follows all that the header promises is counted, but for blanks.
TEST(PLYParser, CountsWhatItDoesNotRead)
{
  const auto unread = [](const std::string& bytes)
  {
    const conformal::SurfaceResult result = parsePLY(bytes);
    EXPECT_TRUE(result.Status.ok()) << result.Status.text();
    return result.Data.UnreadBytes;
  };
  const std::string points = "0 0 0\n1 0 0\n";
  EXPECT_EQ(unread(cloudOf(XYZ, 2, points)), 0u);
  EXPECT_EQ(unread(cloudOf(XYZ, 2, points + "\r\n \t\n")), 0u);
  EXPECT_EQ(unread(cloudOf(XYZ, 1, points)), 6u);
  EXPECT_EQ(unread(cloudOf(XYZ, 2, points + "\n0 1 0\n0 0 1\n")), 12u);
  for (const bool isLittle : { false, true })
  {
    const std::string mesh = samples::BinaryMesh(isLittle);
    EXPECT_EQ(unread(mesh), 0u);
    EXPECT_EQ(unread(mesh + "\n"), 0u);
    EXPECT_EQ(unread(mesh + std::string(7, '\0')), 7u);
  }
  // Of several readers the last one sees it.
  const std::string cloud = "ply\nformat binary_little_endian 1.0\nelement vertex 4\n" + XYZ +
    "end_header\n" + std::string(4 * 12 + 5, '\1');
  std::uint64_t sum = 0;
  for (std::uint64_t piece = 0; piece < 3; ++piece)
  {
    conformal::PLYOptions options;
    options.Piece = { piece, 3 };
    const conformal::SurfaceResult result = parsePLY(cloud, options);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(result.Data.UnreadBytes, piece == 2 ? 5u : 0u);
    sum += result.Data.Points.numberOfTuples();
  }
  EXPECT_EQ(sum, 4u);
}

TEST(PLYParser, ReadsEveryAttributeOfAnAsciiMesh)
{
  const conformal::SurfaceResult result = parsePLY(samples::AsciiMesh());
  ExpectTetrahedron(result);
  ExpectArray<float>(result.Data.PointArrays, "Normals", ScalarType::Float32, 3,
    { 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, -1 });
  ExpectArray<float>(result.Data.PointArrays, "TCoords", ScalarType::Float32, 2,
    { 0, 0.25F, 0, 0.5F, 1, 0.75F, 1, 1 });
  EXPECT_EQ(result.Data.PointArrays.size(), 5u);
}

TEST(PLYParser, ReadsBinaryOfBothOrdersWithElementsInAnyOrder)
{
  ExpectTetrahedron(parsePLY(samples::BinaryMesh(false)));
  ExpectTetrahedron(parsePLY(samples::BinaryMesh(true)));
  for (const bool isBig : { false, true })
  {
    const conformal::SurfaceResult cloud = parsePLY(samples::BinaryCloud(isBig));
    EXPECT_EQ(values<float>(cloud.Data.Points),
      (std::vector<float>{ 1.5F, -2.25F, 3.0F, 1e-30F, 1e30F, 0.1F }));
  }
}

TEST(PLYParser, ReadsEveryTypeByBothNames)
{
  const char* names[][2] = { { "char", "int8" }, { "uchar", "uint8" }, { "short", "int16" },
    { "ushort", "uint16" }, { "int", "int32" }, { "uint", "uint32" }, { "float", "float32" },
    { "double", "float64" } };
  for (int type = 0; type < 8; ++type)
  {
    for (const char* name : names[type])
    {
      const std::string extra = std::string("property ") + name + " extra\n";
      const conformal::SurfaceResult result = parsePLY(cloudOf(XYZ + extra, 1, "1 2 3 100\n"));
      ASSERT_TRUE(result.Status.ok()) << name;
      const conformal::NamedArray* array = find(result.Data.PointArrays, "extra");
      ASSERT_NE(array, nullptr);
      EXPECT_EQ(array->Type, static_cast<ScalarType>(type));
      conformal::withType(array->Type,
        [&](auto zero) { EXPECT_EQ(values<decltype(zero)>(*array)[0], decltype(zero)(100)); });
    }
  }
}

TEST(PLYParser, KeepsDoublesAndWidensWhatNoPointCanBe)
{
  const conformal::SurfaceResult doubles = parsePLY(samples::AsciiCloud());
  EXPECT_EQ(doubles.Data.Points.Type, ScalarType::Float64);
  EXPECT_EQ(values<double>(doubles.Data.Points)[3], 1234567.123456789);
  const conformal::SurfaceResult mixed = parsePLY(
    cloudOf("property int x\nproperty float y\nproperty uchar z\n", 1, "-2147483648 0.5 255\n"));
  EXPECT_EQ(values<double>(mixed.Data.Points), (std::vector<double>{ -2147483648.0, 0.5, 255 }));
  const conformal::SurfaceResult binary = parsePLY(
    samples::Binary(true, "element vertex 1\nproperty int x\nproperty float y\nproperty uchar z\n")
      .add<std::int32_t>(-5)
      .add(0.5F)
      .add<std::uint8_t>(200)
      .bytes());
  EXPECT_EQ(values<double>(binary.Data.Points), (std::vector<double>{ -5, 0.5, 200 }));
}

TEST(PLYParser, GroupsOnlyWhatBelongsTogether)
{
  // Colors with alpha; colors that are no bytes and a lone pair stay single.
  const conformal::SurfaceResult rgba = parsePLY(cloudOf(XYZ +
      "property uchar alpha\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property float u\nproperty float v\nproperty float nx\n",
    1, "0 0 0 4 1 2 3 0.5 0.75 1\n"));
  ExpectArray<std::uint8_t>(rgba.Data.PointArrays, "RGBA", ScalarType::UInt8, 4, { 1, 2, 3, 4 });
  ExpectArray<float>(rgba.Data.PointArrays, "TCoords", ScalarType::Float32, 2, { 0.5F, 0.75F });
  ExpectArray<float>(rgba.Data.PointArrays, "nx", ScalarType::Float32, 1, { 1 });
  const conformal::SurfaceResult floats =
    parsePLY(cloudOf(XYZ + "property float red\nproperty float green\nproperty float blue\n", 1,
      "0 0 0 0.1 0.2 0.3\n"));
  ExpectArray<float>(floats.Data.PointArrays, "red", ScalarType::Float32, 1, { 0.1F });
  // A property that has the name of a group keeps it.
  const conformal::SurfaceResult named = parsePLY(cloudOf(
    XYZ + "property float s\nproperty float t\nproperty int TCoords\n", 1, "0 0 0 1 2 3\n"));
  ExpectArray<std::int32_t>(named.Data.PointArrays, "TCoords", ScalarType::Int32, 1, { 3 });
  ExpectArray<float>(named.Data.PointArrays, "s", ScalarType::Float32, 1, { 1 });
}

TEST(PLYParser, ResolvesStripsIntoTrianglesOfOneWinding)
{
  const conformal::SurfaceResult result = parsePLY(samples::AsciiStrips());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  // 2 3 3 4 5: two triangles turn the strip, the third is the fifth corner's.
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 1, 2, 2, 1, 3, 3, 4, 5 }));
  EXPECT_EQ(polygonOffsets(result.Data), (Ids{ 0, 3, 6, 9 }));
  EXPECT_EQ(result.Data.DroppedPolygons, 0u);
}

TEST(PLYParser, JoinsNeighborsOfARangeGrid)
{
  const conformal::SurfaceResult result = parsePLY(samples::AsciiGrid());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  // 0 1 2    Two triangles of 0 3 4 1, cut by 1 3, which is shorter, since 0 is raised; 4 is too
  // 3 4 5    far from 2 and 5 by the default limit; one triangle of the three below.
  // - 6 7
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 3, 4, 1, 3, 1, 0, 6, 4, 3 }));
  EXPECT_EQ(polygonOffsets(result.Data), (Ids{ 0, 3, 6, 9 }));
  conformal::PLYOptions options;
  options.MaximumEdgeLength = 100.0;
  EXPECT_EQ(polygonOffsets(parsePLY(samples::AsciiGrid(), options).Data).size(), 8u);
  options.MaximumEdgeLength = 0.5;
  EXPECT_EQ(polygonOffsets(parsePLY(samples::AsciiGrid(), options).Data).size(), 1u);
}

TEST(PLYParser, RefusesGridsThatAreNone)
{
  const std::string& grid = samples::AsciiGrid();
  ExpectRefused(
    samples::replaced(grid, "num_rows 3", "num_rows 2"), ParseCode::Malformed, 19, "num_cols");
  ExpectRefused(
    samples::replaced(grid, "num_rows 3", "num_rows -3"), ParseCode::Malformed, 4, "count");
  ExpectRefused(samples::replaced(grid, "\n1 5\n", "\n1 8\n"), ParseCode::Malformed, 25, "id 8");
  // Nobody knows the shape of a grid of no size: its points are a cloud.
  const conformal::SurfaceResult cloud =
    parsePLY(samples::replaced(grid, "obj_info num_rows 3", "obj_info rows 3"));
  ASSERT_TRUE(cloud.Status.ok()) << cloud.Status.text();
  EXPECT_EQ(cloud.Data.PolygonIds.size(), 0u);
  EXPECT_EQ(cloud.Data.Points.numberOfTuples(), 8u);
}

TEST(PLYParser, IsBlindToLineEndsBlanksAndTheByteOrderMark)
{
  const std::string& mesh = samples::AsciiMesh();
  ExpectTetrahedron(parsePLY(samples::replaced(mesh, "\n", "\r\n")));
  ExpectTetrahedron(parsePLY(samples::replaced(mesh, "\n", "\r")));
  ExpectTetrahedron(parsePLY(samples::replaced(mesh, "\n", " \t \n\n")));
  ExpectTetrahedron(parsePLY(samples::replaced(mesh, " ", "\t ")));
  ExpectTetrahedron(parsePLY("\xEF\xBB\xBF" + mesh));
  ExpectTetrahedron(parsePLY(mesh.substr(0, mesh.size() - 1)));
  ExpectTetrahedron(
    parsePLY(samples::replaced(mesh, "a comment", std::string(1 << 20, 'c') + " ply")));
  ExpectTetrahedron(
    parsePLY(samples::replaced(mesh, " 0.2\n", " 0.2" + std::string(1 << 20, ' ') + "\n")));
}

TEST(PLYParser, BinaryDataMayStartWithALineFeed)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    const std::string header = samples::replaced("ply\nformat binary_little_endian 1.0\n"
                                                 "element vertex 1\nproperty uchar x\n"
                                                 "property uchar y\nproperty uchar z\nend_header\n",
      "\n", end);
    const conformal::SurfaceResult result = parsePLY(header + "\n\r\n");
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(values<double>(result.Data.Points), (std::vector<double>{ 10, 13, 10 }));
  }
}

TEST(PLYParser, ReadsTheSameFromPiecesAsFromMemory)
{
  const int count = 100000;
  const std::string header = "element vertex " + std::to_string(count) +
    "\nproperty float x\nproperty float y\nproperty float z\n"
    "property list uchar float extra\nproperty uchar label\nelement face " +
    std::to_string(count) + "\nproperty list uchar int vertex_index\nproperty int number\n";
  std::string ascii = "ply\nformat ascii 1.0\n" + header + "end_header\n";
  samples::Bytes binary = samples::Binary(true, header);
  for (int i = 0; i < count; ++i)
  {
    for (const float value : { float(i) / 7, float(i % 1009) * 1e-9F, -float(i) * 1e9F })
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.9g ", static_cast<double>(value));
      ascii += text;
      binary.add(value);
    }
    const int length = i % 5;
    ascii += std::to_string(length);
    binary.add(static_cast<std::uint8_t>(length));
    for (int j = 0; j < length; ++j)
    {
      ascii += " 0.25";
      binary.add(0.25F);
    }
    const int label = i % 251;
    ascii += " " + std::to_string(label) + "\n";
    binary.add(static_cast<std::uint8_t>(label));
  }
  for (int i = 0; i < count; ++i)
  {
    const int ids[] = { i, (i + 1) % count, (i * 7 + 3) % count };
    ascii += "3";
    binary.add<std::uint8_t>(3);
    for (const int id : ids)
    {
      ascii += " " + std::to_string(id);
      binary.add(id);
    }
    ascii += " " + std::to_string(-i) + "\n";
    binary.add(-i);
  }
  ASSERT_GT(binary.bytes().size(), std::size_t(3) << 20);
  const conformal::SurfaceResult expected = parsePLY(binary.bytes());
  ASSERT_TRUE(expected.Status.ok()) << expected.Status.text();
  ASSERT_GT(expected.Data.PolygonIds.size(), 0u);
  for (const std::string& bytes : { ascii, binary.bytes() })
  {
    conformal::ByteReader input = samples::InPieces(bytes);
    const conformal::SurfaceResult result = conformal::parsePLY(input);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_TRUE(AreSame(result.Data.Points, expected.Data.Points));
    EXPECT_TRUE(AreSame(result.Data.PointArrays[0], expected.Data.PointArrays[0]));
    EXPECT_TRUE(AreSame(result.Data.PolygonArrays[0], expected.Data.PolygonArrays[0]));
    EXPECT_TRUE(polygonIds(result.Data) == polygonIds(expected.Data));
    EXPECT_TRUE(polygonOffsets(result.Data) == polygonOffsets(expected.Data));
  }
  conformal::ByteReader broken = samples::InPieces(ascii.substr(0, ascii.size() - 7) + "x\n");
  EXPECT_EQ(conformal::parsePLY(broken).Status.Line, 12u + 2u * count);
}

TEST(PLYParser, ReadsAPolygonOfAMillionCorners)
{
  const int corners = 1000000;
  std::string body;
  for (int i = 0; i < corners; ++i)
  {
    body += "0 0 0\n";
  }
  body += std::to_string(corners);
  for (int i = 0; i < corners; ++i)
  {
    body += " " + std::to_string(i);
  }
  const conformal::SurfaceResult result =
    parsePLY(cloudOf(XYZ + "element face 1\nproperty list int int vertex_index\n", corners, body));
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(polygonOffsets(result.Data), (Ids{ 0, corners }));
}

TEST(PLYParser, IsBlindToTheLocale)
{
  const CommaLocale locale;
  const conformal::SurfaceResult result = parsePLY(samples::AsciiCloud());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<double>(result.Data.Points)[0], 0.5);
}

TEST(PLYParser, DropsPointsOfACloudThatAreNotFinite)
{
  const conformal::SurfaceResult result =
    parsePLY(cloudOf(XYZ + "property int id\n", 4, "0 0 0 1\n0 nan 0 2\n1 1 1 3\ninf 0 0 4\n"));
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<float>(result.Data.Points), (std::vector<float>{ 0, 0, 0, 1, 1, 1 }));
  ExpectArray<std::int32_t>(result.Data.PointArrays, "id", ScalarType::Int32, 1, { 1, 3 });
  EXPECT_EQ(result.Data.DroppedPoints, 2u);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const conformal::SurfaceResult binary = parsePLY(samples::Binary(true,
    "element vertex 3\nproperty float x\nproperty float y\nproperty uchar i\nproperty float z\n")
                                                     .add(nan)
                                                     .add(0.0F)
                                                     .add('a')
                                                     .add(0.0F)
                                                     .add(1.0F)
                                                     .add(2.0F)
                                                     .add('b')
                                                     .add(3.0F)
                                                     .add(0.0F)
                                                     .add(0.0F)
                                                     .add('c')
                                                     .add(-nan)
                                                     .bytes());
  ASSERT_TRUE(binary.Status.ok()) << binary.Status.text();
  EXPECT_EQ(values<float>(binary.Data.Points), (std::vector<float>{ 1, 2, 3 }));
  ExpectArray<std::uint8_t>(binary.Data.PointArrays, "i", ScalarType::UInt8, 1, { 'b' });
  EXPECT_EQ(binary.Data.DroppedPoints, 2u);
}

TEST(PLYParser, RefusesPointsOfAMeshThatAreNotFinite)
{
  ExpectRefused(samples::replaced(samples::AsciiMesh(), "1 0 0  0 1 0", "1 nan 0  0 1 0"),
    ParseCode::Malformed, 28, "vertex 1");
}

TEST(PLYParser, ReplacesAttributesThatAreNotFinite)
{
  const conformal::SurfaceResult result =
    parsePLY(samples::replaced(samples::AsciiMesh(), "0.25 0.5 -1", "nan -inf -1"));
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(result.Data.ReplacedValues, 2u);
  ExpectArray<double>(
    result.Data.PointArrays, "confidence", ScalarType::Float64, 1, { 0, 0.25, 0.125, 1e-3 });
}

TEST(PLYParser, DropsPolygonsThatAreNone)
{
  std::string mesh = samples::replaced(samples::AsciiMesh(), "7 3 0 2 1\n", "7 2 0 2\n");
  mesh = samples::replaced(mesh, "9 3 1 2 3\n", "9 4 1 2 3 1\n");
  const conformal::SurfaceResult result = parsePLY(mesh);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(result.Data.DroppedPolygons, 2u);
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 1, 3, 2, 0, 3 }));
  ExpectArray<std::int32_t>(result.Data.PolygonArrays, "group", ScalarType::Int32, 1, { 8, 10 });
}

TEST(PLYParser, RefusesWhatIsNoPLY)
{
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("solid cube\n", ParseCode::UnrecognizedType, 1, "solid cube");
  ExpectRefused("plywood\n", ParseCode::UnrecognizedType, 1, "plywood");
  ExpectRefused(std::string(100000, '\0'), ParseCode::UnrecognizedType, 1, "ply");
}

TEST(PLYParser, RefusesBadHeadersWithTheirLine)
{
  const std::string& mesh = samples::AsciiMesh();
  const auto refuse = [&](const char* from, const char* to, std::uint64_t line, const char* part)
  { ExpectRefused(samples::replaced(mesh, from, to), ParseCode::Malformed, line, part); };
  refuse("ascii", "ebcdic", 2, "ebcdic");
  refuse("ascii 1.0", "ascii 2.0", 2, "version");
  refuse("format ascii 1.0\n", "", 24, "format");
  refuse("comment a", "format ascii 1.0\ncomment a", 3, "one line");
  refuse("obj_info some", "vertices 4", 4, "keyword");
  refuse("element camera 1", "element camera", 5, "COUNT");
  refuse("element camera 1", "element camera -1", 5, "count");
  refuse("element camera 1", "element camera 1x", 5, "count");
  refuse("element vertex 4", "element vertex 99999999999999999999", 8, "count");
  refuse("element camera 1\n", "", 5, "element before");
  refuse("element camera", "element vertex", 8, "name once");
  refuse("property float y", "property float x", 10, "name once");
  refuse("property float y", "property quaternion y", 10, "type");
  refuse("property float y", "property float", 10, "NAME");
  refuse("list uchar int vertex_indices", "list float int vertex_indices", 24, "integer type");
  refuse("list uchar float lens", "list uchar lens", 7, "COUNT_TYPE");
  ExpectRefused(mesh.substr(0, mesh.find("end_header")), ParseCode::PrematureEnd, 25, "end_header");
  ExpectRefused(
    mesh.substr(0, mesh.find("property float nz") + 10), ParseCode::PrematureEnd, 14, "end_header");
}

TEST(PLYParser, RefusesElementsOfTheWrongShape)
{
  ExpectRefused(
    "ply\nformat ascii 1.0\nelement face 0\nend_header\n", ParseCode::Malformed, 5, "vertex");
  ExpectRefused(cloudOf("property float x\nproperty float y\n", 1, "0 0\n"), ParseCode::Malformed,
    7, "x, y and z");
  ExpectRefused(
    samples::replaced(samples::AsciiMesh(), "property float x", "property list uchar float x"),
    ParseCode::Malformed, 26, "x, y and z");
  ExpectRefused(samples::replaced(samples::AsciiMesh(), "vertex_indices", "corners"),
    ParseCode::Malformed, 30, "vertex_indices");
  ExpectRefused(samples::replaced(
                  samples::AsciiMesh(), "uchar int vertex_indices", "uchar float vertex_indices"),
    ParseCode::Malformed, 30, "vertex_indices");
}

TEST(PLYParser, RefusesBadNumbersWithTheirLine)
{
  for (const char* word : { "1.2.3", "--5", "0x1p3", "1e999", "1,5", "one" })
  {
    ExpectRefused(samples::replaced(samples::AsciiCloud(), "1234567.123456789", word),
      ParseCode::Malformed, 9, word);
  }
  ExpectRefused(
    samples::replaced(samples::AsciiMesh(), "4 5 6", "4 256 6"), ParseCode::Malformed, 28, "256");
  ExpectRefused(samples::replaced(samples::AsciiCloud(), "7 8 9", "7 8 9 10"), ParseCode::Malformed,
    10, "found \"10\" after the 3 numbers of a record, expected the end of the line");
  ExpectRefused(cloudOf(XYZ, 2, "1 2\n4 5 6\n"), ParseCode::Malformed, 9,
    "found \"5\" after the 3 numbers of a record, expected the end of the line; this line or the "
    "one before has a wrong number of columns");
  ExpectRefused(
    cloudOf(XYZ, 1, std::string(100000, '1') + " 0 0\n"), ParseCode::Malformed, 8, "111");
}

TEST(PLYParser, RefusesIdsOutOfRange)
{
  const std::string& mesh = samples::AsciiMesh();
  for (const char* id : { "4", "-1", "2147483647" })
  {
    ExpectRefused(samples::replaced(mesh, "8 3 0 1 3", std::string("8 3 0 1 ") + id),
      ParseCode::Malformed, 32, std::string("found id ") + id);
  }
  ExpectRefused(samples::replaced(samples::AsciiStrips(), "-1 2", "-2 2"), ParseCode::Malformed, 16,
    "found id -2");
  ExpectRefused(samples::replaced(samples::AsciiStrips(), "4 5", "4 6"), ParseCode::Malformed, 16,
    "found id 6");
}

TEST(PLYParser, RefusesCountsThatCannotBe)
{
  const auto counted = [](const char* format, const std::string& count)
  {
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex " + count + "\n" + XYZ +
      "end_header\n0 0 0\n";
  };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    for (const char* count : { "999999999", "4294967296", "9223372036854775807",
           "18446744073709551615", "6148914691236517206" })
    {
      EXPECT_EQ(parsePLY(counted(format, count)).Status.Code, ParseCode::Malformed) << count;
    }
    EXPECT_EQ(parsePLY(counted(format, "7")).Status.Code, ParseCode::PrematureEnd);
  }
  const std::string lists = XYZ + "element face 1\nproperty list int int vertex_index\n";
  ExpectRefused(
    cloudOf(lists, 1, "0 0 0\n2147483647 0 0 0\n"), ParseCode::Malformed, 11, "2147483647");
  ExpectRefused(cloudOf(lists, 1, "0 0 0\n-3 0 0 0\n"), ParseCode::Malformed, 11, "-3");
  ExpectRefused(cloudOf(lists, 1, "0 0 0\n9 0 0 0\n"), ParseCode::PrematureEnd, 11, "9 members");
}

TEST(PLYParser, HoldsTheCallersMemoryLimit)
{
  conformal::ParseLimits limits;
  limits.MaximumMemory = 10;
  EXPECT_EQ(parsePLY(samples::AsciiCloud(), {}, limits).Status.Code, ParseCode::OutOfMemory);
}

TEST(PLYParser, EveryTruncationIsRefused)
{
  const std::string ascii = samples::AsciiMesh();
  // The last number of a text may lose digits unseen, so cuts end before it.
  for (std::size_t size = 0; size < ascii.size() - 2; ++size)
  {
    EXPECT_FALSE(parsePLY(ascii.substr(0, size)).Status.ok()) << size;
  }
  const std::string binary = samples::BinaryMesh(true);
  const std::size_t body = binary.find("end_header\n") + 11;
  for (std::size_t size = 0; size < binary.size(); ++size)
  {
    const conformal::ParseStatus status = parsePLY(binary.substr(0, size)).Status;
    EXPECT_FALSE(status.ok()) << size;
    if (size >= body)
    {
      EXPECT_EQ(status.Code, ParseCode::PrematureEnd) << size << " " << status.text();
    }
  }
}

TEST(PLYParser, ReportsProgressAndStops)
{
  std::string body;
  for (int i = 0; i < 10000; ++i)
  {
    body += "0 0 0\n";
  }
  const std::string file = cloudOf(XYZ, 10000, body);
  double last = 0.0;
  int calls = 0;
  const conformal::Run watched({},
    [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      return ++calls < 20;
    });
  const conformal::SurfaceResult result = parsePLY(file, {}, {}, watched);
  EXPECT_EQ(result.Status.Code, ParseCode::Aborted);
  EXPECT_EQ(calls, 20);
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
  calls = -1000;
  last = 0.0;
  EXPECT_TRUE(parsePLY(file, {}, {}, watched).Status.ok());
  EXPECT_GT(last, 0.9);
}

TEST(PLYParser, IsKnownByItsFirstLines)
{
  EXPECT_TRUE(conformal::looksLikePLY(samples::AsciiMesh()));
  EXPECT_TRUE(conformal::looksLikePLY(samples::BinaryMesh(true)));
  EXPECT_TRUE(conformal::looksLikePLY("\xEF\xBB\xBFply \r\ncomment x\r\n"));
  for (const char* other : { "", "ply", "ply\n", "ply\nwood\n", "OFF\n", "plywood\nformat\n" })
  {
    EXPECT_FALSE(conformal::looksLikePLY(other)) << other;
  }
}

// Pieces for several processes ---------------------------------------------------------------

namespace
{
conformal::SurfaceResult parsePiece(conformal::ByteReader& input, const conformal::FilePiece& piece)
{
  conformal::PLYOptions options;
  options.Piece = piece;
  return conformal::parsePLY(input, options);
}

// So many points, one of which is not finite, with elements around them.
std::string BinaryCloud(bool big, std::size_t count, bool mixed)
{
  samples::Bytes file(big,
    std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement camera 1\nproperty float focal\nproperty list uchar short lens\n"
      "element vertex " +
      std::to_string(count) + "\nproperty float x\nproperty " + (mixed ? "double" : "float") +
      " y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property short label\nelement face 0\nproperty list uchar int vertex_indices\n"
      "element light 1\nproperty int color\nend_header\n");
  file.add(35.5F).add(std::uint8_t(1)).add(std::int16_t(7));
  for (std::size_t i = 0; i < count; ++i)
  {
    const float x = i == 1 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i);
    file.add(x);
    mixed ? file.add(0.5 * x) : file.add(0.5F * x);
    file.add(1.0F).add(std::uint8_t(i)).add(std::uint8_t(2)).add(std::uint8_t(3));
    file.add(static_cast<std::int16_t>(i % 1000));
  }
  file.add(std::int32_t(9));
  return file.bytes();
}
}

TEST(PLYParser, PiecesOfABinaryCloudMakeTheWhole)
{
  for (const bool big : { false, true })
  {
    for (const bool mixed : { false, true })
    {
      samples::ExpectPiecesMakeTheWhole(BinaryCloud(big, 17, mixed), parsePiece);
    }
  }
  samples::ExpectPiecesMakeTheWhole(BinaryCloud(false, 2, false), parsePiece);
  samples::ExpectPiecesReadTheirShare(BinaryCloud(false, 2000000, false), parsePiece);
}

TEST(PLYParser, WhatCannotBeCutIsAllInTheFirstPiece)
{
  for (const std::string& bytes : { samples::AsciiMesh(), samples::AsciiCloud() })
  {
    samples::ExpectPiecesMakeTheWhole(bytes, parsePiece);
    conformal::ByteReader input{ std::string_view(bytes) };
    EXPECT_EQ(parsePiece(input, { 1, 2 }).Data.Points.numberOfTuples(), 0u);
  }
}

TEST(PLYParser, EveryPieceOfACloudThatWasCutShortIsRefused)
{
  std::string bytes = BinaryCloud(false, 17, false);
  bytes.resize(bytes.size() - 30);
  for (std::uint64_t number = 0; number < 3; ++number)
  {
    conformal::ByteReader input{ std::string_view(bytes) };
    EXPECT_EQ(parsePiece(input, { number, 3 }).Status.Code, ParseCode::PrematureEnd);
  }
}
