#include "Mesh/MeshTopology.h"

#include "Mesh/GeodesicSphere.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

using conformal::Adjacency;
using conformal::Index;
using conformal::Triangles;

TEST(MeshTopology, LatticeNeighborsAreSymmetricFiveOrSix)
{
  const auto sphere = conformal::makeGeodesicSphere(5);
  const Adjacency rings = conformal::vertexNeighbors(sphere.Triangles, sphere.Positions.rows());
  int fives = 0;
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    fives += rings.size(v) == 5;
    EXPECT_TRUE(rings.size(v) == 5 || rings.size(v) == 6);
    EXPECT_TRUE(std::is_sorted(rings.begin(v), rings.end(v)));
    for (const int* w = rings.begin(v); w != rings.end(v); ++w)
    {
      EXPECT_TRUE(std::binary_search(rings.begin(*w), rings.end(*w), static_cast<int>(v)));
    }
  }
  EXPECT_EQ(fives, 12);
}

TEST(MeshTopology, TrianglesAroundAVertexHoldIt)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  const Adjacency around = conformal::vertexTriangles(sphere.Triangles, sphere.Positions.rows());
  EXPECT_EQ(static_cast<Index>(around.Ids.size()), sphere.Triangles.size());
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    for (const int* r = around.begin(v); r != around.end(v); ++r)
    {
      EXPECT_TRUE((sphere.Triangles.row(*r).array() == static_cast<int>(v)).any());
    }
  }
}

TEST(MeshTopology, NeighborsAcrossEdgesAreMutual)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  const Triangles across = conformal::triangleNeighbors(sphere.Triangles, sphere.Positions.rows());
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_GE(across(r, k), 0);
      EXPECT_EQ((across.row(across(r, k)).array() == static_cast<int>(r)).count(), 1);
    }
  }
}

TEST(MeshTopology, BoundaryEdgesHaveNoNeighbor)
{
  Triangles one(1, 3);
  one << 0, 1, 2;
  EXPECT_EQ(conformal::triangleNeighbors(one, 3), Triangles::Constant(1, 3, -1));
}

TEST(MeshTopology, IndependentSetsHoldEachVertexOnceAndNoNeighbors)
{
  const auto sphere = conformal::makeGeodesicSphere(7);
  const auto size = static_cast<int>(sphere.Positions.rows());
  const auto neighbors = conformal::vertexNeighbors(sphere.Triangles, size);
  std::vector<int> vertices; // the first one is left out
  for (int v = 1; v < size; ++v)
  {
    vertices.push_back(v);
  }
  const auto sets = conformal::independentSets(vertices, size,
    [&](int v, const std::function<void(int)>& visit)
    { std::for_each(neighbors.begin(v), neighbors.end(v), visit); });
  std::vector<int> setOf(size, -1);
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    for (const int v : sets[i])
    {
      EXPECT_EQ(setOf[v], -1);
      setOf[v] = static_cast<int>(i);
    }
  }
  EXPECT_EQ(setOf[0], -1);
  for (const int v : vertices)
  {
    EXPECT_GE(setOf[v], 0);
    EXPECT_EQ(std::count_if(neighbors.begin(v), neighbors.end(v),
                [&](int other) { return setOf[other] == setOf[v]; }),
      0);
  }
  EXPECT_LE(sets.size(), 7U); // a vertex has at most six neighbors
}

TEST(MeshTopology, AClosedMeshHasNone)
{
  EXPECT_TRUE(conformal::borderLoops(conformal::makeGeodesicSphere(3)).empty());
}

TEST(MeshTopology, TheLongestIsFirstAndHasTheMeshOnItsLeft)
{
  const conformal::Mesh cap = sheets::cap(5, 1.0);
  conformal::Mesh pierced = cap;
  pierced.Triangles = cap.Triangles.bottomRows(cap.Triangles.rows() - 6); // without the center
  const auto loops = conformal::borderLoops(pierced);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 30u);
  EXPECT_EQ(loops[1].size(), 6u);
  const auto turns = [&](const conformal::BorderLoop& loop)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const conformal::Vector3 a = cap.Positions.row(loop[i]),
                               b = cap.Positions.row(loop[(i + 1) % loop.size()]);
      sum += a.cross(b)[2];
    }
    return sum;
  };
  EXPECT_GT(turns(loops[0]), 0.0);
  EXPECT_LT(turns(loops[1]), 0.0);
}
