#include "Search/SelfIntersections.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

using conformal::Index;
using conformal::Points;
using conformal::selfIntersections;
using conformal::Triangles;

namespace
{
struct TwoTriangles
{
  Points Positions;
  conformal::Triangles Triangles;
};

// One triangle in the plane z = 0, and one through it or beside it.
TwoTriangles crossing(double shift)
{
  TwoTriangles two;
  two.Positions.resize(6, 3);
  two.Positions << 0, 0, 0, 4, 0, 0, 0, 4, 0, //
    1 + shift, 1, -1, 1 + shift, 1, 1, 2 + shift, 1, 1;
  two.Triangles.resize(2, 3);
  two.Triangles << 0, 1, 2, 3, 4, 5;
  return two;
}
}

TEST(SelfIntersections, TrianglesCrossOrDoNot)
{
  const TwoTriangles through = crossing(0.0), beside = crossing(5.0);
  const auto pairs = selfIntersections(through.Positions, through.Triangles);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0][0], 0);
  EXPECT_EQ(pairs[0][1], 1);
  EXPECT_TRUE(selfIntersections(beside.Positions, beside.Triangles).empty());
}

TEST(SelfIntersections, TouchingIsNotCrossing)
{
  TwoTriangles two = crossing(0.0);
  two.Positions.row(3) << 1, 1, 0; // a corner on the other triangle
  EXPECT_TRUE(selfIntersections(two.Positions, two.Triangles).empty());
  two = crossing(0.0);
  two.Triangles.row(1) << 0, 4, 3; // a common vertex
  EXPECT_TRUE(selfIntersections(two.Positions, two.Triangles).empty());
}

// A vertex pushed through the opposite side of a sphere. All six triangles around it cross that
// side.
TEST(SelfIntersections, APinThroughTheOtherSideIsFound)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(12);
  EXPECT_TRUE(selfIntersections(mesh.Positions, mesh.Triangles).empty());
  Index top = 0;
  mesh.Positions.col(2).maxCoeff(&top);
  mesh.Positions.row(top) << 0.01, 0.02, -1.3;
  const auto pairs = selfIntersections(mesh.Positions, mesh.Triangles);
  EXPECT_GE(pairs.size(), 5u);
  EXPECT_EQ(pairs, selfIntersections(mesh.Positions, mesh.Triangles, runs::backwards()));
}

// Of the pairs of all triangles, those that include a chosen one are found.
TEST(SelfIntersections, PairsOfChosenTrianglesAreFound)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(12);
  mesh.Positions.col(2) *= 0.01;
  mesh.Positions.col(2).array() += 0.1 * (7.0 * mesh.Positions.col(0).array()).sin();
  Index right = 0;
  mesh.Positions.col(0).maxCoeff(&right);
  mesh.Positions.row(right) << -1.2, 0.02, 0.0;
  const auto all = selfIntersections(mesh.Positions, mesh.Triangles);
  std::vector<int> chosen;
  for (int f = 0; f < mesh.Triangles.rows(); f += 3)
  {
    chosen.push_back(f);
  }
  std::vector<std::array<int, 2>> expected;
  std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
    [](const std::array<int, 2>& pair) { return pair[0] % 3 == 0 || pair[1] % 3 == 0; });
  ASSERT_GT(expected.size(), 5u);
  ASSERT_LT(expected.size(), all.size());
  EXPECT_EQ(selfIntersections(mesh.Positions, mesh.Triangles, chosen), expected);
  EXPECT_TRUE(selfIntersections(mesh.Positions, mesh.Triangles, std::vector<int>()).empty());
}

TEST(SelfIntersections, NoTrianglesNoPairs)
{
  EXPECT_TRUE(selfIntersections(Points(0, 3), Triangles(0, 3)).empty());
}
