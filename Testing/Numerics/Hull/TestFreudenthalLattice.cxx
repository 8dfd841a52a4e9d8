#include "Hull/FreudenthalLattice.h"
#include "Hull/LatticeSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using conformal::eulerNumber;
using conformal::FreudenthalLattice;
using conformal::Index;

namespace
{
using Marks = std::vector<std::uint8_t>;

FreudenthalLattice cube(int size)
{
  FreudenthalLattice lattice;
  lattice.Size = { size, size, size };
  return lattice;
}

// Nodes of a block, both corners included.
void fill(const FreudenthalLattice& lattice, Marks& marks, Eigen::Vector3i low,
  Eigen::Vector3i high, std::uint8_t mark)
{
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        marks[lattice.node(x, y, z)] = mark;
      }
    }
  }
}

unsigned int neighborsInSet(const FreudenthalLattice& lattice, const Marks& marks, int node)
{
  unsigned int neighbors = 0;
  const std::array<int, 14> steps = lattice.neighborSteps();
  for (int i = 0; i < 14; ++i)
  {
    neighbors |= static_cast<unsigned int>(marks[node + steps[i]]) << i;
  }
  return neighbors;
}

Index numberOfPieces(const FreudenthalLattice& lattice, Marks marks, std::uint8_t mark)
{
  // A rim of other nodes, so that pieces of the complement end somewhere.
  Marks inner(marks.size(), 2);
  for (int z = 1; z < lattice.Size[2] - 1; ++z)
  {
    for (int y = 1; y < lattice.Size[1] - 1; ++y)
    {
      for (int x = 1; x < lattice.Size[0] - 1; ++x)
      {
        inner[lattice.node(x, y, z)] = marks[lattice.node(x, y, z)];
      }
    }
  }
  std::vector<int> piece;
  Index count = 0;
  for (int node = 0; node < static_cast<int>(inner.size()); ++node)
  {
    if (inner[node] == mark)
    {
      conformal::markPiece(lattice, inner, node, 3, piece);
      ++count;
    }
  }
  return count;
}
}

TEST(FreudenthalLattice, KnowsItsNodes)
{
  FreudenthalLattice lattice;
  lattice.Size = { 4, 5, 6 };
  lattice.Origin = { 1.0, 2.0, 3.0 };
  lattice.Spacing = 0.5;
  const int node = lattice.node(3, 1, 4);
  EXPECT_EQ(lattice.coordinates(node), Eigen::Vector3i(3, 1, 4));
  EXPECT_EQ(lattice.position(node), conformal::Vector3(2.5, 2.5, 5.0));
  EXPECT_EQ(lattice.toLattice(lattice.position(node)), conformal::Vector3(3.0, 1.0, 4.0));
  EXPECT_EQ(lattice.numberOfNodes(), 120);
}

TEST(FreudenthalLattice, VisitsInnerNodesOnce)
{
  FreudenthalLattice lattice;
  lattice.Size = { 5, 6, 40 };
  Marks visits(lattice.numberOfNodes(), 0), expected(lattice.numberOfNodes(), 0);
  fill(lattice, expected, { 1, 1, 1 }, { 3, 4, 38 }, 1);
  conformal::forInnerRows(lattice, {},
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        ++visits[node];
      }
    });
  EXPECT_EQ(visits, expected);
}

TEST(FreudenthalLattice, CountsHandlesAndCavities)
{
  const FreudenthalLattice lattice = cube(8);
  Marks marks(lattice.numberOfNodes(), 0);
  EXPECT_EQ(eulerNumber(lattice, marks), 0);
  fill(lattice, marks, { 2, 2, 2 }, { 4, 4, 4 }, 1);
  EXPECT_EQ(eulerNumber(lattice, marks), 1); // a ball
  fill(lattice, marks, { 3, 3, 3 }, { 3, 3, 3 }, 0);
  EXPECT_EQ(eulerNumber(lattice, marks), 2); // with a cavity
  fill(lattice, marks, { 3, 3, 2 }, { 3, 3, 4 }, 0);
  EXPECT_EQ(eulerNumber(lattice, marks), 0); // pierced: a ring
  fill(lattice, marks, { 6, 6, 6 }, { 6, 6, 6 }, 1);
  EXPECT_EQ(eulerNumber(lattice, marks), 1); // and a ball
}

// Whatever surrounds it, a simple node changes neither the Euler number nor the pieces of either
// side; and a node that changes one of them is not simple.
TEST(FreudenthalLattice, SimpleNodesKeepTheTopology)
{
  const FreudenthalLattice lattice = cube(5);
  const int center = lattice.node(2, 2, 2);
  std::mt19937 random(1);
  int simple = 0;
  for (int i = 0; i < 3000; ++i)
  {
    Marks without(lattice.numberOfNodes(), 0);
    const unsigned int threshold = 1 + random() % 7;
    for (const int step : lattice.neighborSteps())
    {
      without[center + step] = random() % 8 < threshold;
    }
    Marks with = without;
    with[center] = 1;
    const bool kept = eulerNumber(lattice, without) == eulerNumber(lattice, with) &&
      numberOfPieces(lattice, without, 1) == numberOfPieces(lattice, with, 1);
    if (conformal::isSimpleNode(neighborsInSet(lattice, without, center)))
    {
      ++simple;
      ASSERT_TRUE(kept);
      ASSERT_EQ(numberOfPieces(lattice, without, 0), numberOfPieces(lattice, with, 0));
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

TEST(FreudenthalLattice, KeepsTheMaximumPiece)
{
  const FreudenthalLattice lattice = cube(10);
  Marks marks(lattice.numberOfNodes(), 0), expected = marks;
  fill(lattice, marks, { 1, 1, 1 }, { 2, 2, 2 }, 1);
  fill(lattice, marks, { 4, 4, 4 }, { 7, 7, 7 }, 1);
  fill(lattice, marks, { 1, 8, 1 }, { 8, 8, 1 }, 1);
  fill(lattice, expected, { 4, 4, 4 }, { 7, 7, 7 }, 1);
  EXPECT_EQ(conformal::keepLargestPiece(lattice, marks), 64);
  EXPECT_EQ(marks, expected);
}

// A ring that is thinner at one place is cut there, and the least that opens it.
TEST(FreudenthalLattice, CutsHandlesWhereTheyAreThinnest)
{
  const FreudenthalLattice lattice = cube(16);
  Marks marks(lattice.numberOfNodes(), 0);
  fill(lattice, marks, { 2, 2, 6 }, { 13, 13, 9 }, 1);
  fill(lattice, marks, { 6, 6, 6 }, { 9, 9, 9 }, 0);
  fill(lattice, marks, { 8, 2, 6 }, { 8, 5, 9 }, 0);
  fill(lattice, marks, { 8, 4, 7 }, { 8, 4, 7 }, 1); // a bridge of one node
  std::vector<float> distances(marks.size(), 2.0F);
  distances[lattice.node(8, 4, 7)] = 1.5F;
  const Marks before = marks;
  EXPECT_EQ(eulerNumber(lattice, marks), 0);
  EXPECT_EQ(conformal::cutHandles(lattice, marks, distances, 1.0), 1);
  EXPECT_EQ(eulerNumber(lattice, marks), 1);
  EXPECT_EQ(marks[lattice.node(8, 4, 7)], 0);
  EXPECT_EQ(std::accumulate(before.begin(), before.end(), 0) - 1,
    std::accumulate(marks.begin(), marks.end(), 0));
}

// What a change of some nodes changes is told by these and those around them.
TEST(FreudenthalLattice, CountsTheEulerNumberAroundNodes)
{
  const FreudenthalLattice lattice = cube(9);
  std::mt19937 random(1);
  Marks inside(lattice.numberOfNodes(), 0);
  fill(lattice, inside, { 2, 2, 2 }, { 6, 6, 6 }, 1);
  Index gain = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<int> nodes;
    for (int k = 0; k < 4; ++k)
    {
      const auto at = [&] { return 1 + static_cast<int>(random() % 7); };
      const int x = at(), y = at(), z = at();
      nodes.push_back(lattice.node(x, y, z));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const Index whole = eulerNumber(lattice, inside);
    const Index around = conformal::eulerNumberAround(lattice, inside, nodes);
    for (const int node : nodes)
    {
      inside[node] = !inside[node];
    }
    const Index change = conformal::eulerNumberAround(lattice, inside, nodes) - around;
    EXPECT_EQ(eulerNumber(lattice, inside) - whole, change);
    gain += std::abs(change);
  }
  EXPECT_GT(gain, 20);
}
