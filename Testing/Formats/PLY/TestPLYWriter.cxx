#include "PLY/PLYWriter.h"

#include "../Bytes/WrittenSurfaces.h"
#include "PLY/PLYParser.h"

using namespace written;

TEST(PLYWriter, IsReadBackTheSameWithAllArrays)
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

TEST(PLYWriter, GivesEveryPropertyANameOfItsOwn)
{
  SurfaceData data = tetrahedron(true);
  data.PointArrays.push_back(randomArray<double>("x", ScalarType::Float64, 1, 4, 1));
  data.PointArrays.push_back(randomArray<double>("gr\xC3\xB6\xC3\x9F"
                                                 "e",
    ScalarType::Float64, 1, 4, 2));
  data.PolygonArrays.push_back(randomArray<double>("vertex_indices", ScalarType::Float64, 1, 4, 3));
  const SurfaceResult result = read(conformal::makePLY(data),
    [](conformal::ByteReader& input) { return conformal::parsePLY(input); });
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  ASSERT_EQ(result.Data.PointArrays.size(), 2u);
  EXPECT_EQ(result.Data.PointArrays[0].Name, "x_");
  EXPECT_EQ(result.Data.PointArrays[1].Name, data.PointArrays[1].Name);
  ASSERT_EQ(result.Data.PolygonArrays.size(), 1u);
  EXPECT_EQ(result.Data.PolygonArrays[0].Name, "vertex_indices_");
  EXPECT_EQ(result.Data.PolygonIds.size(), data.PolygonIds.size());
}

TEST(PLYWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makePLY(data, stop); });
}
