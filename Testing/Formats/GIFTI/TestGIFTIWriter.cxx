#include "GIFTI/GIFTIWriter.h"

#include "../Bytes/WrittenSurfaces.h"
#include "Bytes/SurfaceWalk.h"
#include "GIFTI/BinaryText.h"
#include "GIFTI/GIFTIParser.h"
#include "Text/BinaryTextEncoder.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>
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
    ExpectSame(read(conformal::makeGIFTISurface(data), parse), data, true);
  }
}

TEST(GIFTIWriter, SphereHasARadiusOf100AndNoArrays)
{
  SurfaceData data = tetrahedron(true);
  EXPECT_THROW(conformal::makeGIFTISphere(data), std::invalid_argument);
  data.PointArrays.push_back(spherePositions());
  const SurfaceResult sphere = read(conformal::makeGIFTISphere(data),
    [](conformal::ByteReader& input) { return conformal::parseGIFTISurface(input); });
  ASSERT_TRUE(sphere.Status.ok()) << sphere.Status.text();
  const NamedArray& points = sphere.Data.Points;
  EXPECT_EQ(points.Type, ScalarType::Float32);
  EXPECT_TRUE(sphere.Data.PointArrays.empty());
  EXPECT_EQ(conformal::numberOfPolygons(sphere.Data), conformal::numberOfPolygons(data));
  ASSERT_EQ(points.numberOfTuples(), data.Points.numberOfTuples());
  for (std::size_t i = 0; i < 3 * points.numberOfTuples(); ++i)
  {
    EXPECT_EQ(conformal::valueOf(points, i),
      static_cast<float>(100.0 * conformal::valueOf(data.PointArrays.front(), i)));
  }
}

TEST(GIFTIWriter, GeometryIsTheSurfaceAloneInFloats)
{
  SurfaceData data = tetrahedron(false);
  data.PointArrays.push_back(spherePositions());
  const auto parse = [](conformal::ByteReader& input)
  { return conformal::parseGIFTISurface(input); };
  ExpectSame(read(conformal::makeGIFTIGeometry(data), parse), tetrahedron(false), true);
  EXPECT_THROW(conformal::makeGIFTIGeometry(tetrahedron(true)), std::invalid_argument); // 1e300
}

TEST(GIFTIWriter, RefusesSpheresThatCouldNotBeReadBack)
{
  for (const SurfaceData& surface : surfacesWithABrokenMap())
  {
    EXPECT_THROW(conformal::makeGIFTISphere(surface), std::invalid_argument);
  }
  for (const double size : { 1e38, 1e-42 }) // 100 times that
  {
    SurfaceData surface = tetrahedron(false);
    surface.PointArrays.push_back(arrayOf<double>("SpherePosition", ScalarType::Float64, 3,
      { size, 0, 0, size, 0, 0, size, 0, 0, size, 0, 0 }));
    EXPECT_THROW(conformal::makeGIFTISphere(surface), std::invalid_argument);
  }
}

TEST(GIFTIWriter, ShapesAreTheArraysOfOneComponentAsFloats)
{
  SurfaceData data = tetrahedron(true);
  data.PointArrays.push_back(spherePositions());
  EXPECT_THROW(conformal::makeGIFTIShape(data), std::invalid_argument);
  data.PointArrays.push_back(randomArray<float>("Curvature", ScalarType::Float32, 1, 4, 1));
  data.PointArrays.push_back(randomArray<double>("Depth", ScalarType::Float64, 1, 4, 2));
  data.PointArrays.push_back(randomArray<std::int16_t>("Parcel", ScalarType::Int16, 1, 4, 3));
  const SurfaceResult shape = read(conformal::makeGIFTIShape(data),
    [](conformal::ByteReader& input) { return conformal::parseGIFTIArrays(input); });
  ASSERT_TRUE(shape.Status.ok()) << shape.Status.text();
  ASSERT_EQ(shape.Data.PointArrays.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const NamedArray& array = shape.Data.PointArrays[k];
    EXPECT_EQ(array.Name, data.PointArrays[k + 1].Name);
    EXPECT_EQ(array.Type, ScalarType::Float32);
    for (std::size_t i = 0; i < 4; ++i)
    {
      EXPECT_EQ(conformal::valueOf(array, i),
        static_cast<float>(conformal::valueOf(data.PointArrays[k + 1], i)));
    }
  }
}

TEST(GIFTIWriter, RefusesShapesThatFloatsCannotHold)
{
  SurfaceData data = tetrahedron(true);
  data.PointArrays.push_back(arrayOf<double>("Depth", ScalarType::Float64, 1,
    { 1.0, std::numeric_limits<double>::quiet_NaN(), -2.0, 1e39 }));
  EXPECT_THROW(conformal::makeGIFTIShape(data), std::invalid_argument);
}

// A name in any encoding makes a file that can be read; those in UTF-8 come back.
TEST(GIFTIWriter, NamesThatAreNotXMLAreReplaced)
{
  for (const auto& [written, known] : std::vector<std::pair<std::string, std::string>>{
         { "d\xC3\xA9pth \xE2\x82\xAC \xF0\x9F\xA7\xA0",
           "d\xC3\xA9pth \xE2\x82\xAC \xF0\x9F\xA7\xA0" },
         { "d\xE9pth", "d_pth" }, { "\x01\xFF\xC3", "___" }, { "\xC0\x80!", "__!" },
         { "\xED\xA0\x80", "___" }, { "\xEF\xBF\xBF", "___" }, { "\xF4\x90\x80\x80", "____" } })
  {
    SurfaceData data = tetrahedron(false);
    data.PointArrays.push_back(randomArray<float>(written.c_str(), ScalarType::Float32, 1, 4, 1));
    const SurfaceResult result = read(conformal::makeGIFTISurface(data),
      [](conformal::ByteReader& input) { return conformal::parseGIFTISurface(input); });
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(result.Data.PointArrays.at(0).Name, known);
  }
}

TEST(GIFTIWriter, SaysWhatTheSurfaceIsOf)
{
  SurfaceData data = tetrahedron(false);
  data.PointArrays.push_back(spherePositions());
  data.PointArrays.push_back(randomArray<float>("Curvature", ScalarType::Float32, 1, 4, 1));
  const std::string entry =
    "<MD><Name>AnatomicalStructurePrimary</Name><Value>Cortex&lt;Left</Value></MD>";
  for (const auto& make : { conformal::makeGIFTISurface, conformal::makeGIFTIGeometry,
         conformal::makeGIFTISphere, conformal::makeGIFTIShape })
  {
    EXPECT_NE(make(data, "Cortex<Left", {}).find(entry), std::string::npos);
    EXPECT_EQ(make(data, "", {}).find("AnatomicalStructurePrimary"), std::string::npos);
  }
}

TEST(GIFTIWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeGIFTISurface(data, {}, stop); });
  SurfaceData data = tetrahedron(false);
  data.PointArrays.push_back(spherePositions());
  data.PointArrays.push_back(randomArray<float>("Curvature", ScalarType::Float32, 1, 4, 1));
  const conformal::Run stop({}, [](double) { return false; });
  EXPECT_THROW(conformal::makeGIFTISphere(data, {}, stop), conformal::Aborted);
  EXPECT_THROW(conformal::makeGIFTIShape(data, {}, stop), conformal::Aborted);
}

// Compressing takes seconds for millions of points: it is told to stop, and tells how far it is.
TEST(GIFTIWriter, ReportsWhileItCompresses)
{
  const NamedArray noise = randomArray<double>("noise", ScalarType::Float64, 1, 1 << 18, 1);
  const std::string_view bytes(
    reinterpret_cast<const char*>(noise.Values.data()), noise.Values.size());
  std::vector<double> reports;
  const conformal::Run watched({},
    [&](double part)
    {
      reports.push_back(part);
      return true;
    });
  const std::string text = conformal::encodeBinaryText(bytes, true, watched);
  EXPECT_GE(reports.size(), 8U);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  conformal::BinaryTextDecoder decoder(bytes.size(), true);
  decoder.add(text);
  const auto decoded = decoder.take();
  ASSERT_EQ(decoded.size(), bytes.size());
  EXPECT_TRUE(std::equal(decoded.data(), decoded.data() + decoded.size(), noise.Values.data()));
  const conformal::Run stop({}, [](double part) { return part < 0.5; });
  EXPECT_THROW(conformal::encodeBinaryText(bytes, true, stop), conformal::Aborted);
}

TEST(GIFTIWriter, RefusesWhatCouldNotBeReadBack)
{
  EXPECT_THROW(conformal::makeGIFTISurface(surfaceWithAQuad()), std::invalid_argument);
  SurfaceData cloud = tetrahedron(false);
  cloud.PolygonIds = conformal::OwnedArray<std::int64_t>();
  cloud.PolygonOffsets = conformal::OwnedArray<std::int64_t>();
  EXPECT_THROW(conformal::makeGIFTISurface(cloud), std::invalid_argument);
}

TEST(GIFTIWriter, GeometryTooFarForFloatsIsRefusedAndTheSurfaceKept)
{
  ExpectRefusesDistantSurfaces(
    [](const SurfaceData& data) { return conformal::makeGIFTIGeometry(data); });
  const SurfaceData distant = distantTetrahedron(1e-3, 1e8);
  ExpectSame(read(conformal::makeGIFTISurface(distant),
               [](conformal::ByteReader& input) { return conformal::parseGIFTISurface(input); }),
    distant, true);
}
