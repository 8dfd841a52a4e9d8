#include "Grids.h"
#include "Hull/FreudenthalGrid.h"
#include "Hull/GridSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using conformal::eulerNumber;
using conformal::FreudenthalGrid;
using conformal::Index;
using grids::cube;
using grids::Marks;

namespace
{
// Nodes of a block, both corners included.
void fill(const FreudenthalGrid& grid, Marks& marks, Eigen::Vector3i low, Eigen::Vector3i high,
  std::uint8_t mark)
{
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        marks[grid.node(x, y, z)] = mark;
      }
    }
  }
}

unsigned int neighborsInSet(const FreudenthalGrid& grid, const Marks& marks, int node)
{
  unsigned int neighbors = 0;
  const std::array<int, 14> steps = grid.neighborSteps();
  for (int i = 0; i < 14; ++i)
  {
    neighbors |= static_cast<unsigned int>(marks[node + steps[i]]) << i;
  }
  return neighbors;
}

Index numberOfPieces(const FreudenthalGrid& grid, Marks marks, std::uint8_t mark)
{
  // A rim of other nodes, so that pieces of the complement end somewhere.
  Marks inner(marks.size(), 2);
  for (int z = 1; z < grid.Size[2] - 1; ++z)
  {
    for (int y = 1; y < grid.Size[1] - 1; ++y)
    {
      for (int x = 1; x < grid.Size[0] - 1; ++x)
      {
        inner[grid.node(x, y, z)] = marks[grid.node(x, y, z)];
      }
    }
  }
  std::vector<int> piece;
  Index count = 0;
  for (int node = 0; node < static_cast<int>(inner.size()); ++node)
  {
    if (inner[node] == mark)
    {
      conformal::markPiece(grid, inner, node, 3, piece);
      ++count;
    }
  }
  return count;
}
}

TEST(FreudenthalGrid, KnowsItsNodes)
{
  FreudenthalGrid grid;
  grid.Size = { 4, 5, 6 };
  grid.Origin = { 1.0, 2.0, 3.0 };
  grid.Spacing = 0.5;
  const int node = grid.node(3, 1, 4);
  EXPECT_EQ(grid.coordinates(node), Eigen::Vector3i(3, 1, 4));
  EXPECT_EQ(grid.position(node), conformal::Vector3(2.5, 2.5, 5.0));
  EXPECT_EQ(grid.toGrid(grid.position(node)), conformal::Vector3(3.0, 1.0, 4.0));
  EXPECT_EQ(grid.numberOfNodes(), 120);
}

TEST(FreudenthalGrid, VisitsInnerNodesOnce)
{
  FreudenthalGrid grid;
  grid.Size = { 5, 6, 40 };
  Marks visits(grid.numberOfNodes(), 0), expected(grid.numberOfNodes(), 0);
  fill(grid, expected, { 1, 1, 1 }, { 3, 4, 38 }, 1);
  conformal::forInnerRows(grid, {},
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        ++visits[node];
      }
    });
  EXPECT_EQ(visits, expected);
}

TEST(FreudenthalGrid, CountsHandlesAndCavities)
{
  const FreudenthalGrid grid = cube(8);
  Marks marks(grid.numberOfNodes(), 0);
  EXPECT_EQ(eulerNumber(grid, marks), 0);
  fill(grid, marks, { 2, 2, 2 }, { 4, 4, 4 }, 1);
  EXPECT_EQ(eulerNumber(grid, marks), 1); // a ball
  fill(grid, marks, { 3, 3, 3 }, { 3, 3, 3 }, 0);
  EXPECT_EQ(eulerNumber(grid, marks), 2); // with a cavity
  fill(grid, marks, { 3, 3, 2 }, { 3, 3, 4 }, 0);
  EXPECT_EQ(eulerNumber(grid, marks), 0); // pierced: a ring
  fill(grid, marks, { 6, 6, 6 }, { 6, 6, 6 }, 1);
  EXPECT_EQ(eulerNumber(grid, marks), 1); // and a ball
}

// Whatever surrounds it, a simple node changes neither the Euler number nor the pieces of either
// side; and a node that changes one of them is not simple.
TEST(FreudenthalGrid, SimpleNodesKeepTheTopology)
{
  const FreudenthalGrid grid = cube(5);
  const int center = grid.node(2, 2, 2);
  std::mt19937 random(1);
  int simple = 0;
  for (int i = 0; i < 3000; ++i)
  {
    Marks without(grid.numberOfNodes(), 0);
    const unsigned int threshold = 1 + random() % 7;
    for (const int step : grid.neighborSteps())
    {
      without[center + step] = random() % 8 < threshold;
    }
    Marks with = without;
    with[center] = 1;
    const bool kept = eulerNumber(grid, without) == eulerNumber(grid, with) &&
      numberOfPieces(grid, without, 1) == numberOfPieces(grid, with, 1);
    if (conformal::isSimpleNode(neighborsInSet(grid, without, center)))
    {
      ++simple;
      ASSERT_TRUE(kept);
      ASSERT_EQ(numberOfPieces(grid, without, 0), numberOfPieces(grid, with, 0));
    }
    else
    {
      // With a connected link, or none, the Euler number tells; else the pieces of a small ball do.
      ASSERT_FALSE(kept);
    }
  }
  EXPECT_GT(simple, 300);
  EXPECT_LT(simple, 2700);
}

TEST(FreudenthalGrid, KeepsTheMaximumPiece)
{
  const FreudenthalGrid grid = cube(10);
  Marks marks(grid.numberOfNodes(), 0), expected = marks;
  fill(grid, marks, { 1, 1, 1 }, { 2, 2, 2 }, 1);
  fill(grid, marks, { 4, 4, 4 }, { 7, 7, 7 }, 1);
  fill(grid, marks, { 1, 8, 1 }, { 8, 8, 1 }, 1);
  fill(grid, expected, { 4, 4, 4 }, { 7, 7, 7 }, 1);
  EXPECT_EQ(conformal::keepLargestPiece(grid, marks), 64);
  EXPECT_EQ(marks, expected);
}

// A ring that is thinner at one place is cut there, and the least that opens it.
TEST(FreudenthalGrid, CutsHandlesWhereTheyAreThinnest)
{
  const FreudenthalGrid grid = cube(16);
  Marks marks(grid.numberOfNodes(), 0);
  fill(grid, marks, { 2, 2, 6 }, { 13, 13, 9 }, 1);
  fill(grid, marks, { 6, 6, 6 }, { 9, 9, 9 }, 0);
  fill(grid, marks, { 8, 2, 6 }, { 8, 5, 9 }, 0);
  fill(grid, marks, { 8, 4, 7 }, { 8, 4, 7 }, 1); // a bridge of one node
  std::vector<float> distances(marks.size(), 2.0F);
  distances[grid.node(8, 4, 7)] = 1.5F;
  const Marks before = marks;
  EXPECT_EQ(eulerNumber(grid, marks), 0);
  EXPECT_EQ(conformal::cutHandles(grid, marks, distances, 1.0), 1);
  EXPECT_EQ(eulerNumber(grid, marks), 1);
  EXPECT_EQ(marks[grid.node(8, 4, 7)], 0);
  EXPECT_EQ(std::accumulate(before.begin(), before.end(), 0) - 1,
    std::accumulate(marks.begin(), marks.end(), 0));
}

// What a change of some nodes changes is told by these and those around them.
TEST(FreudenthalGrid, CountsTheEulerNumberAroundNodes)
{
  const FreudenthalGrid grid = cube(9);
  std::mt19937 random(1);
  Marks inside(grid.numberOfNodes(), 0);
  fill(grid, inside, { 2, 2, 2 }, { 6, 6, 6 }, 1);
  Index gain = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<int> nodes;
    for (int k = 0; k < 4; ++k)
    {
      const auto at = [&] { return 1 + static_cast<int>(random() % 7); };
      const int x = at(), y = at(), z = at();
      nodes.push_back(grid.node(x, y, z));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const Index whole = eulerNumber(grid, inside);
    const Index around = conformal::eulerNumberAround(grid, inside, nodes);
    for (const int node : nodes)
    {
      inside[node] = !inside[node];
    }
    const Index change = conformal::eulerNumberAround(grid, inside, nodes) - around;
    EXPECT_EQ(eulerNumber(grid, inside) - whole, change);
    gain += std::abs(change);
  }
  EXPECT_GT(gain, 20);
}
