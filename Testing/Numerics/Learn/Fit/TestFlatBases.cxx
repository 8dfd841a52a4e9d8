#include "Learn/Fit/FlatBases.h"

#include "Mesh/GeodesicSphere.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::flattenBases;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
constexpr double Height = -1.0; // of the base
constexpr double Rim = -0.5;    // height on the sphere that becomes the rim
constexpr double Spacing = 0.03;

// Round column with a round top, at the place of a point of the unit sphere. Its side is vertical
// below the equator.
Vector3 onColumn(const Vector3& x)
{
  const double r = std::hypot(x[0], x[1]);
  if (x[2] >= 0.0 || r == 0.0)
  {
    return x;
  }
  const double radius = std::sqrt(1.0 - Rim * Rim);
  return x[2] > Rim ? Vector3(x[0] / r, x[1] / r, x[2] / Rim * Height)
                    : Vector3(x[0] / radius, x[1] / radius, Height);
}

// Column whose base bulges, as a smooth continuation of its side.
Mesh bulging()
{
  Mesh mesh = conformal::makeGeodesicSphere(24);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    Vector3 x = onColumn(mesh.Positions.row(i));
    const double square = x[0] * x[0] + x[1] * x[1];
    x[2] -= x[2] == Height ? 0.3 * std::sqrt(std::max(0.0, 1.0 - square)) : 0.0;
    mesh.Positions.row(i) = x;
  }
  return mesh;
}

// Samples of the side and of the top.
Points samplesOfColumn()
{
  Points points = sheets::pointsAbove(Rim, 8000, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = onColumn(points.row(i));
  }
  return points;
}

std::vector<int> below(double height, const Points& positions)
{
  std::vector<int> ids;
  for (int i = 0; i < static_cast<int>(positions.rows()); ++i)
  {
    if (positions(i, 2) < height)
    {
      ids.push_back(i);
    }
  }
  return ids;
}
}

TEST(FlatBases, ABaseThatNobodySawBecomesFlat)
{
  Mesh mesh = bulging();
  ASSERT_LT(mesh.Positions.col(2).minCoeff(), Height - 0.2);
  const std::vector<int> gap = below(Height - 0.02, mesh.Positions);
  EXPECT_EQ(flattenBases(samplesOfColumn(), gap, Spacing, 0.0, mesh.Positions, mesh.Triangles), 1);
  EXPECT_GT(mesh.Positions.col(2).minCoeff(), Height - 0.03);
  for (const int vertex : gap)
  {
    EXPECT_NEAR(mesh.Positions(vertex, 2), Height, 0.03);
  }
}

TEST(FlatBases, BetweenScanLinesTheBaseIsBeyondTheLastLine)
{
  constexpr double beyond = 0.05;
  Mesh near = bulging(), far = near;
  const std::vector<int> gap = below(Height - 0.02, near.Positions);
  const Points samples = samplesOfColumn();
  flattenBases(samples, gap, Spacing, 0.0, near.Positions, near.Triangles);
  EXPECT_EQ(flattenBases(samples, gap, Spacing, beyond, far.Positions, far.Triangles), 1);
  EXPECT_NEAR(far.Positions(gap.front(), 2), near.Positions(gap.front(), 2) - beyond, 0.02);
}

TEST(FlatBases, TheBottomOfABallStaysRound)
{
  Mesh mesh = conformal::makeGeodesicSphere(24);
  const Points before = mesh.Positions;
  const Points samples = sheets::pointsAbove(-0.8, 8000, 3);
  EXPECT_EQ(
    flattenBases(samples, below(-0.85, before), Spacing, 0.0, mesh.Positions, mesh.Triangles), 0);
  EXPECT_EQ(mesh.Positions, before);
}

// A side that no scanner saw, of more than 22 % of the surface.
TEST(FlatBases, ALargePartIsNoBase)
{
  Mesh mesh = bulging();
  mesh.Positions.col(2) *= 0.3;
  const Points before = mesh.Positions;
  Points samples = samplesOfColumn();
  samples.col(2) *= 0.3;
  EXPECT_EQ(flattenBases(samples, below(0.3 * Height - 0.02, before), Spacing, 0.0, mesh.Positions,
              mesh.Triangles),
    0);
  EXPECT_EQ(mesh.Positions, before);
}

TEST(FlatBases, AnObjectDoesNotStandOnAPlaneWithPointsBeyondIt)
{
  Mesh mesh = bulging();
  const Points before = mesh.Positions, column = samplesOfColumn();
  Points samples(column.rows() + 80, 3);
  samples << column, Points::Random(80, 3) * 0.05;
  samples.bottomRows(80).col(2).array() += Height - 0.4;
  EXPECT_EQ(flattenBases(
              samples, below(Height - 0.02, before), Spacing, 0.0, mesh.Positions, mesh.Triangles),
    0);
  EXPECT_EQ(mesh.Positions, before);
}

TEST(FlatBases, ABandAroundTheObjectIsNoBase)
{
  Mesh mesh = conformal::makeGeodesicSphere(24);
  std::vector<int> band;
  for (int i = 0; i < static_cast<int>(mesh.Positions.rows()); ++i)
  {
    if (std::abs(mesh.Positions(i, 2)) < 0.1)
    {
      band.push_back(i);
    }
  }
  const Points before = mesh.Positions;
  EXPECT_EQ(flattenBases(sheets::pointsAbove(-1.0, 8000, 3), band, Spacing, 0.0, mesh.Positions,
              mesh.Triangles),
    0);
  EXPECT_EQ(mesh.Positions, before);
  EXPECT_EQ(flattenBases(before, {}, Spacing, 0.0, mesh.Positions, mesh.Triangles), 0);
}
