#include "Hull/FreeSpace.h"

#include "Hull/IndicatorSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using conformal::freeSpace;
using conformal::FreudenthalGrid;
using conformal::Index;
using conformal::IndicatorSolid;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
constexpr double PointSpacing = 0.04;

FreudenthalGrid gridOfUnitCube()
{
  FreudenthalGrid grid;
  grid.Origin = Vector3(-1.0, -1.0, -1.0);
  grid.Spacing = 0.05;
  grid.Size = { 41, 41, 41 };
  return grid;
}

// A square of points at height z.
Points square(double z)
{
  constexpr int side = 41;
  Points points(side * side, 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    points.row(i) = Vector3(PointSpacing * (i % side - 20), PointSpacing * (i / side - 20), z);
  }
  return points;
}

Points toScanner(const Points& points, const Vector3& scanner)
{
  return (-points).rowwise() + scanner.transpose();
}

float at(const FreudenthalGrid& grid, const std::vector<float>& values, const Vector3& place)
{
  const Eigen::Vector3i node = grid.toGrid(place).array().round().cast<int>();
  return values[grid.node(node[0], node[1], node[2])];
}

void addRectangle(
  std::vector<double>& points, const Vector3& corner, const Vector3& along, const Vector3& across)
{
  const int n = static_cast<int>(along.norm() / PointSpacing),
            m = static_cast<int>(across.norm() / PointSpacing);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= m; ++j)
    {
      const Vector3 x = corner + i * along / n + j * across / m;
      points.insert(points.end(), x.data(), x.data() + 3);
    }
  }
}

// A block with a wide slot, cut into it from above. A scanner above has measured the block without
// the walls of the slot.
Points slottedBlock()
{
  const Vector3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  std::vector<double> points;
  addRectangle(points, { -1, -0.5, -0.5 }, 2 * x, y);   // bottom
  addRectangle(points, { -1, -0.5, -0.5 }, y, 1.1 * z); // left
  addRectangle(points, { 1, -0.5, -0.5 }, y, 1.1 * z);  // right
  for (const double side : { -0.5, 0.5 })
  {
    addRectangle(points, { -1, side, -0.5 }, 2 * x, 0.3 * z);   // below the slot
    addRectangle(points, { -1, side, -0.2 }, 0.7 * x, 0.8 * z); // beside it
    addRectangle(points, { 0.3, side, -0.2 }, 0.7 * x, 0.8 * z);
  }
  addRectangle(points, { -1, -0.5, 0.6 }, 0.7 * x, y); // top
  addRectangle(points, { 0.3, -0.5, 0.6 }, 0.7 * x, y);
  addRectangle(points, { -0.3, -0.5, -0.2 }, 0.6 * x, y); // floor of the slot
  return Eigen::Map<const Points>(points.data(), static_cast<Index>(points.size()) / 3, 3);
}

bool isInside(const IndicatorSolid& solid, const Vector3& place)
{
  const Eigen::Vector3i node = solid.Grid.toGrid(place).array().round().cast<int>();
  return solid.Inside[solid.Grid.node(node[0], node[1], node[2])] == 1;
}
}

TEST(FreeSpace, IsBetweenPointsAndScannersAlone)
{
  const FreudenthalGrid grid = gridOfUnitCube();
  const Points points = square(0.0);
  const std::vector<float> free =
    freeSpace(grid, points, toScanner(points, { 0, 0, 1e6 }), PointSpacing, 0.0);
  EXPECT_EQ(at(grid, free, { 0, 0, 0.5 }), 1.0F);
  EXPECT_EQ(at(grid, free, { 0.5, -0.5, 0.9 }), 1.0F);
  for (const double z : { -0.9, -0.5, 0.0, 0.05 })
  {
    EXPECT_EQ(at(grid, free, { 0, 0, z }), 0.0F) << z; // behind the points, or at them
  }
  EXPECT_EQ(at(grid, free, { 0.95, 0, 0.5 }), 0.0F); // beside all rays
  EXPECT_EQ(*std::min_element(free.begin(), free.end()), 0.0F);
  EXPECT_EQ(*std::max_element(free.begin(), free.end()), 1.0F);
}

TEST(FreeSpace, EndsAtTheScanner)
{
  const FreudenthalGrid grid = gridOfUnitCube();
  const Points points = square(-0.8);
  const std::vector<float> free =
    freeSpace(grid, points, toScanner(points, { 0, 0, 0.3 }), PointSpacing, 0.0);
  EXPECT_EQ(at(grid, free, { 0, 0, 0 }), 1.0F);
  EXPECT_EQ(at(grid, free, { 0, 0, 0.6 }), 0.0F);
}

TEST(FreeSpace, IsEmptyWithoutScanners)
{
  const FreudenthalGrid grid = gridOfUnitCube();
  const Points points = square(0.0);
  const Points unknown = Points::Zero(points.rows(), 3);
  for (const float value : freeSpace(grid, points, unknown, PointSpacing, 0.0))
  {
    EXPECT_EQ(value, 0.0F);
  }
}

TEST(FreeSpace, IsOutsideOfTheSolid)
{
  const Points points = slottedBlock();
  TrainingSamples samples{ PointView(points) };
  const IndicatorSolid closed = conformal::solidByWindingNumbers(samples, 0.04);
  // The scanner above has measured the floor of the slot, and the top.
  Points scanners = Points::Constant(points.rows(), 3, std::numeric_limits<double>::quiet_NaN());
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = points.row(i);
    if (x[2] > 0.59 || (std::abs(x[0]) < 0.29 && std::abs(x[1]) < 0.49 && x[2] > -0.21))
    {
      scanners.row(i) = x + Vector3(0, 0, 100);
    }
  }
  samples.setScanners(PointView(scanners));
  const IndicatorSolid carved = conformal::solidByWindingNumbers(samples, 0.04);
  const Vector3 inSlot = samples.normalize({ 0, 0, 0.1 });
  EXPECT_TRUE(isInside(closed, inSlot)); // nothing else is known of it
  EXPECT_FALSE(isInside(carved, inSlot));
  for (const double side : { -1.0, 1.0 })
  {
    EXPECT_TRUE(isInside(carved, samples.normalize({ 0.7 * side, 0, 0.1 })));
  }
  EXPECT_EQ(eulerNumber(carved.Grid, carved.Inside), 1);
}

TEST(FreeSpace, NeedsFinitePositionsOfScanners)
{
  const Points points = square(0.0);
  TrainingSamples samples{ PointView(points) };
  Points scanners = Points::Constant(points.rows(), 3, 2.0);
  scanners(1, 0) = std::numeric_limits<double>::quiet_NaN();
  samples.setScanners(PointView(scanners));
  EXPECT_EQ(samples.toScanner(1), Vector3::Zero());
  EXPECT_LT((samples[0] + samples.toScanner(0) - samples.normalize({ 2, 2, 2 })).norm(), 1e-12);
  const Points few = Points::Zero(2, 3);
  EXPECT_THROW(samples.setScanners(PointView(few)), std::invalid_argument);
}
