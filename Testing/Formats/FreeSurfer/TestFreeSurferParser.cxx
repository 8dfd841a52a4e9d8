#include "FreeSurfer/FreeSurferParser.h"

#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "FreeSurferSamples.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::Ids;
using samples::polygonIds;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseFreeSurferSurface(input);
}

SurfaceResult parseCurv(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseFreeSurferCurv(input);
}

void ExpectRefused(const SurfaceResult& result, ParseCode code, const std::string& part)
{
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_NE(result.Status.text().find("byte "), std::string::npos) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
}
}

TEST(FreeSurferParser, ReadsTriangles)
{
  const SurfaceResult result = parse(samples::FreeSurferTriangles());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<float>(result.Data.Points), samples::TetrahedronPoints());
  EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
  const std::string file = samples::FreeSurferTriangles();
  conformal::ByteReader pieces = samples::InPieces(file);
  EXPECT_TRUE(
    samples::AreSame(conformal::parseFreeSurferSurface(pieces).Data.Points, result.Data.Points));
}

TEST(FreeSurferParser, ReadsQuadsOfBothKinds)
{
  for (const bool isOld : { false, true })
  {
    const SurfaceResult result = parse(samples::FreeSurferQuads(isOld));
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(values<float>(result.Data.Points),
      (std::vector<float>{
        -3, -2.5F, -2, -1.5F, -1, -0.5F, 0, 0.5F, 1, 1.5F, 2, 2.5F, 3, 3.5F, 4 }));
    EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 1, 2, 3, 1, 2, 4, 3 }));
  }
}

TEST(FreeSurferParser, ReadsCurvOfBothKinds)
{
  for (const bool isOld : { false, true })
  {
    const std::string file = samples::FreeSurferCurv(isOld);
    const SurfaceResult result = parseCurv(file);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    samples::ExpectArray<float>(
      result.Data.PointArrays, "Curvature", ScalarType::Float32, 1, { -0.5F, -0.25F, 0, 0.25F });
    for (std::size_t size = 1; size < file.size(); ++size)
    {
      ExpectRefused(parseCurv(file.substr(0, size)), ParseCode::PrematureEnd, "");
    }
    ExpectRefused(parseCurv(file + "x"), ParseCode::Malformed, "bytes after the last value");
    ExpectRefused(parseCurv(""), ParseCode::PrematureEnd, "empty");
  }
  const std::string file = samples::FreeSurferCurv(false);
  ExpectRefused(parseCurv(samples::With32(file, 3, 0xFFFFFFFFU)), ParseCode::Malformed, "-1");
  ExpectRefused(parseCurv(samples::With32(file, 3, 0x7FFFFFFFU)), ParseCode::Malformed, "values");
  ExpectRefused(parseCurv(samples::With32(file, 11, 2)), ParseCode::Malformed, "2 values");
}

TEST(FreeSurferParser, RefusesBrokenFilesWithTheirByte)
{
  for (const std::string& file : samples::BadFreeSurferFiles())
  {
    const SurfaceResult result = parse(file);
    EXPECT_FALSE(result.Status.ok());
    EXPECT_FALSE(result.Status.Message.empty());
    EXPECT_EQ(result.Data.Points.Values.size(), 0u);
  }
  const std::string file = samples::FreeSurferTriangles();
  ExpectRefused(parse(""), ParseCode::PrematureEnd, "empty");
  ExpectRefused(parse("OFF"), ParseCode::UnrecognizedType, "OFF");
  ExpectRefused(parse(samples::With32(file, 27, 0x80000000U)), ParseCode::Malformed, "count");
  ExpectRefused(parse(samples::With32(file, 27, 0x7FFFFFFFU)), ParseCode::Malformed, "points");
  ExpectRefused(parse(samples::With32(file, 35, 0x7FC00000U)), ParseCode::Malformed, "point 0");
  ExpectRefused(parse(samples::With32(file, 83, 4)), ParseCode::Malformed, "found id 4");
  ExpectRefused(parse(file.substr(0, 100)), ParseCode::PrematureEnd, "bytes");
}

TEST(FreeSurferParser, IsKnownByItsFirstBytes)
{
  for (const std::string& file : samples::FreeSurferFiles())
  {
    EXPECT_TRUE(conformal::looksLikeFreeSurferSurface(file));
  }
  for (const std::string& other :
    { std::string(), std::string("\xFF\xFF"), std::string("\xFF\xFF\xFE\1\n"),
      samples::FreeSurferCurv(false), samples::FreeSurferCurv(true) })
  {
    EXPECT_FALSE(conformal::looksLikeFreeSurferSurface(other));
  }
}
