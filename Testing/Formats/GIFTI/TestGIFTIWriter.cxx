#include "GIFTI/GIFTIWriter.h"

#include "../Bytes/WrittenSurfaces.h"
#include "GIFTI/BinaryText.h"
#include "GIFTI/GIFTIParser.h"

#include <algorithm>
#include <string_view>
#include <vector>

using namespace written;

TEST(GIFTIWriter, IsReadBackTheSameWithAllArrays)
{
  const auto parse = [](conformal::ByteReader& input)
  { return conformal::parseGIFTISurface(input); };
  for (const bool isDouble : { false, true })
  {
    SurfaceData data = tetrahedron(isDouble);
    data.PointArrays.push_back(spherePositions());
    data.PointArrays.push_back(randomArray<float>("a < b & \"c\"", ScalarType::Float32, 1, 4, 1));
    data.PointArrays.push_back(randomArray<std::int8_t>("i8", ScalarType::Int8, 1, 4, 2));
    data.PointArrays.push_back(randomArray<std::uint8_t>("u8", ScalarType::UInt8, 3, 4, 3));
    data.PointArrays.push_back(randomArray<std::int16_t>("i16", ScalarType::Int16, 1, 4, 4));
    data.PointArrays.push_back(randomArray<std::uint16_t>("u16", ScalarType::UInt16, 1, 4, 5));
    data.PointArrays.push_back(randomArray<std::int32_t>("i32", ScalarType::Int32, 1, 4, 6));
    data.PointArrays.push_back(randomArray<std::uint32_t>("u32", ScalarType::UInt32, 1, 4, 7));
    data.PointArrays.push_back(randomArray<std::int64_t>("i64", ScalarType::Int64, 1, 4, 8));
    data.PointArrays.push_back(randomArray<std::uint64_t>("u64", ScalarType::UInt64, 1, 4, 9));
    ExpectSame(read(conformal::makeGIFTI(data), parse), data, true);
  }
}

TEST(GIFTIWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeGIFTI(data, stop); });
}

// Compressing takes seconds for millions of points: it is told to stop, and tells how far it is.
TEST(GIFTIWriter, ReportsWhileItCompresses)
{
  const NamedArray noise = randomArray<double>("noise", ScalarType::Float64, 1, 1 << 18, 1);
  const std::string_view bytes(
    reinterpret_cast<const char*>(noise.Values.data()), noise.Values.size());
  std::vector<double> reports;
  const auto listen = [&](double part)
  {
    reports.push_back(part);
    return true;
  };
  const std::string text = conformal::encodeBinaryText(bytes, true, listen);
  EXPECT_GE(reports.size(), 8U);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  conformal::BinaryTextDecoder decoder(bytes.size(), true);
  decoder.add(text);
  const auto decoded = decoder.take();
  ASSERT_EQ(decoded.size(), bytes.size());
  EXPECT_TRUE(std::equal(decoded.data(), decoded.data() + decoded.size(), noise.Values.data()));
  const auto stop = [](double part) { return part < 0.5; };
  EXPECT_THROW(conformal::encodeBinaryText(bytes, true, stop), conformal::ParseError);
}

TEST(GIFTIWriter, RefusesWhatCouldNotBeReadBack)
{
  EXPECT_THROW(conformal::makeGIFTI(surfaceWithAQuad()), std::invalid_argument);
  SurfaceData cloud = tetrahedron(false);
  cloud.PolygonIds = conformal::OwnedArray<std::int64_t>();
  cloud.PolygonOffsets = conformal::OwnedArray<std::int64_t>();
  EXPECT_THROW(conformal::makeGIFTI(cloud), std::invalid_argument);
}
