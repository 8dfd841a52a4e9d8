#include "TextCloud/TextCloudWriter.h"

#include "../../CommaLocale.h"
#include "../Bytes/WrittenSurfaces.h"
#include "TextCloud/TextCloudParser.h"

using namespace written;

TEST(TextCloudWriter, IsReadBackTheSame)
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

TEST(TextCloudWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeTextCloud(data, stop); });
}
