#include "PlateModel/PlateModelParser.h"

#include "PlateModelSamples.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

using conformal::ByteReader;
using conformal::looksLikePlateModel;
using conformal::ParseCode;
using conformal::parsePlateModel;
using conformal::SurfaceResult;

namespace
{
SurfaceResult parse(const std::string& text)
{
  ByteReader input(text);
  return parsePlateModel(input);
}

double coordinate(const SurfaceResult& result, std::size_t index)
{
  double value = 0.0;
  std::memcpy(&value, result.Data.Points.Values.data() + index * sizeof(double), sizeof(double));
  return value;
}

std::vector<std::int64_t> idsOf(const SurfaceResult& result)
{
  const auto& ids = result.Data.PolygonIds;
  return { ids.data(), ids.data() + ids.size() };
}
}

// However rows are numbered, it is the same tetrahedron.
TEST(PlateModelParser, ReadsTablesAndVerAlike)
{
  const std::vector<std::int64_t> tetrahedron = { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 };
  for (const std::string& text :
    { samples::NumberedPlates(), samples::VerPlates(), samples::TaggedPlates() })
  {
    const SurfaceResult result = parse(text);
    ASSERT_EQ(result.Status.Code, ParseCode::Ok) << result.Status.Message;
    ASSERT_EQ(result.Data.Points.numberOfTuples(), 4u);
    EXPECT_EQ(coordinate(result, 3), 1.5);
    EXPECT_EQ(coordinate(result, 11), 1e-3);
    EXPECT_EQ(idsOf(result), tetrahedron);
  }
}

TEST(PlateModelParser, CountsFromZeroWhereAPlateDoes)
{
  const SurfaceResult result = parse("3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n1\n0 0 1 2\n");
  ASSERT_EQ(result.Status.Code, ParseCode::Ok);
  EXPECT_EQ(idsOf(result), (std::vector<std::int64_t>{ 0, 1, 2 }));
  EXPECT_EQ(
    idsOf(parse("3 1\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n")), (std::vector<std::int64_t>{ 0, 1, 2 }));
  EXPECT_EQ(idsOf(parse("4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n")),
    (std::vector<std::int64_t>{ 0, 1, 2 }));
}

// A cube, whose volume is 8: closed, without repeated vertices, oriented outward.
TEST(PlateModelParser, ConnectsGridsOnTheSidesOfACube)
{
  for (const int q : { 1, 2, 5 })
  {
    for (const bool isReversed : { false, true })
    {
      const SurfaceResult result = parse(samples::CubeModel(q, isReversed));
      ASSERT_EQ(result.Status.Code, ParseCode::Ok) << result.Status.Message;
      EXPECT_EQ(result.Data.Points.numberOfTuples(), 6u * q * q + 2);
      EXPECT_EQ(result.Data.DroppedPolygons, 0u);
      const std::vector<std::int64_t> ids = idsOf(result);
      ASSERT_EQ(ids.size(), 3u * 12 * q * q);
      std::set<std::pair<std::int64_t, std::int64_t>> edges;
      double volume = 0.0;
      for (std::size_t t = 0; t < ids.size(); t += 3)
      {
        double x[3][3];
        for (std::size_t k = 0; k < 3; ++k)
        {
          edges.emplace(ids[t + k], ids[t + (k + 1) % 3]);
          for (std::size_t c = 0; c < 3; ++c)
          {
            x[k][c] = coordinate(result, 3 * ids[t + k] + c);
          }
        }
        volume += (x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) +
                    x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
                    x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0])) /
          6.0;
      }
      EXPECT_EQ(edges.size(), ids.size()); // no half-edge twice
      for (const auto& [begin, end] : edges)
      {
        EXPECT_EQ(edges.count({ end, begin }), 1u);
      }
      EXPECT_NEAR(volume, 8.0, 1e-5);
    }
  }
}

TEST(PlateModelParser, TellsGridsFromACloudWithACount)
{
  std::string cloud = "96\n";
  for (int i = 0; i < 96; ++i)
  {
    cloud += std::to_string(i) + " 1.5 2.5\n";
  }
  EXPECT_FALSE(looksLikePlateModel(cloud));
  const std::string cube = samples::CubeModel(30);
  EXPECT_TRUE(looksLikePlateModel(cube));
  EXPECT_TRUE(looksLikePlateModel(cube.substr(0, 200), cube.size()));
  EXPECT_FALSE(looksLikePlateModel(cube.substr(0, 200)));
  EXPECT_FALSE(looksLikePlateModel("v 0 0 0\nvn 0 0 1\nv 1 0 0\nv 0 1 0\n"));
}

TEST(PlateModelParser, ACountAlsoPrecedesVerticesInFilesOfPlateModels)
{
  std::string rows = "8\n";
  for (int i = 0; i < 8; ++i)
  {
    rows += std::to_string(i % 2) + ".5 " + std::to_string(i / 2 % 2) + ".5 " +
      std::to_string(i / 4) + ".5\n";
  }
  const std::string plates = rows +
    "12\n1 2 3\n2 4 3\n5 7 6\n6 7 8\n1 5 2\n2 5 6\n3 4 7\n4 8 7\n1 3 5\n3 7 5\n2 6 "
    "4\n4 6 8\n";
  ASSERT_EQ(parse(plates).Status.Code, ParseCode::Ok);
  EXPECT_TRUE(conformal::looksLikeNamedPlateModel(plates));
  EXPECT_FALSE(looksLikePlateModel(plates));
  EXPECT_FALSE(conformal::looksLikeNamedPlateModel(rows)); // a cloud with its number of points
}

TEST(PlateModelParser, ReadsAllGoodAndRefusesAllBadFiles)
{
  for (const std::string& text : samples::PlateModelFiles())
  {
    EXPECT_EQ(parse(text).Status.Code, ParseCode::Ok) << text;
    EXPECT_TRUE(looksLikePlateModel(text)) << text;
  }
  for (const std::string& text : samples::BadPlateModelFiles())
  {
    EXPECT_NE(parse(text).Status.Code, ParseCode::Ok) << text;
  }
}

TEST(PlateModelParser, NamesRowsOfAWrongLength)
{
  const auto expectMessage =
    [](const std::string& text, std::uint64_t line, const std::string& message)
  {
    const SurfaceResult result = parse(text);
    EXPECT_EQ(result.Status.Code, ParseCode::Malformed);
    EXPECT_EQ(result.Status.Line, line);
    EXPECT_NE(result.Status.Message.find(message), std::string::npos) << result.Status.Message;
  };
  const std::string columns = " columns, expected ";
  expectMessage(samples::replaced(samples::NumberedPlates(), "1.50000", ""), 3,
    "with 3" + columns + "4 columns as in the first row");
  expectMessage(samples::replaced(samples::NumberedPlates(), "1.50000", "1.5 7"), 3,
    "with 5" + columns + "4 columns");
  expectMessage(samples::replaced(samples::NumberedPlates(), "1.50000", "x"), 3, "expected X Y Z");
  expectMessage(
    samples::replaced(samples::NumberedPlates(), "       2       1       2       4", "1 2 4"), 8,
    "with 3" + columns + "4 columns");
  expectMessage(samples::replaced(samples::VerPlates(), " 3\n 1 2 4", " 3\n 1 2"), 9,
    "with 2" + columns + "3 columns");
}

TEST(PlateModelParser, DropsPlatesOfARepeatedVertex)
{
  const SurfaceResult result = parse(samples::replaced(samples::VerPlates(), "1 2 4", "1 2 2"));
  ASSERT_EQ(result.Status.Code, ParseCode::Ok);
  EXPECT_EQ(result.Data.DroppedPolygons, 1u);
  EXPECT_EQ(result.Data.PolygonIds.size(), 9u);
}

TEST(PlateModelParser, TakesNoOtherTables)
{
  for (const char* text : { "", "4\n", "4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "2 1\n0 0 0\n1 1 1\n",
         "4 4 6\n0 0 0\n1 0 0\n0 1 0\n", "3\n7 0 0 0\n8 0 0 0\n9 0 0 0\n", "a b\n1 2 3\n",
         "0 0 0\n1 0 0\n0 1 0\n1 1 1\n" })
  {
    EXPECT_FALSE(looksLikePlateModel(text)) << text;
  }
}
