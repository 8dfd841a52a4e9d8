#include "Hull/SolidRepair.h"

#include "Grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using conformal::eulerNumber;
using conformal::fillCavities;
using conformal::FreudenthalGrid;
using conformal::HandleRepair;
using conformal::Index;
using conformal::Indicator;
using conformal::joinPieces;
using conformal::openHandles;
using conformal::Vector3;
using grids::Marks;

namespace
{
FreudenthalGrid fineCube(int size)
{
  FreudenthalGrid grid = grids::cube(size);
  grid.Spacing = 0.01;
  return grid;
}

// Nodes for whose places, from the middle of the grid, the test holds.
Marks where(const FreudenthalGrid& grid, const std::function<bool(const Vector3&)>& test)
{
  const int middle = grid.Size[0] / 2;
  Marks inside(grid.numberOfNodes(), 0);
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    const Eigen::Vector3i x = grid.coordinates(node).array() - middle;
    inside[node] = test(x.cast<double>());
  }
  return inside;
}

// 1 inside and 0 outside.
Indicator indicatorOf(const Marks& inside)
{
  Indicator indicator;
  indicator.Values.assign(inside.begin(), inside.end());
  return indicator;
}

Index size(const Marks& inside)
{
  return std::count(inside.begin(), inside.end(), 1);
}

int numberOfPieces(const FreudenthalGrid& grid, Marks inside)
{
  std::vector<int> piece;
  int count = 0;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    if (inside[node] == 1)
    {
      markPiece(grid, inside, node, 2, piece);
      ++count;
    }
  }
  return count;
}

// Around the z axis.
bool inRing(const Vector3& x, double radius, double tube)
{
  return std::hypot(std::hypot(x[0], x[1]) - radius, x[2]) < tube;
}
}

// A body, a limb that a gap of three nodes has parted from it, a crumb, and another thing far away.
TEST(SolidRepair, JoinsLimbsAndDropsTheRest)
{
  const FreudenthalGrid grid = fineCube(61);
  const auto body = [](const Vector3& x) { return (x - Vector3(-8, 0, 0)).norm() < 12.0; };
  const auto limb = [](const Vector3& x) { return (x - Vector3(12, 0, 0)).norm() < 5.0; };
  const auto crumb = [](const Vector3& x) { return (x - Vector3(-8, 15, 0)).norm() < 0.5; };
  const auto other = [](const Vector3& x) { return (x - Vector3(20, 20, 20)).norm() < 3.0; };
  Marks inside =
    where(grid, [&](const Vector3& x) { return body(x) || limb(x) || crumb(x) || other(x); });
  ASSERT_EQ(numberOfPieces(grid, inside), 4);
  const Indicator indicator = indicatorOf(inside);
  const Index added = joinPieces(grid, indicator, inside);
  const Marks kept = where(grid, [&](const Vector3& x) { return body(x) || limb(x); });
  EXPECT_EQ(numberOfPieces(grid, inside), 1);
  EXPECT_EQ(size(inside), size(kept) + added);
  EXPECT_GE(added, 9);
  EXPECT_LE(added, 100);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    EXPECT_GE(inside[node], kept[node]);
  }
}

// Two ends of a limb face each other over a gap of 20 nodes. If the ends are open, the indicator
// between them falls to 0.2 only, and no samples are there. Separate objects are closed.
TEST(SolidRepair, JoinsLimbsAcrossHolesButNoSeparateObjects)
{
  const FreudenthalGrid grid = fineCube(81);
  const auto body = [](const Vector3& x) { return (x - Vector3(-22, 0, 0)).norm() < 14.0; };
  const auto limb = [](const Vector3& x)
  { return x[0] > 10.0 && x[0] < 32.0 && std::hypot(x[1], x[2]) < 6.0; };
  const Marks both = where(grid, [&](const Vector3& x) { return body(x) || limb(x); });
  ASSERT_EQ(numberOfPieces(grid, both), 2);
  enum Ends
  {
    Open,
    ClosedBySamples,
    ClosedByIndicator
  };
  for (const Ends ends : { Open, ClosedBySamples, ClosedByIndicator })
  {
    const bool open = ends == Open;
    Indicator indicator = indicatorOf(both);
    for (int node = 0; node < static_cast<int>(both.size()); ++node)
    {
      const Vector3 x = (grid.coordinates(node).array() - 40).matrix().cast<double>();
      if (ends != ClosedByIndicator && !both[node] && std::abs(x[0]) < 12.0 &&
        std::hypot(x[1], x[2]) < 6.0)
      {
        indicator.Values[node] = 0.2F;
      }
    }
    Marks inside = both;
    const Index added =
      joinPieces(grid, indicator, inside, [&](int) { return ends == ClosedBySamples; });
    EXPECT_EQ(numberOfPieces(grid, inside), 1);
    EXPECT_EQ(inside[grid.node(60, 40, 40)], open);
    if (open)
    {
      EXPECT_EQ(size(inside), size(both) + added);
      EXPECT_EQ(inside[grid.node(40, 43, 40)], 1); // as wide as the indicator is nearly constant
      EXPECT_EQ(inside[grid.node(40, 48, 40)], 0);
      EXPECT_EQ(eulerNumber(grid, inside), 1);
    }
  }
}

TEST(SolidRepair, JoinsAlongWhatIsNearlyInside)
{
  const FreudenthalGrid grid = fineCube(41);
  Marks inside = where(grid,
    [](const Vector3& x) {
      return std::abs(x[2]) <= 1 && std::abs(std::abs(x[0]) - 8.0) <= 5.0 && std::abs(x[1]) <= 12.0;
    });
  ASSERT_EQ(numberOfPieces(grid, inside), 2);
  Indicator indicator = indicatorOf(inside);
  for (int x = -2; x <= 2; ++x) // a thread, not the shortest way
  {
    indicator.Values[grid.node(20 + x, 30, 20)] = 0.45F;
  }
  joinPieces(grid, indicator, inside);
  EXPECT_EQ(inside[grid.node(20, 30, 20)], 1);
  EXPECT_EQ(inside[grid.node(20, 20, 20)], 0);
  EXPECT_EQ(eulerNumber(grid, inside), 1);
}

TEST(SolidRepair, FillsCavities)
{
  const FreudenthalGrid grid = fineCube(31);
  const auto isSolid = [](const Vector3& x)
  {
    return x.norm() < 11.0 && (x - Vector3(4, 0, 0)).norm() > 3.0 &&
      (x + Vector3(4, 0, 0)).norm() > 2.0;
  };
  Marks inside = where(grid, isSolid);
  EXPECT_EQ(fillCavities(grid, inside), 2);
  EXPECT_EQ(inside, where(grid, [](const Vector3& x) { return x.norm() < 11.0; }));
  EXPECT_EQ(fillCavities(grid, inside), 0);
}

TEST(SolidRepair, CutsThinRingsAndFillsNarrowHoles)
{
  const FreudenthalGrid grid = fineCube(45);
  // The way through a ring's tube against that across its hole.
  Marks thin = where(grid, [](const Vector3& x) { return inRing(x, 14.0, 2.0); });
  const Marks thinBefore = thin;
  const HandleRepair cut = openHandles(grid, indicatorOf(thin), thin);
  EXPECT_EQ(eulerNumber(grid, thin), 1);
  EXPECT_EQ(cut.NumberOfFilledNodes, 0);
  EXPECT_EQ(cut.NumberOfCutNodes, size(thinBefore) - size(thin));
  EXPECT_GE(cut.NumberOfCutNodes, 9);

  Marks thick = where(grid, [](const Vector3& x) { return inRing(x, 10.0, 7.5); });
  const Marks thickBefore = thick;
  const HandleRepair filled = openHandles(grid, indicatorOf(thick), thick);
  EXPECT_EQ(eulerNumber(grid, thick), 1);
  EXPECT_EQ(filled.NumberOfCutNodes, 0);
  EXPECT_EQ(filled.NumberOfFilledNodes, size(thick) - size(thickBefore));
  EXPECT_GE(filled.NumberOfFilledNodes, 9);
  EXPECT_EQ(filled.NumberOfDefiniteNodes, filled.NumberOfFilledNodes); // as far off as can be
}

// The ring of before is cut where the indicator is in doubt, though its hole is narrow.
TEST(SolidRepair, CutsWhereTheIndicatorDoubts)
{
  const FreudenthalGrid grid = fineCube(45);
  Marks inside = where(grid, [](const Vector3& x) { return inRing(x, 10.0, 7.5); });
  Indicator indicator = indicatorOf(inside);
  const Marks doubted =
    where(grid, [](const Vector3& x) { return x[0] > 0.0 && std::abs(x[1]) <= 2.0; });
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    indicator.Values[node] = inside[node] && doubted[node] ? 0.501F : indicator.Values[node];
  }
  const Marks before = inside;
  const HandleRepair repair = openHandles(grid, indicator, inside);
  EXPECT_EQ(eulerNumber(grid, inside), 1);
  EXPECT_EQ(repair.NumberOfFilledNodes, 0);
  EXPECT_GT(repair.NumberOfCutNodes, 100);
  EXPECT_EQ(repair.NumberOfDefiniteNodes, 0);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    EXPECT_TRUE(inside[node] == before[node] || doubted[node]);
  }
}

TEST(SolidRepair, OpensManyHandles)
{
  const FreudenthalGrid grid = fineCube(45);
  // A grid of bars: a cube's twelve edges have five handles.
  Marks inside = where(grid,
    [](const Vector3& x)
    {
      int at = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        at += std::abs(std::abs(x[axis]) - 12.0) <= 1.0;
      }
      return at >= 2 && x.cwiseAbs().maxCoeff() <= 13.0;
    });
  ASSERT_EQ(eulerNumber(grid, inside), -4);
  const HandleRepair repair = openHandles(grid, indicatorOf(inside), inside);
  EXPECT_EQ(eulerNumber(grid, inside), 1);
  EXPECT_EQ(numberOfPieces(grid, inside), 1);
  EXPECT_GE(repair.NumberOfCutNodes, 45);
  EXPECT_LE(repair.NumberOfCutNodes, 5 * 20);
}
