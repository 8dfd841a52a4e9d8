#include "GuMesh/GuMeshWriter.h"

#include "../../CommaLocale.h"
#include "../Bytes/WrittenSurfaces.h"
#include "GuMesh/GuMeshParser.h"

using namespace written;

TEST(GuMeshWriter, IsReadBackTheSame)
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

TEST(GuMeshWriter, LeavesOutOpacity)
{
  const auto parse = [](conformal::ByteReader& input) { return conformal::parseGuMesh(input); };
  SurfaceData data = tetrahedron(true);
  data.PointArrays.push_back(randomArray<std::uint8_t>("RGBA", ScalarType::UInt8, 4, 4, 3));
  const SurfaceResult result = read(conformal::makeGuMesh(data), parse);
  ASSERT_EQ(result.Data.PointArrays.size(), 1u);
  EXPECT_EQ(result.Data.PointArrays[0].Name, "RGB");
  EXPECT_EQ(result.Data.PointArrays[0].Values[3], data.PointArrays[0].Values[4]);
}

TEST(GuMeshWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeGuMesh(data, stop); });
}

TEST(GuMeshWriter, RefusesMapsWithoutADirection)
{
  for (const SurfaceData& surface : surfacesWithABrokenMap())
  {
    EXPECT_THROW(conformal::makeGuMesh(surface), std::invalid_argument);
  }
}
