#include "Mesh/GenusZeroCheck.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::checkGenusZero;
using conformal::Edge;
using conformal::GenusZeroReport;
using conformal::Index;
using conformal::Points;
using conformal::Triangles;

namespace
{
Triangles withoutRow(const Triangles& triangles, Index row)
{
  Triangles rest(triangles.rows() - 1, 3);
  rest << triangles.topRows(row), triangles.bottomRows(triangles.rows() - row - 1);
  return rest;
}

Triangles stacked(const Triangles& a, const Triangles& b)
{
  Triangles both(a.rows() + b.rows(), 3);
  both << a, b;
  return both;
}

// m by n squares with opposite sides glued, one pair of sides reversed for a Klein bottle.
Triangles torus(int m, int n, bool klein = false)
{
  Triangles triangles(2 * m * n, 3);
  const auto id = [&](int i, int j)
  {
    if (i == m)
    {
      i = 0;
      j = klein ? n - j : j;
    }
    return i * n + (j + n) % n;
  };
  Index r = 0;
  for (int i = 0; i < m; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      triangles.row(r++) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
      triangles.row(r++) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
    }
  }
  return triangles;
}

Triangles tetrahedron(int a, int b, int c, int d)
{
  Triangles triangles(4, 3);
  triangles << a, b, c, a, c, d, a, d, b, b, d, c;
  return triangles;
}
}

TEST(GenusZeroCheck, AcceptsASphere)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  const GenusZeroReport report =
    checkGenusZero(sphere.Triangles, sphere.Positions.rows(), sphere.Positions);
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_TRUE(report.Orientable);
  EXPECT_FALSE(report.InsideOut);
  EXPECT_EQ(report.EulerNumber, 2);
  EXPECT_EQ(report.NumberOfEdges, 30 * 16);
  EXPECT_TRUE(report.DegenerateTriangles.empty());
  EXPECT_EQ(conformal::describe(report).size(), 1u);
}

TEST(GenusZeroCheck, FindsHoles)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  // Two triangles far apart: two loops of three edges, found in the direction of their triangle.
  const Triangles open = withoutRow(withoutRow(sphere.Triangles, 200), 0);
  const GenusZeroReport report = checkGenusZero(open, sphere.Positions.rows());
  EXPECT_FALSE(report.isGenusZero());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.BoundaryEdges.size(), 6u);
  EXPECT_EQ(report.NumberOfBoundaryLoops, 2);
  EXPECT_EQ(report.EulerNumber, 0);
  const Edge across = { sphere.Triangles(0, 1), sphere.Triangles(0, 0) };
  EXPECT_EQ(std::count(report.BoundaryEdges.begin(), report.BoundaryEdges.end(), across), 1);
  EXPECT_NE(conformal::describe(report)[1].find("6 boundary edges in 2 loops"), std::string::npos);
}

TEST(GenusZeroCheck, KnowsGenusByEulerNumber)
{
  const GenusZeroReport report = checkGenusZero(torus(5, 6), 30);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.Orientable);
  EXPECT_EQ(report.EulerNumber, 0);
  EXPECT_FALSE(report.isGenusZero());
}

TEST(GenusZeroCheck, KnowsAKleinBottle)
{
  const GenusZeroReport report = checkGenusZero(torus(5, 6, true), 30);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.EulerNumber, 0);
  EXPECT_FALSE(report.Orientable);
}

TEST(GenusZeroCheck, CountsComponents)
{
  const GenusZeroReport report =
    checkGenusZero(stacked(tetrahedron(0, 1, 2, 3), tetrahedron(4, 5, 6, 7)), 8);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.NumberOfComponents, 2);
  EXPECT_EQ(report.EulerNumber, 4);
  EXPECT_FALSE(report.isGenusZero());
}

// Two tetrahedra that share a vertex, or an edge.
TEST(GenusZeroCheck, FindsWhatIsNotManifold)
{
  GenusZeroReport report =
    checkGenusZero(stacked(tetrahedron(0, 1, 2, 3), tetrahedron(3, 4, 5, 6)), 7);
  EXPECT_EQ(report.NonManifoldVertices, std::vector<int>{ 3 });
  EXPECT_TRUE(report.NonManifoldEdges.empty());
  EXPECT_EQ(report.NumberOfComponents, 1);

  report = checkGenusZero(stacked(tetrahedron(0, 1, 2, 3), tetrahedron(2, 3, 4, 5)), 6);
  EXPECT_EQ(report.NonManifoldEdges, (std::vector<Edge>{ { 2, 3 } }));
  EXPECT_FALSE(report.manifold());
}

TEST(GenusZeroCheck, OrientsByMajority)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  Triangles mixed = sphere.Triangles;
  for (Index r : { 0, 7, 8, 100 })
  {
    std::swap(mixed(r, 1), mixed(r, 2));
  }
  const GenusZeroReport report = checkGenusZero(mixed, sphere.Positions.rows());
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_TRUE(report.Orientable);
  EXPECT_FALSE(report.InconsistentEdges.empty());
  EXPECT_EQ(conformal::orientConsistently(mixed), 4);
  EXPECT_TRUE(checkGenusZero(mixed, sphere.Positions.rows()).InconsistentEdges.empty());
  EXPECT_GT(conformal::signedVolume(sphere.Positions, mixed), 0.0);
  EXPECT_EQ(conformal::orientConsistently(mixed), 0);
}

TEST(GenusZeroCheck, TellsInsideOut)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  Triangles inward = sphere.Triangles;
  inward.col(1).swap(inward.col(2));
  const GenusZeroReport report = checkGenusZero(inward, sphere.Positions.rows(), sphere.Positions);
  EXPECT_TRUE(report.InsideOut);
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_EQ(conformal::describe(report).size(), 2u);
}

TEST(GenusZeroCheck, VolumeAndAreaAreThoseOfTheTetrahedronWhereverItLies)
{
  Points corners(4, 3);
  corners << 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_DOUBLE_EQ(conformal::signedVolume(corners, tetrahedron(0, 1, 2, 3)), 1.0 / 6.0);
  const double area = 1.5 + std::sqrt(0.75);
  EXPECT_DOUBLE_EQ(conformal::surfaceArea(corners, tetrahedron(0, 1, 2, 3)), area);
  corners.rowwise() += Eigen::RowVector3d(1 << 20, 0, 1 << 22);
  EXPECT_DOUBLE_EQ(conformal::signedVolume(corners, tetrahedron(0, 1, 2, 3)), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(conformal::surfaceArea(corners, tetrahedron(0, 1, 2, 3)), area);
}

// Rows 0 and 1 repeat a vertex, row 2 is flat although rounding gives it a tiny cross product.
TEST(GenusZeroCheck, FindsDegenerateTrianglesAndPoints)
{
  const double third = 1.0 / 3.0;
  Points points(6, 3);
  points << 0, 0, 0, third, 7 * third, 0.1, 3 * third, 21 * third, 3 * 0.1, 1, 0, 0, 9, 9, 9,
    std::numeric_limits<double>::quiet_NaN(), 0, 0;
  Triangles triangles(4, 3);
  triangles << 0, 0, 1, 2, 1, 2, 0, 1, 2, 0, 1, 3;
  const GenusZeroReport report = checkGenusZero(triangles, 6, points);
  EXPECT_EQ(report.DegenerateTriangles, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(report.NumberOfTriangles, 2);
  EXPECT_EQ(report.IsolatedPoints, (std::vector<int>{ 4, 5 }));
  EXPECT_EQ(report.NonFinitePoints, std::vector<int>{ 5 });
  EXPECT_EQ(conformal::dropRepeatedVertices(triangles), 2);
  EXPECT_EQ(triangles.rows(), 2);
}

// Areas that would under- or overflow as products are areas all the same.
TEST(GenusZeroCheck, AreasDoNotDependOnTheUnit)
{
  Triangles one(1, 3);
  one << 0, 1, 2;
  for (double unit : { 1e-200, 1.0, 1e200 })
  {
    Points points(3, 3);
    points << 0, 0, 0, unit, 0, 0, 0, unit, 0;
    EXPECT_TRUE(checkGenusZero(one, 3, points).DegenerateTriangles.empty()) << unit;
  }
}

TEST(GenusZeroCheck, WeldsASoup)
{
  const auto sphere = conformal::makeGeodesicSphere(5);
  const Index size = sphere.Triangles.size();
  Triangles soup(sphere.Triangles.rows(), 3);
  Points corners(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    soup.data()[i] = static_cast<int>(i);
    corners.row(i) = sphere.Positions.row(sphere.Triangles.data()[i]);
  }
  const GenusZeroReport before = checkGenusZero(soup, size, corners);
  EXPECT_EQ(before.NumberOfComponents, sphere.Triangles.rows());
  EXPECT_EQ(conformal::mergeCoincidentBoundaryPoints(soup, corners, before),
    size - sphere.Positions.rows());
  const std::vector<int> kept = conformal::dropIsolatedPoints(soup, size);
  EXPECT_EQ(static_cast<Index>(kept.size()), sphere.Positions.rows());
  EXPECT_TRUE(checkGenusZero(soup, sphere.Positions.rows()).isGenusZero());
  for (Index i = 0; i < size; ++i)
  {
    ASSERT_EQ(corners.row(kept[soup.data()[i]]), corners.row(i));
  }
}

// Two closed surfaces that touch in one place are not glued there.
TEST(GenusZeroCheck, WeldsOnlyOpenEdges)
{
  Triangles both = stacked(tetrahedron(0, 1, 2, 3), tetrahedron(4, 5, 6, 7));
  Points points = Points::Random(8, 3);
  points.row(4) = points.row(0);
  const GenusZeroReport report = checkGenusZero(both, 8, points);
  EXPECT_EQ(conformal::mergeCoincidentBoundaryPoints(both, points, report), 0);
}

TEST(GenusZeroCheck, NothingIsNoSphere)
{
  const GenusZeroReport report = checkGenusZero(Triangles(0, 3), 0);
  EXPECT_FALSE(report.isGenusZero());
  EXPECT_EQ(report.EulerNumber, 0);
  EXPECT_EQ(conformal::describe(report), std::vector<std::string>{ "no triangles" });
}

TEST(GenusZeroCheck, RefusesIdsOutOfRange)
{
  EXPECT_THROW(checkGenusZero(tetrahedron(0, 1, 2, 3), 3), std::invalid_argument);
  EXPECT_THROW(checkGenusZero(tetrahedron(0, 1, 2, -1), 3), std::invalid_argument);
}

TEST(GenusZeroCheck, StopsWhenAsked)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  EXPECT_THROW(checkGenusZero(sphere.Triangles, sphere.Positions.rows(), {}, runs::stoppingAt(0.5)),
    conformal::Aborted);
}
