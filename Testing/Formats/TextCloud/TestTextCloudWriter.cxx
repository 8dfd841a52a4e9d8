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
  data.PointArrays[1] = randomArray<std::uint8_t>("RGBA", ScalarType::UInt8, 4, 4, 3);
  const SurfaceResult opaque = read(conformal::makeTextCloud(data), parse);
  ASSERT_EQ(opaque.Data.PointArrays.size(), 5u);
  EXPECT_EQ(opaque.Data.PointArrays[1].Name, "RGB");
  EXPECT_EQ(opaque.Data.PointArrays[1].Values[3], data.PointArrays[1].Values[4]);
  data.PointArrays.clear();
  data.PointArrays.push_back(randomArray<double>("two words", ScalarType::Float64, 2, 4, 1));
  const SurfaceResult columns = read(conformal::makeTextCloud(data), parse);
  ASSERT_EQ(columns.Data.PointArrays.size(), 2u);
  EXPECT_EQ(columns.Data.PointArrays[1].Name, "two_words_1");
}

// Whatever arrays are called, all of them come back, and none is taken for something else.
TEST(TextCloudWriter, GivesEveryColumnANameOfItsOwn)
{
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases = {
    { { "x", "b", "c" }, { "x_", "b", "c" } }, { { "X", "Y", "vx" }, { "X", "Y", "vx" } },
    { { "a,b", "a;b", "'a'" }, { "a_b", "a_b_", "_a_" } },
    { { "", "", "array" }, { "array", "array_", "array__" } },
    { { "#", "/",
        "gr\xC3\xB6\xC3\x9F"
        "e" },
      { "_", "__",
        "gr\xC3\xB6\xC3\x9F"
        "e" } },
    { { "a_0", "a:2", "a_1" }, { "a_0", "a_0_", "a_1", "a_1_" } }, // a:2 has two components
  };
  for (const auto& [given, expected] : cases)
  {
    SurfaceData data;
    data.Points = tetrahedron(true).Points;
    for (const std::string& name : given)
    {
      const bool isPair = name == "a:2";
      data.PointArrays.push_back(randomArray<double>(
        isPair ? "a" : name.c_str(), ScalarType::Float64, isPair ? 2 : 1, 4, 1));
    }
    const SurfaceResult result = read(conformal::makeTextCloud(data),
      [](conformal::ByteReader& input) { return conformal::parseTextCloud(input); });
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    std::vector<std::string> names;
    for (const conformal::NamedArray& array : result.Data.PointArrays)
    {
      EXPECT_EQ(array.Type, ScalarType::Float64) << array.Name;
      names.push_back(array.Name);
    }
    EXPECT_EQ(names, expected);
  }
}

TEST(TextCloudWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeTextCloud(data, stop); });
}
