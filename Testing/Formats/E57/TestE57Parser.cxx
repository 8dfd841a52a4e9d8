#include "E57/E57Parser.h"

#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "E57/E57Column.h"
#include "E57/E57Pages.h"
#include "E57Samples.h"

#include <random>
#include <stdexcept>

using conformal::E57Field;
using conformal::E57Kind;
using conformal::NamedArray;
using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes, int scan = -1, bool shift = true)
{
  conformal::ByteReader input(bytes);
  conformal::E57Options options;
  options.ScanId = scan;
  options.ShiftCoordinates = shift;
  return conformal::parseE57(input, options);
}

SurfaceResult parseGood(std::string_view bytes, int scan = -1, bool shift = true)
{
  SurfaceResult result = parse(bytes, scan, shift);
  EXPECT_TRUE(result.Status.ok()) << result.Status.text();
  return result;
}

void ExpectRefused(const std::string& bytes, ParseCode code, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}
}

TEST(E57Parser, ChecksumsAreThoseOfTheStandard)
{
  EXPECT_EQ(conformal::crc32C("123456789"), 0xE3069283U); // check value of CRC-32C
  std::mt19937 random(1);
  std::string bytes;
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(conformal::crc32C(bytes), samples::SlowCRC32C(bytes));
    bytes += static_cast<char>(random());
  }
}

TEST(E57Parser, ReadsAFileOfPye57)
{
  const SurfaceResult result = parseGood(samples::E57FromPye57());
  const auto& arrays = result.Data.PointArrays;
  // Points 0, 1 and 3: (x, y, z) becomes (z, x, y) + (10, 20, 30).
  EXPECT_EQ(values<float>(result.Data.Points),
    (std::vector<float>{ 10, 17.5F, 30, 9, 18.75F, 30.001F, 7, 21.25F, 30.003F }));
  ExpectArray<std::uint8_t>(
    arrays, "RGB", ScalarType::UInt8, 3, { 0, 255, 0, 60, 254, 1, 180, 252, 3 });
  ExpectArray<float>(arrays, "Normals", ScalarType::Float32, 3, { 0, 1, 0, 0, 1, 0, 0, 1, 0 });
  ExpectArray<float>(arrays, "Intensity", ScalarType::Float32, 1, { 0, 0.25F, 0.75F });
  ExpectArray<std::uint8_t>(arrays, "rowIndex", ScalarType::UInt8, 1, { 0, 1, 3 });
  ExpectArray<std::uint8_t>(arrays, "columnIndex", ScalarType::UInt8, 1, { 7, 7, 7 });
  ExpectArray<double>(arrays, "timeStamp", ScalarType::Float64, 1, { 0.0, 0.1, 3 * 0.1 });
  EXPECT_EQ(arrays.size(), 6u);
  EXPECT_EQ(result.Data.ScannerPosition, (std::vector<double>{ 10, 20, 30 }));
  EXPECT_TRUE(result.Data.CoordinateShift.empty());
  EXPECT_EQ(result.Data.DroppedPoints, 0u);
}

TEST(E57Parser, ReadsScansTogetherOrOne)
{
  const std::string file = samples::E57FileOf({ samples::E57FloatScan(2), samples::E57FloatScan(0),
    samples::E57FloatScan(1, samples::E57Pose({ "1", "0", "0", "0", "1", "2", "3" })) });
  const SurfaceResult all = parseGood(file);
  EXPECT_EQ(
    values<double>(all.Data.Points), (std::vector<double>{ 0, 0, 0.5, 1, 2, 0.5, 1, 2, 3.5 }));
  ExpectArray<std::int32_t>(all.Data.PointArrays, "ScanId", ScalarType::Int32, 1, { 0, 0, 2 });
  ExpectArray<std::int16_t>(
    all.Data.PointArrays, "Intensity", ScalarType::Int16, 1, { -5, -4, -5 });
  EXPECT_EQ(samples::find(all.Data.PointArrays, "ScannerPosition"), nullptr);
  const SurfaceResult last = parseGood(file, 2);
  EXPECT_EQ(values<double>(last.Data.Points), (std::vector<double>{ 1, 2, 3.5 }));
  EXPECT_EQ(samples::find(last.Data.PointArrays, "ScanId"), nullptr);
  EXPECT_EQ(parseGood(file, 1).Data.Points.numberOfTuples(), 0u);
  EXPECT_THROW(parse(file, 3), std::invalid_argument);
}

TEST(E57Parser, AFileMayHaveNoScans)
{
  EXPECT_EQ(parseGood(samples::E57FileOf({})).Data.Points.numberOfTuples(), 0u);
}

TEST(E57Parser, ConvertsSphericalCoordinates)
{
  const SurfaceResult result = parseGood(samples::E57FileOf({ samples::E57SphericalScan() }));
  const std::vector<double> points = values<double>(result.Data.Points);
  const std::vector<double> expected = { 2, 0, 0, 0, 3, 0, 0, 0, 5 };
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_NEAR(points[i], expected[i], 1e-15);
  }
  ExpectArray<std::int32_t>(
    result.Data.PointArrays, "columnIndex", ScalarType::Int32, 1, { -1, 0, 40000 });
  EXPECT_EQ(result.Data.PointArrays.size(), 2u); // no text
  EXPECT_EQ(result.Data.ScannerPosition, (std::vector<double>{ 0, 0, 0 }));
}

TEST(E57Parser, ScansWithPositionsHaveThemAsAnArray)
{
  samples::E57Sample moved = samples::E57SphericalScan();
  moved.More = samples::E57Pose({ "1", "0", "0", "0", "0", "0", "1.5" });
  const SurfaceResult result =
    parseGood(samples::E57FileOf({ samples::E57SphericalScan(), moved }));
  ExpectArray<float>(result.Data.PointArrays, "ScannerPosition", ScalarType::Float32, 3,
    { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.5F, 0, 0, 1.5F, 0, 0, 1.5F });
  EXPECT_TRUE(result.Data.ScannerPosition.empty());
}

TEST(E57Parser, ShiftsScansOfMaps)
{
  const std::string pose = samples::E57Pose({ "1", "0", "0", "0", "412000", "5318000", "500" });
  const std::string file = samples::E57FileOf({ samples::E57FloatScan(3, pose) });
  const SurfaceResult shifted = parseGood(file);
  EXPECT_EQ(shifted.Data.CoordinateShift, (std::vector<double>{ 412001, 5318002, 501 }));
  EXPECT_EQ(values<float>(shifted.Data.Points),
    (std::vector<float>{ -1, -2, -0.5F, 0, 0, -0.5F, 1, 2, -0.5F }));
  const SurfaceResult kept = parseGood(file, -1, false);
  EXPECT_TRUE(kept.Data.CoordinateShift.empty());
  EXPECT_EQ(values<double>(kept.Data.Points),
    (std::vector<double>{
      412000, 5318000, 500.5, 412001, 5318002, 500.5, 412002, 5318004, 500.5 }));
}

TEST(E57Parser, PacketsMayEndWithinNumbers)
{
  samples::E57Sample scan = samples::E57FloatScan(1000);
  const SurfaceResult whole = parseGood(samples::E57FileOf({ scan }));
  ASSERT_EQ(whole.Data.Points.numberOfTuples(), 1000u);
  ExpectArray<std::int16_t>(whole.Data.PointArrays, "Intensity", ScalarType::Int16, 1,
    []
    {
      std::vector<std::int16_t> expected(1000);
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        expected[i] = static_cast<std::int16_t>(i) - 5;
      }
      return expected;
    }());
  for (const std::size_t bytes : { 1u, 3u, 17u, 4000u })
  {
    scan.PacketBytes = bytes;
    const std::string file = samples::E57FileOf({ scan });
    conformal::ByteReader pieces = samples::InPieces(file);
    for (const SurfaceResult& result : { parseGood(file), conformal::parseE57(pieces) })
    {
      ASSERT_TRUE(result.Status.ok()) << result.Status.text();
      EXPECT_TRUE(samples::AreSame(result.Data.Points, whole.Data.Points));
      for (std::size_t i = 0; i < whole.Data.PointArrays.size(); ++i)
      {
        EXPECT_TRUE(samples::AreSame(result.Data.PointArrays[i], whole.Data.PointArrays[i]));
      }
    }
  }
}

TEST(E57Parser, UnpacksIntegersOfAnyNumberOfBits)
{
  std::mt19937_64 random(1);
  for (unsigned bits = 1; bits <= 64; ++bits)
  {
    E57Field field;
    field.Kind = E57Kind::Integer;
    field.Maximum = bits < 64
      ? static_cast<std::int64_t>(
          static_cast<std::uint64_t>(field.Minimum) + ((std::uint64_t(1) << bits) - 1))
      : std::numeric_limits<std::int64_t>::max();
    ASSERT_EQ(field.bits(), bits);
    std::vector<std::uint64_t> stored(40);
    std::vector<std::int64_t> expected;
    for (std::uint64_t& value : stored)
    {
      value = random() >> (64 - bits);
      expected.push_back(
        static_cast<std::int64_t>(static_cast<std::uint64_t>(field.Minimum) + value));
    }
    NamedArray array = conformal::makeArray("a", ScalarType::Int64, 1);
    array.Values.resize(stored.size() * sizeof(std::int64_t));
    conformal::E57Target target;
    target.Array = &array;
    conformal::E57Column column(field, target, stored.size());
    const std::string packed = samples::PackedBits(stored, bits);
    for (std::size_t at = 0, step = 1; at < packed.size(); at += step, step = step % 13 + 2)
    {
      column.add(std::string_view(packed).substr(at, step));
    }
    EXPECT_TRUE(column.isDone());
    EXPECT_EQ(values<std::int64_t>(array), expected) << bits;
  }
}

TEST(E57Parser, MapsColorsFromTheirLimits)
{
  samples::E57Sample scan = samples::E57FloatScan(3);
  const auto colorsOf =
    [&](const std::string& field, const std::string& stream, const std::string& more)
  {
    scan.More = more;
    scan.Prototype = samples::E57FloatField("cartesianX") + samples::E57FloatField("cartesianY") +
      samples::E57FloatField("cartesianZ") + samples::replaced(field, "color", "colorRed") +
      samples::replaced(field, "color", "colorGreen") +
      samples::replaced(field, "color", "colorBlue");
    scan.Streams.resize(3);
    scan.Streams.insert(scan.Streams.end(), 3, stream);
    const SurfaceResult result = parseGood(samples::E57FileOf({ scan }));
    const NamedArray* colors = samples::find(result.Data.PointArrays, "RGB");
    const std::vector<std::uint8_t> all =
      colors ? values<std::uint8_t>(*colors) : std::vector<std::uint8_t>(9);
    return std::vector<int>{ all[0], all[3], all[6] };
  };
  std::string limits;
  for (const std::string name : { "colorRed", "colorGreen", "colorBlue" })
  {
    limits += "<" + name + "Minimum type=\"Float\"/><" + name + "Maximum type=\"Float\">2</" +
      name + "Maximum>";
  }
  limits = "<colorLimits type=\"Structure\">" + limits + "</colorLimits>";
  const std::string words = samples::PackedBits({ 0, 32896, 65535 }, 16);
  EXPECT_EQ(colorsOf(samples::E57IntegerField("color", "0", "65535"), words, ""),
    (std::vector<int>{ 0, 128, 255 }));
  // Integers of 8 bits are kept, whatever the limits are. Programs write the largest color as
  // limit.
  EXPECT_EQ(
    colorsOf(samples::E57IntegerField("color", "0", "255"), std::string("\1\2\0", 3), limits),
    (std::vector<int>{ 1, 2, 0 }));
  const std::string floats = samples::Bytes(false).add(std::vector<float>{ -1, 1, 2 }).bytes();
  EXPECT_EQ(
    colorsOf(samples::E57FloatField("color"), floats, limits), (std::vector<int>{ 0, 128, 255 }));
  colorsOf(samples::E57FloatField("color"), floats, "");
  EXPECT_EQ(samples::find(parse(samples::E57FileOf({ scan })).Data.PointArrays, "RGB"), nullptr);
  EXPECT_NE(
    samples::find(parse(samples::E57FileOf({ scan })).Data.PointArrays, "colorRed"), nullptr);
}

TEST(E57Parser, DropsPointsThatAreNotFinite)
{
  samples::E57Sample scan = samples::E57FloatScan(3);
  scan.Streams[1] = samples::Bytes(false)
                      .add(std::vector<float>{ 0, std::numeric_limits<float>::quiet_NaN(), 4 })
                      .bytes();
  const SurfaceResult result = parseGood(samples::E57FileOf({ scan }));
  EXPECT_EQ(result.Data.DroppedPoints, 1u);
  EXPECT_EQ(values<float>(result.Data.Points), (std::vector<float>{ 0, 0, 0.5F, 2, 4, 0.5F }));
  ExpectArray<std::int16_t>(result.Data.PointArrays, "Intensity", ScalarType::Int16, 1, { -5, -3 });
}

TEST(E57Parser, KeepsOnlyFieldsOfAllScans)
{
  samples::E57Sample other = samples::E57FloatScan(1);
  other.Prototype = samples::replaced(other.Prototype, "\"995\"", "\"1000\"");
  other.Prototype = samples::replaced(other.Prototype, "colorRed", "dustiness");
  other.Streams[6] = samples::PackedBits({ 1005 }, 10);
  const SurfaceResult result = parseGood(samples::E57FileOf({ samples::E57FloatScan(1), other }));
  ExpectArray<std::int16_t>(
    result.Data.PointArrays, "Intensity", ScalarType::Int16, 1, { -5, 1000 });
  EXPECT_EQ(samples::find(result.Data.PointArrays, "RGB"), nullptr);
  EXPECT_EQ(samples::find(result.Data.PointArrays, "dustiness"), nullptr);
}

TEST(E57Parser, RefusesBrokenFiles)
{
  const std::vector<std::string> files = samples::BadE57Files();
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const SurfaceResult result = parse(files[i]);
    EXPECT_FALSE(result.Status.ok()) << i;
    EXPECT_EQ(result.Data.Points.Values.size(), 0u) << i;
    EXPECT_LE(result.Status.Offset, files[i].size()) << i;
  }
  const std::string good = samples::E57FileOf({ samples::E57FloatScan(3) });
  std::string damaged = good;
  damaged[1000] = static_cast<char>(damaged[1000] ^ 4);
  ExpectRefused(damaged, ParseCode::Malformed, "checksum");
  ExpectRefused("ASTM-X57" + good, ParseCode::UnrecognizedType, "ASTM-E57");
  ExpectRefused("", ParseCode::PrematureEnd, "empty");
  ExpectRefused(good.substr(0, 1000), ParseCode::PrematureEnd, "first page");
  ExpectRefused(samples::E57FromPye57().substr(0, 1500), ParseCode::PrematureEnd, "1500 bytes");
  ExpectRefused(samples::E57FileOf({ samples::E57FloatScan(3) }, "cartesianZ", "other"),
    ParseCode::Malformed, "cartesianX");
  ExpectRefused(
    samples::E57FileOf({ samples::E57FloatScan(3) }, "recordCount=\"3\"", "recordCount=\"9\""),
    ParseCode::PrematureEnd, "recordCount");
}

TEST(E57Parser, LimitsMemoryBeforeItIsAllocated)
{
  conformal::ParseLimits limits;
  limits.MaximumMemory = 100;
  const std::string file = samples::E57FileOf({ samples::E57FloatScan(50) });
  conformal::ByteReader input{ std::string_view(file) };
  EXPECT_EQ(conformal::parseE57(input, {}, limits).Status.Code, ParseCode::OutOfMemory);
}
