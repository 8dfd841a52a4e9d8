#include "Repair/HandleLoops.h"

#include "Gluing.h"
#include "HandleMeshes.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <set>

using conformal::findHandleLoops;
using conformal::GluedSurface;
using conformal::HandleLoop;
using conformal::Index;
using conformal::numberOfHandles;
using gluing::glue;

namespace
{
std::vector<double> lengthsOf(const GluedSurface& surface)
{
  std::vector<double> lengths;
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    const int other = std::min(side, surface.Across[side]);
    lengths.push_back(
      (surface.Positions[surface.to(other)] - surface.Positions[surface.from(other)]).norm());
  }
  return lengths;
}

// Each is a loop that meets no other and passes no vertex twice.
void expectLoops(const GluedSurface& surface, const std::vector<HandleLoop>& loops)
{
  const std::vector<double> lengths = lengthsOf(surface);
  std::set<int> vertices;
  for (const HandleLoop& loop : loops)
  {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.Sides.size(); ++i)
    {
      const int side = loop.Sides[i];
      EXPECT_EQ(surface.to(side), surface.from(loop.Sides[(i + 1) % loop.Sides.size()]));
      EXPECT_TRUE(vertices.insert(surface.from(side)).second);
      length += lengths[side];
    }
    EXPECT_NEAR(loop.Length, length, 1e-12 * length);
  }
}

// Whether a surface cut along all of them is in one piece, by walking over it.
bool staysInOnePiece(const GluedSurface& surface, const std::vector<HandleLoop>& loops)
{
  std::vector<char> isCut(surface.numberOfSides(), 0), isSeen(surface.numberOfTriangles(), 0);
  for (const HandleLoop& loop : loops)
  {
    for (const int side : loop.Sides)
    {
      isCut[side] = isCut[surface.Across[side]] = 1;
    }
  }
  std::vector<int> stack = { 0 };
  isSeen[0] = 1;
  int count = 0;
  while (!stack.empty())
  {
    const int r = stack.back();
    stack.pop_back();
    ++count;
    for (int side = 3 * r; side < 3 * r + 3; ++side)
    {
      const int other = surface.Across[side] / 3;
      if (!isCut[side] && !isSeen[other])
      {
        isSeen[other] = 1;
        stack.push_back(other);
      }
    }
  }
  return count == surface.numberOfTriangles();
}
}

TEST(HandleLoops, AreNoneOnASphere)
{
  const GluedSurface surface = glue(conformal::makeGeodesicSphere(6));
  EXPECT_EQ(numberOfHandles(surface), 0);
  EXPECT_TRUE(findHandleLoops(surface, lengthsOf(surface)).empty());
}

// Around the tube 12 edges of a regular polygon are shortest; around the hole the inner equator is,
// where the tube is fat.
TEST(HandleLoops, AreTheShortestOfATorus)
{
  const double pi = conformal::Pi;
  GluedSurface surface = glue(handles::torus(12, 60));
  EXPECT_EQ(numberOfHandles(surface), 1);
  std::vector<HandleLoop> loops = findHandleLoops(surface, lengthsOf(surface));
  ASSERT_EQ(loops.size(), 1u);
  expectLoops(surface, loops);
  EXPECT_NEAR(loops[0].Length, 12 * 2.0 * 0.4 * std::sin(pi / 12), 1e-12);

  surface = glue(handles::torus(60, 16, 0.8));
  loops = findHandleLoops(surface, lengthsOf(surface));
  ASSERT_EQ(loops.size(), 1u);
  expectLoops(surface, loops);
  EXPECT_NEAR(loops[0].Length, 16 * 2.0 * 0.2 * std::sin(pi / 16), 1e-12);
}

TEST(HandleLoops, FindEveryHandleOfASphere)
{
  for (const int count : { 1, 5, 20 })
  {
    SCOPED_TRACE(count);
    const GluedSurface surface = glue(handles::sphereWithHandles(count));
    EXPECT_EQ(numberOfHandles(surface), count);
    const std::vector<HandleLoop> loops = findHandleLoops(surface, lengthsOf(surface));
    ASSERT_EQ(static_cast<int>(loops.size()), count);
    expectLoops(surface, loops);
    EXPECT_TRUE(staysInOnePiece(surface, loops));
    for (const HandleLoop& loop : loops)
    {
      EXPECT_LE(loop.Sides.size(), 12u); // around the tubes
    }
  }
}

TEST(HandleLoops, AvoidWhatIsLong)
{
  const GluedSurface surface = glue(handles::torus(12, 60));
  std::vector<double> lengths = lengthsOf(surface);
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    // All around the tube but at 30 of the 60 places.
    const bool isFree = surface.from(side) / 12 == 30 && surface.to(side) / 12 == 30;
    lengths[side] *= isFree ? 1.0 : 10.0;
  }
  const std::vector<HandleLoop> loops = findHandleLoops(surface, lengths);
  ASSERT_EQ(loops.size(), 1u);
  for (const int side : loops[0].Sides)
  {
    EXPECT_EQ(surface.from(side) / 12, 30);
  }
}

TEST(HandleLoops, HaveTheSameBitsOnAnyThreads)
{
  const GluedSurface surface = glue(handles::sphereWithHandles(10));
  const std::vector<double> lengths = lengthsOf(surface);
  const auto one = findHandleLoops(surface, lengths);
  const auto two = findHandleLoops(surface, lengths, runs::backwards());
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].Sides, two[i].Sides);
    EXPECT_EQ(one[i].Length, two[i].Length);
  }
  EXPECT_THROW(findHandleLoops(surface, lengths, runs::stoppingAt(0.5)), conformal::Aborted);
  runs::Watch watch; // each candidate for a loop is reported
  findHandleLoops(surface, lengths, watch.run());
  EXPECT_GE(watch.calls(), 2 * numberOfHandles(surface) + 4);
}
