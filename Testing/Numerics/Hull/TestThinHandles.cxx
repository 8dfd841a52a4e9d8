#include "Hull/ThinHandles.h"

#include "Grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using conformal::eulerNumber;
using conformal::FreudenthalGrid;
using conformal::removeThinHandles;
using conformal::ThinHandles;
using conformal::Vector3;
using grids::cube;
using grids::Marks;

namespace
{
constexpr int Middle = 20;

// Nodes inside of a surface at a distance of 1 from an object, and the distances from the surface
// of the object.
struct Solid
{
  Solid(const std::function<double(const Vector3&)>& signedDistance)
    : Grid(cube(2 * Middle + 1))
    , Inside(Grid.numberOfNodes(), 0)
    , Distances(Grid.numberOfNodes())
  {
    for (int node = 0; node < static_cast<int>(this->Inside.size()); ++node)
    {
      const double distance =
        signedDistance((this->Grid.coordinates(node).array() - Middle).matrix().cast<double>());
      this->Inside[node] = distance <= 1.0;
      this->Distances[node] = static_cast<float>(std::abs(distance));
    }
  }

  FreudenthalGrid Grid;
  Marks Inside;
  std::vector<float> Distances;
};

double ring(const Vector3& x, double radius, double tube)
{
  return std::hypot(std::hypot(x[0], x[1]) - radius, x[2]) - tube;
}
}

// The handle is as wide as the tube, 8, and the opening is 2 (radius - tube). In the cross section
// that is narrowest for the grid, the node that is farthest from the data can be 0.7 nearer.
TEST(ThinHandles, KeepsHandlesThatAreWide)
{
  const Solid before([](const Vector3& x) { return ring(x, 11.0, 4.0); });
  ASSERT_EQ(eulerNumber(before.Grid, before.Inside), 0);
  Marks inside = before.Inside;
  const ThinHandles kept = removeThinHandles(before.Grid, inside, before.Distances, 1.0, 6.0);
  EXPECT_EQ(kept.NumberOfCutNodes + kept.NumberOfFilledNodes, 0);
  EXPECT_EQ(inside, before.Inside);
}

TEST(ThinHandles, CutsHandlesThatAreThin)
{
  const Solid before([](const Vector3& x) { return ring(x, 11.0, 4.0); });
  Marks inside = before.Inside;
  const ThinHandles cut = removeThinHandles(before.Grid, inside, before.Distances, 1.0, 8.5);
  EXPECT_EQ(eulerNumber(before.Grid, inside), 1);
  EXPECT_EQ(cut.NumberOfFilledNodes, 0);
  // A disk of radius 5, about one node thick.
  EXPECT_NEAR(static_cast<double>(cut.NumberOfCutNodes), 78.0, 30.0);
}

TEST(ThinHandles, FillsOpeningsThatAreNarrow)
{
  const Solid before([](const Vector3& x) { return ring(x, 9.0, 6.0); });
  ASSERT_EQ(eulerNumber(before.Grid, before.Inside), 0);
  Marks inside = before.Inside;
  const ThinHandles filled = removeThinHandles(before.Grid, inside, before.Distances, 1.0, 7.0);
  EXPECT_EQ(eulerNumber(before.Grid, inside), 1);
  EXPECT_EQ(filled.NumberOfCutNodes, 0);
  // A disk of radius 2, about one node thick.
  EXPECT_NEAR(static_cast<double>(filled.NumberOfFilledNodes), 12.0, 6.0);
  Marks open = before.Inside;
  removeThinHandles(before.Grid, open, before.Distances, 1.0, 5.0);
  EXPECT_EQ(open, before.Inside);
}

// A solid joins the ends of a horseshoe that are closer than twice the offset. They are separated
// for any width.
TEST(ThinHandles, SeparatesLimbsThatTouch)
{
  const Solid before(
    [](const Vector3& x)
    {
      const double gap = x[0] > 0.0 ? 0.8 - std::abs(x[1]) : -100.0;
      return std::max(ring(x, 11.0, 4.0), gap);
    });
  ASSERT_EQ(eulerNumber(before.Grid, before.Inside), 0);
  Marks inside = before.Inside;
  removeThinHandles(before.Grid, inside, before.Distances, 1.0, 0.0);
  EXPECT_EQ(eulerNumber(before.Grid, inside), 1);
}

// Of two handles, only the thin one is cut.
TEST(ThinHandles, DistinguishesHandles)
{
  const Solid before(
    [](const Vector3& x)
    {
      return std::min(
        ring(x - Vector3(-8.0, 0.0, 0.0), 8.0, 3.5), ring(x - Vector3(9.0, 0.0, 0.0), 8.0, 1.2));
    });
  ASSERT_EQ(eulerNumber(before.Grid, before.Inside), -1);
  Marks inside = before.Inside;
  removeThinHandles(before.Grid, inside, before.Distances, 1.0, 4.0);
  EXPECT_EQ(eulerNumber(before.Grid, inside), 0);
  const int wide = before.Grid.node(Middle - 16, Middle, Middle);
  EXPECT_EQ(inside[wide], 1);
}

// Samples at a distance of 2 grid spacings on a plane, and samples that are denser than the grid.
TEST(ThinHandles, EstimatesTheSpacingOfSamples)
{
  const Solid plane([](const Vector3& x) { return x[2]; });
  constexpr int side = 2 * Middle + 1;
  EXPECT_NEAR(conformal::spacingOfData(plane.Distances, side * side / 4), 2.0, 0.3);
  EXPECT_EQ(conformal::spacingOfData(plane.Distances, 100 * side * side), 1.0);
  EXPECT_EQ(conformal::spacingOfData(std::vector<float>(9, 5.0F), 0), 1.0);
}
