#include "Learn/OpenSurface.h"

#include "Learn/ConformalSOM.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Sheets.h"
#include "SphereMap/SheetMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Border;
using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::Points;
using conformal::TrainingSamples;

namespace
{
constexpr double Height = 0.2;

ConformalSOMOptions optionsFor(Border border)
{
  ConformalSOMOptions options;
  options.NumberOfNeurons = 1500;
  options.Opening.Border = border;
  return options;
}

ConformalSOMResult learned(const Points& points, Border border, const conformal::Run& run = {})
{
  return conformal::trainConformalSOM(TrainingSamples(points), optionsFor(border), nullptr, run);
}

// Distance from the circle where points end, in their spacing.
double errorOfBorder(const ConformalSOMResult& result, Index count)
{
  const double spacing =
    std::sqrt(2.0 * conformal::Pi * (1.0 - Height) / static_cast<double>(count));
  const auto loop = conformal::borderLoops(result).at(0);
  double sum = 0.0;
  for (const int v : loop)
  {
    sum += std::abs(result.Positions(v, 2) - Height) / spacing;
  }
  return sum / static_cast<double>(loop.size());
}
}

TEST(OpenSurface, EndsWherePointsEndAndIsMappedToTheHemisphere)
{
  const Points points = sheets::pointsAbove(Height, 20000, 7);
  for (const Border border : { Border::Automatic, Border::Open })
  {
    const ConformalSOMResult result = learned(points, border);
    EXPECT_EQ(result.NumberOfBorders, 1);
    EXPECT_GT(result.OpenFraction, 0.2);
    EXPECT_TRUE(conformal::isSheet(result.Triangles, result.Positions.rows()));
    EXPECT_LT(errorOfBorder(result, points.rows()), 0.5);
    EXPECT_EQ(result.SpherePositions.col(2).minCoeff(), 0.0);
    for (Index v = 0; v < result.Positions.rows(); ++v)
    {
      EXPECT_NEAR(result.Positions.row(v).norm(), 1.0, 0.015);
    }
    EXPECT_EQ(static_cast<Index>(result.Supported.size()), result.Positions.rows());
    EXPECT_EQ(static_cast<Index>(result.StandardError.size()), result.Positions.rows());
  }
}

TEST(OpenSurface, ClosedIsClosed)
{
  const Points points = sheets::pointsAbove(Height, 20000, 7);
  const ConformalSOMResult result = learned(points, Border::Closed);
  EXPECT_EQ(result.NumberOfBorders, 0);
  EXPECT_EQ(result.OpenFraction, 0.0);
  EXPECT_TRUE(conformal::borderLoops(result).empty());
}

// A scan of the whole object has no border, and its mesh has the same bits with Automatic.
TEST(OpenSurface, AWholeObjectIsClosed)
{
  const Points points = sheets::pointsAbove(-1.0, 20000, 7);
  const ConformalSOMResult automatic = learned(points, Border::Automatic),
                           closed = learned(points, Border::Closed);
  EXPECT_EQ(automatic.NumberOfBorders, 0);
  EXPECT_EQ(automatic.Positions, closed.Positions);
  EXPECT_EQ(automatic.SpherePositions, closed.SpherePositions);
}

TEST(OpenSurface, SameBitsInAnyOrderOfBlocks)
{
  const Points points = sheets::pointsAbove(Height, 8000, 7);
  const ConformalSOMResult one = learned(points, Border::Open),
                           other = learned(points, Border::Open, runs::backwards());
  EXPECT_EQ(one.Positions, other.Positions);
  EXPECT_EQ(one.SpherePositions, other.SpherePositions);
}

TEST(OpenSurface, RejectsWhatHasNoBorder)
{
  const Points points = sheets::pointsAbove(Height, 1000, 7);
  const TrainingSamples samples(points);
  ConformalSOMOptions geodesic = optionsFor(Border::Open);
  geodesic.MeshType = conformal::MeshType::Geodesic;
  EXPECT_THROW(conformal::trainConformalSOM(samples, geodesic), std::invalid_argument);
  ConformalSOMOptions negative = optionsFor(Border::Open);
  negative.Opening.HoleSize = -1.0;
  EXPECT_THROW(conformal::trainConformalSOM(samples, negative), std::invalid_argument);
}
