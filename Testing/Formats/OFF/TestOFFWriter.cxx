#include "OFF/OFFWriter.h"

#include "../../CommaLocale.h"
#include "../Bytes/WrittenSurfaces.h"
#include "OFF/OFFParser.h"

using namespace written;

TEST(OFFWriter, IsReadBackTheSame)
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

// MeshLab takes a color for bytes if its first number has no point.
TEST(OFFWriter, NumbersOfColorsHaveAPoint)
{
  SurfaceData data = tetrahedron(false);
  data.PointArrays.push_back(arrayOf<std::uint8_t>(
    "RGB", ScalarType::UInt8, 3, { 255, 51, 0, 0, 0, 0, 255, 255, 255, 51, 0, 255 }));
  const std::string text = conformal::makeOFF(data);
  for (const char* color :
    { " 1.0 0.2 0.0\n", " 0.0 0.0 0.0\n", " 1.0 1.0 1.0\n", " 0.2 0.0 1.0\n" })
  {
    EXPECT_NE(text.find(color), std::string::npos) << color << text;
  }
}

TEST(OFFWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeOFF(data, stop); });
}
