#include "Mesh/MeshTopology.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>

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
