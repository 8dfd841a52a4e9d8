#include "Mesh/VertexRings.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/QuadricCollapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using conformal::Index;
using conformal::QuadricCollapse;
using conformal::Ring;
using conformal::Triangles;
using conformal::VertexRings;

namespace
{
std::vector<std::array<int, 3>> sorted(const Triangles& triangles)
{
  std::vector<std::array<int, 3>> rows;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    rows.push_back({ triangles(r, 0), triangles(r, 1), triangles(r, 2) });
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}
}

TEST(VertexRings, HoldTheMesh)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  const VertexRings rings(sphere.Triangles, sphere.Positions.rows());
  const Triangles same = rings.triangles();
  ASSERT_EQ(same.rows(), sphere.Triangles.rows());
  conformal::requireGenusZero(same, sphere.Positions.rows());
  for (Index i = 0; i < rings.size(); ++i)
  {
    EXPECT_EQ(rings[static_cast<int>(i)].size(), i < 12 ? 5u : 6u);
  }
}

// Down to a tetrahedron and back, closed at every step.
TEST(VertexRings, SplitsUndoCollapses)
{
  const auto sphere = conformal::makeGeodesicSphere(5);
  const Index size = sphere.Positions.rows();
  VertexRings rings(sphere.Triangles, size);
  const Triangles before = rings.triangles();
  QuadricCollapse collapse(sphere.Positions, rings);
  std::vector<QuadricCollapse::Collapse> done;
  for (Index left = size; left > 4; --left)
  {
    done.push_back(collapse.next());
    ASSERT_TRUE(rings[done.back().Vertex].empty());
    ASSERT_EQ(rings.triangles().rows(), 2 * (left - 1) - 4);
  }
  conformal::requireGenusZero(rings.triangles(), size);
  for (auto step = done.rbegin(); step != done.rend(); ++step)
  {
    rings.split(step->Vertex, step->Neighbors);
  }
  EXPECT_EQ(sorted(rings.triangles()), sorted(before));
}

TEST(VertexRings, ACollapseThatWouldPinchIsRefused)
{
  // A tetrahedron on each side of a triangle: 0, 1, 2 with 3 above and 4 below. Edges of the
  // triangle have two common neighbors beside those of their own triangles' third corners.
  Triangles triangles(6, 3);
  triangles << 0, 1, 3, 1, 2, 3, 2, 0, 3, 1, 0, 4, 2, 1, 4, 0, 2, 4;
  const VertexRings rings(triangles, 5);
  EXPECT_FALSE(rings.canCollapse(0, 1)); // 2 is a neighbor of both, across no triangle of 0 1
  EXPECT_TRUE(rings.canCollapse(3, 0));
}

TEST(VertexRings, SplitsEdges)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  const int size = static_cast<int>(sphere.Positions.rows());
  VertexRings rings(sphere.Triangles, size);
  const int a = 20, b = rings[a][2];
  const auto across = rings.across(a, b);
  rings.resize(size + 1);
  rings.splitEdge(a, b, size);
  conformal::requireGenusZero(rings.triangles(), size + 1);
  EXPECT_EQ(rings.triangles().rows(), sphere.Triangles.rows() + 2);
  EXPECT_EQ(rings[size], (Ring{ a, across.Right, b, across.Left }));
  EXPECT_EQ(std::count(rings[a].begin(), rings[a].end(), b), 0);
  rings.collapse(size, a);
  const Triangles same = rings.triangles();
  EXPECT_EQ(sorted(same), sorted(VertexRings(sphere.Triangles, size).triangles()));
}

TEST(VertexRings, FlipsEdges)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  VertexRings rings(sphere.Triangles, sphere.Positions.rows());
  const Triangles before = rings.triangles();
  const int a = 20, b = rings[a][2];
  const auto across = rings.across(a, b);
  ASSERT_TRUE(rings.canFlip(a, b));
  rings.flip(a, b);
  conformal::requireGenusZero(rings.triangles(), sphere.Positions.rows());
  EXPECT_EQ(std::count(rings[a].begin(), rings[a].end(), b), 0);
  EXPECT_EQ(std::count(rings[across.Left].begin(), rings[across.Left].end(), across.Right), 1);
  ASSERT_TRUE(rings.canFlip(across.Left, across.Right));
  rings.flip(across.Left, across.Right);
  EXPECT_EQ(sorted(rings.triangles()), sorted(before));
}

// The other diagonal of any edge of a tetrahedron is an edge already.
TEST(VertexRings, AFlipThatWouldDoubleAnEdgeIsRefused)
{
  Triangles tetrahedron(4, 3);
  tetrahedron << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  EXPECT_FALSE(VertexRings(tetrahedron, 4).canFlip(0, 1));
}

// A collapse or flip in an octahedron leaves a loop around the rest that bounds no triangle.
TEST(VertexRings, ChangesThatPinchTheSurfaceAreFound)
{
  Triangles octahedron(8, 3);
  octahedron << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5;
  const VertexRings small(octahedron, 6);
  ASSERT_TRUE(small.canCollapse(0, 1));
  EXPECT_TRUE(small.collapsePinches(0, 1));
  ASSERT_TRUE(small.canFlip(0, 1));
  EXPECT_TRUE(small.flipPinches(0, 1));

  const auto sphere = conformal::makeGeodesicSphere(6);
  const VertexRings rings(sphere.Triangles, sphere.Positions.rows());
  for (int v = 0; v < static_cast<int>(sphere.Positions.rows()); ++v)
  {
    EXPECT_FALSE(rings.collapsePinches(v, rings[v][0]));
    EXPECT_FALSE(rings.flipPinches(v, rings[v][0]));
  }
}
