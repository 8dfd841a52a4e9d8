#include "LAS/LASParser.h"

#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "LASSamples.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes, bool shift = true)
{
  conformal::ByteReader input(bytes);
  conformal::LASOptions options;
  options.ShiftCoordinates = shift;
  return conformal::parseLAS(input, options);
}

void ExpectRefused(const std::string& bytes, ParseCode code, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}

void ExpectPoints(const SurfaceResult& result, unsigned format)
{
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  const bool isNew = format >= 6;
  const bool hasTime = isNew || format == 1 || format >= 3;
  const bool hasColor =
    format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10;
  const bool hasInfrared = format == 8 || format == 10;
  EXPECT_EQ(values<float>(result.Data.Points),
    (std::vector<float>{ 1, 2, 3, 1.001F, 1.998F, 4, 1.002F, 1.996F, 5 }));
  ExpectArray<std::uint16_t>(arrays, "Intensity", ScalarType::UInt16, 1, { 65533, 65534, 65535 });
  ExpectArray<std::uint8_t>(arrays, "ReturnNumber", ScalarType::UInt8, 1, { 1, 2, 3 });
  const std::uint8_t most = isNew ? 15 : 7;
  ExpectArray<std::uint8_t>(arrays, "NumberOfReturns", ScalarType::UInt8, 1, { most, most, most });
  ExpectArray<std::uint8_t>(arrays, "Classification", ScalarType::UInt8, 1,
    isNew ? std::vector<std::uint8_t>{ 200, 201, 202 } : std::vector<std::uint8_t>{ 29, 30, 31 });
  ExpectArray<std::uint16_t>(arrays, "PointSourceId", ScalarType::UInt16, 1, { 300, 301, 302 });
  EXPECT_EQ(arrays.size(), 5u + hasTime + hasColor + hasInfrared);
  if (hasTime)
  {
    ExpectArray<double>(arrays, "GPSTime", ScalarType::Float64, 1, { 0.5, 1.5, 2.5 });
  }
  if (hasColor)
  {
    ExpectArray<std::uint8_t>(
      arrays, "RGB", ScalarType::UInt8, 3, { 0, 255, 0, 1, 255, 0, 2, 255, 0 });
  }
  if (hasInfrared)
  {
    ExpectArray<std::uint16_t>(arrays, "NearInfrared", ScalarType::UInt16, 1, { 1000, 1001, 1002 });
  }
}
}

TEST(LASParser, ReadsEveryPointFormat)
{
  for (unsigned format = 0; format <= 10; ++format)
  {
    for (unsigned minor = format >= 6 ? 4 : format >= 4 ? 3 : 0; minor <= 4; ++minor)
    {
      SCOPED_TRACE(std::to_string(format) + ", version 1." + std::to_string(minor));
      const std::string file = samples::LASFileOf(format, minor, minor);
      ExpectPoints(parse(file), format);
      conformal::ByteReader pieces = samples::InPieces(file);
      ExpectPoints(conformal::parseLAS(pieces), format);
    }
  }
}

TEST(LASParser, ReadsAFileOfLaspy)
{
  const SurfaceResult result = parse(samples::LASFromLaspy());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  EXPECT_EQ(result.Data.CoordinateShift, (std::vector<double>{ 411999, 5318001, 501 }));
  EXPECT_EQ(values<float>(result.Data.Points),
    (std::vector<float>{ 2.25F, -1, -1, 3.5F, 0, 0.5F, -2.75F, 1, 1 }));
  ExpectArray<std::uint16_t>(arrays, "Intensity", ScalarType::UInt16, 1, { 1, 2, 65535 });
  ExpectArray<std::uint8_t>(arrays, "Classification", ScalarType::UInt8, 1, { 2, 31, 200 });
  ExpectArray<std::uint8_t>(arrays, "ReturnNumber", ScalarType::UInt8, 1, { 1, 2, 15 });
  ExpectArray<std::uint8_t>(arrays, "NumberOfReturns", ScalarType::UInt8, 1, { 2, 2, 15 });
  ExpectArray<std::uint8_t>(arrays, "RGB", ScalarType::UInt8, 3, { 1, 0, 0, 2, 1, 1, 255, 2, 1 });
  ExpectArray<double>(arrays, "GPSTime", ScalarType::Float64, 1, { 0.5, 1.5, 2.5 });
  ExpectArray<std::uint16_t>(arrays, "PointSourceId", ScalarType::UInt16, 1, { 7, 8, 9 });
  EXPECT_EQ(values<double>(parse(samples::LASFromLaspy(), false).Data.Points),
    (std::vector<double>{
      412001.25, 5318000, 500, 412002.5, 5318001, 501.5, 411996.25, 5318002, 502 }));
}

TEST(LASParser, KeepsColorsOfEightBits)
{
  std::string file = samples::LASFileOf(2, 2);
  for (std::size_t record = 0; record < 3; ++record)
  {
    file.replace(232 + 26 * record + 20, 6, std::string("\1\0\2\0\377\0", 6));
  }
  ExpectArray<std::uint8_t>(
    parse(file).Data.PointArrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 255, 1, 2, 255, 1, 2, 255 });
}

TEST(LASParser, CountsBytesAfterThePoints)
{
  EXPECT_EQ(parse(samples::LASFileOf(0, 2)).Data.UnreadBytes, 0u);
  EXPECT_EQ(parse(samples::LASFileOf(0, 2) + "more").Data.UnreadBytes, 4u);
  std::string file = samples::LASFileOf(6, 4) + "more";
  file[243] = 1; // the number of records after the points
  EXPECT_EQ(parse(file).Data.UnreadBytes, 0u);
}

TEST(LASParser, RefusesBrokenFiles)
{
  const std::vector<std::string> files = samples::BadLASFiles();
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const SurfaceResult result = parse(files[i]);
    EXPECT_FALSE(result.Status.ok()) << i;
    EXPECT_EQ(result.Data.Points.Values.size(), 0u) << i;
  }
  std::string compressed = samples::LASFileOf(3, 2);
  compressed[104] = static_cast<char>(0x83);
  ExpectRefused(compressed, ParseCode::Malformed, "convert the file to LAS");
  ExpectRefused("", ParseCode::PrematureEnd, "empty");
  ExpectRefused("LASF 1.4", ParseCode::PrematureEnd, "header");
  ExpectRefused("laser", ParseCode::UnrecognizedType, "LASF");
}
