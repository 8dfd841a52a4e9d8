// What is written is read back the same, to the last bit.
#include "Bytes/SurfaceBytes.h"

#include "../../CommaLocale.h"
#include "FreeSurfer/FreeSurferParser.h"
#include "GIFTI/GIFTIParser.h"
#include "GuMesh/GuMeshParser.h"
#include "OFF/OFFParser.h"
#include "PLY/PLYParser.h"
#include "ParsedArrays.h"
#include "StanfordScans/AlignedScans.h"
#include "TextCloud/TextCloudParser.h"

#include <array>
#include <limits>
#include <random>
#include <stdexcept>

using conformal::makeArray;
using conformal::NamedArray;
using conformal::ScalarType;
using conformal::SurfaceData;
using conformal::SurfaceResult;

namespace
{
template <typename T>
NamedArray arrayOf(
  const char* name, ScalarType type, std::size_t components, const std::vector<T>& values)
{
  NamedArray array = makeArray(name, type, components);
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    conformal::append(array, &values[i]);
  }
  return array;
}

template <typename T>
NamedArray randomArray(
  const char* name, ScalarType type, std::size_t components, std::size_t tuples, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<T> values;
  for (std::size_t i = 0; i < tuples * components; ++i)
  {
    values.push_back(
      static_cast<T>(std::is_floating_point<T>::value ? static_cast<double>(random()) / 1e7 - 100.0
                                                      : static_cast<double>(random() % 100)));
  }
  return arrayOf(name, type, components, values);
}

// A tetrahedron of hard numbers, in floats or doubles.
SurfaceData tetrahedron(bool isDouble)
{
  SurfaceData data;
  if (isDouble)
  {
    data.Points = arrayOf<double>("Points", ScalarType::Float64, 3,
      { 0.1, 1.0 / 3, 5e-324, 1234567.123456789, -1e300, 0, 0, 1, 0.7, -0.0, 0, 1e-3 });
  }
  else
  {
    data.Points = arrayOf<float>("Points", ScalarType::Float32, 3,
      { 0.1F, 1.0F / 3, 1e-45F, 1234567.1F, -1e38F, 0, 0, 1, 0.7F, -0.0F, 0, 1e-3F });
  }
  for (const std::int64_t id : { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 })
  {
    data.PolygonIds.push(id);
  }
  for (const std::int64_t offset : { 0, 3, 6, 9, 12 })
  {
    data.PolygonOffsets.push(offset);
  }
  return data;
}

std::vector<double> asDoubles(const NamedArray& array)
{
  std::vector<double> result;
  conformal::withType(array.Type,
    [&](auto zero)
    {
      for (const auto value : samples::values<decltype(zero)>(array))
      {
        result.push_back(static_cast<double>(value));
      }
    });
  return result;
}

// Arrays of the same names and values; also of the same types if asked.
void ExpectSame(
  const std::vector<NamedArray>& read, const std::vector<NamedArray>& written, bool areTypesKept)
{
  ASSERT_EQ(read.size(), written.size());
  for (const NamedArray& array : written)
  {
    const NamedArray* other = samples::find(read, array.Name.c_str());
    ASSERT_NE(other, nullptr) << array.Name;
    EXPECT_EQ(other->Components, array.Components) << array.Name;
    EXPECT_EQ(asDoubles(*other), asDoubles(array)) << array.Name;
    if (areTypesKept)
    {
      EXPECT_EQ(other->Type, array.Type) << array.Name;
    }
  }
}

void ExpectSame(const SurfaceResult& read, const SurfaceData& written, bool areTypesKept)
{
  ASSERT_TRUE(read.Status.ok()) << read.Status.text();
  EXPECT_EQ(asDoubles(read.Data.Points), asDoubles(written.Points));
  EXPECT_EQ(samples::polygonIds(read.Data), samples::polygonIds(written));
  EXPECT_EQ(samples::polygonOffsets(read.Data), samples::polygonOffsets(written));
  if (areTypesKept)
  {
    EXPECT_EQ(read.Data.Points.Type, written.Points.Type);
  }
  ExpectSame(read.Data.PointArrays, written.PointArrays, areTypesKept);
  ExpectSame(read.Data.PolygonArrays, written.PolygonArrays, areTypesKept);
}

template <typename Parse>
SurfaceResult read(const std::string& bytes, Parse parse)
{
  conformal::ByteReader input{ std::string_view(bytes) };
  return parse(input);
}

NamedArray spherePositions()
{
  return arrayOf<double>(
    "SpherePosition", ScalarType::Float64, 3, { 0, 0, 1, 1, 0, 0, 0, -1, 0, 0.6, 0, 0.8 });
}
}

TEST(SurfaceBytes, OFFIsReadBackTheSame)
{
  const CommaLocale locale;
  const auto parse = [](conformal::ByteReader& input) { return conformal::parseOFF(input); };
  for (const bool isDouble : { false, true })
  {
    SurfaceData data = tetrahedron(isDouble);
    ExpectSame(read(conformal::makeOFF(data), parse), data, isDouble);
    data.PolygonArrays.push_back(
      arrayOf<std::int32_t>("ColorIndex", ScalarType::Int32, 1, { 1, -1, 3, 2 }));
    ExpectSame(read(conformal::makeOFF(data), parse), data, isDouble);
    data.PointArrays.push_back(randomArray<double>("Normals", ScalarType::Float64, 3, 4, 1));
    data.PointArrays.push_back(randomArray<double>("TCoords", ScalarType::Float64, 2, 4, 2));
    data.PointArrays.push_back(
      arrayOf<std::uint8_t>("RGB", ScalarType::UInt8, 3, { 0, 0, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1 }));
    data.PolygonArrays.clear();
    data.PolygonArrays.push_back(randomArray<std::uint8_t>("RGBA", ScalarType::UInt8, 4, 4, 3));
    ExpectSame(read(conformal::makeOFF(data), parse), data, isDouble);
  }
}

TEST(SurfaceBytes, GuMeshIsReadBackTheSame)
{
  const CommaLocale locale;
  const auto parse = [](conformal::ByteReader& input) { return conformal::parseGuMesh(input); };
  SurfaceData data = tetrahedron(true);
  ExpectSame(read(conformal::makeGuMesh(data), parse), data, true);
  data.PointArrays.push_back(spherePositions());
  data.PointArrays.push_back(randomArray<double>("Normals", ScalarType::Float64, 3, 4, 1));
  data.PointArrays.push_back(randomArray<double>("TCoords", ScalarType::Float64, 2, 4, 2));
  data.PointArrays.push_back(randomArray<std::uint8_t>("RGB", ScalarType::UInt8, 3, 4, 3));
  data.PolygonArrays.push_back(randomArray<std::uint8_t>("RGB", ScalarType::UInt8, 3, 4, 4));
  ExpectSame(read(conformal::makeGuMesh(data), parse), data, true);
}

TEST(SurfaceBytes, TextCloudIsReadBackTheSame)
{
  const CommaLocale locale;
  const auto parse = [](conformal::ByteReader& input) { return conformal::parseTextCloud(input); };
  SurfaceData data;
  data.Points = tetrahedron(true).Points;
  ExpectSame(read(conformal::makeTextCloud(data), parse), data, true);
  data.PointArrays.push_back(randomArray<double>("Intensity", ScalarType::Float64, 1, 4, 1));
  data.PointArrays.push_back(randomArray<std::uint8_t>("RGB", ScalarType::UInt8, 3, 4, 3));
  data.PointArrays.push_back(randomArray<double>("Normals", ScalarType::Float64, 3, 4, 1));
  data.PointArrays.push_back(randomArray<double>("Deviation", ScalarType::Float64, 1, 4, 2));
  ExpectSame(read(conformal::makeTextCloud(data), parse), data, true);
  data.PointArrays.clear();
  data.PointArrays.push_back(randomArray<double>("two words", ScalarType::Float64, 2, 4, 1));
  const SurfaceResult columns = read(conformal::makeTextCloud(data), parse);
  ASSERT_EQ(columns.Data.PointArrays.size(), 2u);
  EXPECT_EQ(columns.Data.PointArrays[1].Name, "two_words_1");
}

TEST(SurfaceBytes, PLYIsReadBackTheSameWithAllArrays)
{
  const auto parse = [](conformal::ByteReader& input) { return conformal::parsePLY(input); };
  for (const bool isDouble : { false, true })
  {
    SurfaceData data = tetrahedron(isDouble);
    ExpectSame(read(conformal::makePLY(data), parse), data, true);
    data.PointArrays.push_back(spherePositions());
    data.PointArrays.push_back(randomArray<float>("Normals", ScalarType::Float32, 3, 4, 1));
    data.PointArrays.push_back(randomArray<double>("TCoords", ScalarType::Float64, 2, 4, 2));
    data.PointArrays.push_back(randomArray<std::uint8_t>("RGBA", ScalarType::UInt8, 4, 4, 3));
    data.PointArrays.push_back(randomArray<std::int8_t>("a", ScalarType::Int8, 1, 4, 4));
    data.PointArrays.push_back(randomArray<std::uint16_t>("b", ScalarType::UInt16, 2, 4, 5));
    data.PointArrays.push_back(randomArray<std::int16_t>("c", ScalarType::Int16, 1, 4, 6));
    data.PointArrays.push_back(randomArray<std::uint32_t>("d", ScalarType::UInt32, 1, 4, 7));
    data.PolygonArrays.push_back(randomArray<std::int32_t>("group", ScalarType::Int32, 1, 4, 8));
    data.PolygonArrays.push_back(randomArray<std::uint8_t>("RGB", ScalarType::UInt8, 3, 4, 9));
    ExpectSame(read(conformal::makePLY(data), parse), data, true);
    data.PointArrays.push_back(randomArray<std::int64_t>("e", ScalarType::Int64, 1, 4, 7));
    ExpectSame(read(conformal::makePLY(data), parse), data, false);
  }
  SurfaceData wide; // a polygon of more than 255 corners
  wide.Points = randomArray<float>("Points", ScalarType::Float32, 3, 300, 1);
  wide.PolygonOffsets.push(0);
  for (std::int64_t i = 0; i < 300; ++i)
  {
    wide.PolygonIds.push(i);
  }
  wide.PolygonOffsets.push(300);
  ExpectSame(read(conformal::makePLY(wide), parse), wide, true);
}

TEST(SurfaceBytes, FreeSurferIsReadBackTheSame)
{
  const auto parse = [](conformal::ByteReader& input)
  { return conformal::parseFreeSurferSurface(input); };
  const auto parseCurv = [](conformal::ByteReader& input)
  { return conformal::parseFreeSurferCurv(input); };
  const SurfaceData data = tetrahedron(false);
  ExpectSame(read(conformal::makeFreeSurferSurface(data), parse), data, true);
  const NamedArray curvature = randomArray<float>("Curvature", ScalarType::Float32, 1, 4, 1);
  const SurfaceResult curv = read(conformal::makeFreeSurferCurv(curvature, 4), parseCurv);
  ASSERT_TRUE(curv.Status.ok()) << curv.Status.text();
  EXPECT_TRUE(samples::AreSame(curv.Data.PointArrays.at(0), curvature));
  SurfaceData quads = tetrahedron(false);
  quads.PolygonIds.push(1);
  EXPECT_THROW(conformal::makeFreeSurferSurface(quads), std::invalid_argument);
  EXPECT_THROW(conformal::makeGIFTI(quads), std::invalid_argument);
}

TEST(SurfaceBytes, GIFTIIsReadBackTheSameWithAllArrays)
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

TEST(SurfaceBytes, StopWhenAsked)
{
  const SurfaceData data = tetrahedron(false);
  const auto stop = [](double) { return false; };
  for (const auto make : { conformal::makeOFF, conformal::makeGuMesh, conformal::makeTextCloud,
         conformal::makePLY, conformal::makeFreeSurferSurface, conformal::makeGIFTI })
  {
    EXPECT_THROW(make(data, stop), conformal::ParseError);
  }
  EXPECT_THROW(conformal::makeFreeSurferCurv(data.Points, 4, stop), conformal::ParseError);
}

TEST(SurfaceBytes, RefuseWhatCouldNotBeReadBack)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::array<double, 3>& direction : { std::array<double, 3>{ 0, 0, 0 }, { 1, nan, 0 },
         { 0, 0, std::numeric_limits<double>::infinity() } })
  {
    SurfaceData data = tetrahedron(false);
    NamedArray map = conformal::makeArray("SpherePosition", ScalarType::Float64, 3);
    for (std::size_t i = 0; i < data.Points.numberOfTuples(); ++i)
    {
      const std::array<double, 3> north = { 0, 0, 1 };
      append(map, (i == 2 ? direction : north).data());
    }
    data.PointArrays.clear();
    data.PointArrays.push_back(std::move(map));
    EXPECT_THROW(conformal::makeGuMesh(data), std::invalid_argument);
    EXPECT_THROW(conformal::makeFreeSurferSphere(data), std::invalid_argument);
  }
  SurfaceData far = tetrahedron(false);
  far.Points = conformal::makeArray("Points", ScalarType::Float64, 3);
  for (int i = 0; i < 4; ++i)
  {
    const std::array<double, 3> point = { 1, 2, i == 2 ? 1e39 : 3 };
    append(far.Points, point.data());
  }
  EXPECT_THROW(conformal::makeFreeSurferSurface(far), std::invalid_argument);
  SurfaceData cloud = tetrahedron(false);
  cloud.PolygonIds = conformal::OwnedArray<std::int64_t>();
  cloud.PolygonOffsets = conformal::OwnedArray<std::int64_t>();
  EXPECT_THROW(conformal::makeGIFTI(cloud), std::invalid_argument);
}
