#include "GuMesh/GuMeshParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "GuMeshSamples.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::Ids;
using samples::polygonIds;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseGuMesh(input);
}

void ExpectTetrahedron(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
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
}

TEST(GuMeshParser, ReadsAPlainMeshHoweverItIsWritten)
{
  const CommaLocale locale;
  const std::string& plain = samples::PlainGuMesh();
  ExpectTetrahedron(plain);
  for (const std::string end : { "\r\n", "\r", "\n\n", " \t\n", "\n# a remark\n", " {}\n" })
  {
    ExpectTetrahedron(replaced(plain, "\n", end));
  }
  ExpectTetrahedron("\xEF\xBB\xBF" + plain);
  ExpectTetrahedron(plain.substr(0, plain.size() - 1));
  ExpectTetrahedron(replaced(plain, " ", "\t "));
  ExpectTetrahedron(replaced(
    plain, "Vertex 4 0 0 1e-3", "Vertex 4 0 0 1e-3 {note=(" + std::string(1 << 20, 'x') + ")}"));
}

TEST(GuMeshParser, ReadsTraitsAndSparseIds)
{
  const SurfaceResult result = parse(samples::RichGuMesh());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3 }));
  ExpectArray<double>(
    arrays, "SpherePosition", ScalarType::Float64, 3, { 0, 0, 1, 1, 0, 0, 0, 1, 0, 0.6, 0, 0.8 });
  ExpectArray<double>(
    arrays, "Normals", ScalarType::Float64, 3, { 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0 });
  ExpectArray<double>(arrays, "TCoords", ScalarType::Float64, 2, { 0, 0.25, 0, 0.5, 0, 0, 0, 0 });
  ExpectArray<std::uint8_t>(
    arrays, "RGB", ScalarType::UInt8, 3, { 255, 0, 0, 255, 255, 255, 0, 128, 255, 255, 255, 255 });
  ExpectArray<std::uint8_t>(result.Data.PolygonArrays, "RGB", ScalarType::UInt8, 3,
    { 0, 255, 0, 255, 255, 255, 255, 255, 255 });
}

TEST(GuMeshParser, DropsPolygonsThatAreNone)
{
  std::string bytes = replaced(samples::PlainGuMesh(), "Face 1 1 3 2", "Face 1 1 3");
  bytes = replaced(bytes, "Face 3 2 3 4", "Face 3 2 3 2");
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Data.DroppedPolygons, 2u);
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 1, 3, 2, 0, 3 }));
}

TEST(GuMeshParser, RefusesBrokenFilesWithTheirLine)
{
  const std::string& plain = samples::PlainGuMesh();
  const auto refuse = [&](const char* from, const char* to, std::uint64_t line, const char* part)
  { ExpectRefused(replaced(plain, from, to), ParseCode::Malformed, line, part); };
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("# nothing\n", ParseCode::PrematureEnd, 2, "no vertices");
  ExpectRefused("% matlab\nx = 1;\n", ParseCode::UnrecognizedType, 1, "matlab");
  refuse("1.5", "1.2.3", 3, "finite numbers");
  refuse("1.5", "nan", 3, "finite numbers");
  refuse("Vertex 2", "Vertex 1", 3, "once");
  refuse("Face 2 1 2 4", "Face 2 1 2 5", 7, "found id 5");
  refuse("Face 2 1 2 4", "Face 2 1 2 x", 7, "ids");
  refuse("Face 2 1 2 4", "Face 2 1 2 4 {", 7, "braces");
  refuse("Face 3", "Facet 3", 8, "expected Vertex");
  const std::string& rich = samples::RichGuMesh();
  ExpectRefused(replaced(rich, "sph=(1 0 0)", ""), ParseCode::Malformed, 10, "every vertex");
  ExpectRefused(replaced(rich, "sph=(1 0 0)", "sph=(1 0)"), ParseCode::Malformed, 2, "numbers");
  ExpectRefused(replaced(rich, "rgb=(1 0 0)", "rgb=(1 0 300)"), ParseCode::Malformed, 1, "300");
}

TEST(GuMeshParser, ReadsTheSameFromPiecesAsFromMemory)
{
  const int count = 60000;
  std::string bytes;
  for (int i = 0; i < count; ++i)
  {
    bytes += "Vertex " + std::to_string(3 * i) + " " + std::to_string(0.37 * i) + " 0 1 {uv=(0 " +
      std::to_string(i) + ")}\n";
  }
  for (int i = 2; i < count; ++i)
  {
    bytes += "Face 1 0 " + std::to_string(3 * i) + " " + std::to_string(3 * i - 3) + "\r\n";
  }
  conformal::ByteReader pieces = samples::InPieces(bytes);
  const SurfaceResult windowed = conformal::parseGuMesh(pieces);
  const SurfaceResult whole = parse(bytes);
  ASSERT_TRUE(windowed.Status.ok()) << windowed.Status.text();
  EXPECT_TRUE(samples::AreSame(windowed.Data.Points, whole.Data.Points));
  EXPECT_TRUE(samples::AreSame(windowed.Data.PointArrays[0], whole.Data.PointArrays[0]));
  EXPECT_TRUE(polygonIds(windowed.Data) == polygonIds(whole.Data));
}

TEST(GuMeshParser, IsKnownByItsFirstVertex)
{
  for (const std::string& file : samples::GuMeshFiles())
  {
    EXPECT_TRUE(conformal::looksLikeGuMesh(file)) << file;
  }
  for (const char* other : { "", "Vertex\n", "Vertex 1 0 0\n", "Vertex x 0 0 0\n", "v 0 0 0\n" })
  {
    EXPECT_FALSE(conformal::looksLikeGuMesh(other)) << other;
  }
}
