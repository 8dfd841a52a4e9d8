#include "Hull/GridSolid.h"

#include "Grids.h"

#include <gtest/gtest.h>

#include <algorithm>

using conformal::cutHandles;
using conformal::eulerNumber;
using conformal::fillHandles;
using conformal::FreudenthalGrid;
using conformal::HandleCut;
using conformal::Index;
using conformal::keepLargestPiece;
using grids::cube;
using grids::Marks;

namespace
{
// A square ring in the middle plane, three nodes thick, around a hole three nodes wide.
Marks ring(const FreudenthalGrid& grid)
{
  Marks inside(grid.numberOfNodes(), 0);
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    const Eigen::Vector3i x = grid.coordinates(node).array() - 9;
    const int off = std::max(std::abs(x[0]), std::abs(x[1]));
    inside[node] = std::abs(x[2]) <= 1 && off >= 2 && off <= 4;
  }
  return inside;
}
}

TEST(GridSolid, KeepsTheLargestPiece)
{
  const FreudenthalGrid grid = cube(19);
  const Marks large = ring(grid);
  Marks inside = large;
  inside[grid.node(2, 2, 2)] = inside[grid.node(3, 2, 2)] = 1;
  EXPECT_EQ(keepLargestPiece(grid, inside), std::count(large.begin(), large.end(), 1));
  EXPECT_EQ(inside, large);
}

// Across the hole lies one layer of nodes that the values mind less than the others.
TEST(GridSolid, FillsAHandleWhereValuesAreHighest)
{
  const FreudenthalGrid grid = cube(19);
  const Marks before = ring(grid);
  std::vector<float> values(before.size());
  for (int node = 0; node < static_cast<int>(before.size()); ++node)
  {
    const Eigen::Vector3i x = grid.coordinates(node).array() - 9;
    values[node] = before[node] ? 1.0F : x[2] == 1 ? 0.4F : 0.0F;
  }
  Marks inside = before;
  ASSERT_EQ(eulerNumber(grid, inside), 0);
  EXPECT_EQ(fillHandles(grid, inside, values), 9);
  EXPECT_EQ(eulerNumber(grid, inside), 1);
  for (int node = 0; node < static_cast<int>(before.size()); ++node)
  {
    const Eigen::Vector3i x = grid.coordinates(node).array() - 9;
    const bool lid = x[2] == 1 && std::max(std::abs(x[0]), std::abs(x[1])) <= 1;
    EXPECT_EQ(inside[node], before[node] || lid) << x.transpose();
  }
}

TEST(GridSolid, FillsNothingWithoutHandles)
{
  const FreudenthalGrid grid = cube(9);
  Marks inside(grid.numberOfNodes(), 0);
  inside[grid.node(4, 4, 4)] = inside[grid.node(5, 4, 4)] = 1;
  const Marks before = inside;
  EXPECT_EQ(fillHandles(grid, inside, std::vector<float>(inside.size(), 0.0F)), 0);
  EXPECT_EQ(inside, before);
}

TEST(GridSolid, CutsAHandleThroughItsTube)
{
  const FreudenthalGrid grid = cube(19);
  Marks inside = ring(grid);
  const Index before = std::count(inside.begin(), inside.end(), 1);
  const std::vector<float> depths(inside.size(), 1.0F);
  const Index cut = cutHandles(grid, inside, depths, 0.5, HandleCut::HalfWay);
  EXPECT_EQ(before - std::count(inside.begin(), inside.end(), 1), cut);
  EXPECT_GE(cut, 9); // the tube is three by three
  EXPECT_LE(cut, 20);
  EXPECT_EQ(eulerNumber(grid, inside), 1);
}
