#include "Repair/GluedSurface.h"

#include "Gluing.h"
#include "HandleMeshes.h"
#include "Mesh/GenusZeroCheck.h"

#include <gtest/gtest.h>

#include <stdexcept>

using conformal::capFor;
using conformal::checkGenusZero;
using conformal::closeLoop;
using conformal::GluedSurface;
using conformal::GluingReport;
using conformal::Index;
using conformal::openLoops;
using conformal::Points;
using conformal::Triangles;
using gluing::glue;

namespace
{
Triangles trianglesOf(const GluedSurface& surface)
{
  return Eigen::Map<const Triangles>(surface.Corners.data(), surface.numberOfTriangles(), 3);
}

// Sides are glued both ways, and run the same edge in opposite directions.
void expectGlued(const GluedSurface& surface)
{
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    const int across = surface.Across[side];
    if (across >= 0)
    {
      ASSERT_EQ(surface.Across[across], side);
      ASSERT_EQ(surface.from(side), surface.to(across));
      ASSERT_EQ(surface.to(side), surface.from(across));
    }
  }
  const auto report = checkGenusZero(trianglesOf(surface), surface.numberOfVertices());
  EXPECT_TRUE(report.NonManifoldVertices.empty());
  EXPECT_TRUE(report.InconsistentEdges.empty());
  EXPECT_EQ(surface.Positions.size(), surface.PointIds.size());
  EXPECT_EQ(surface.Parents.size(), surface.PointIds.size());
}

void fillAll(GluedSurface& surface)
{
  for (const auto& loop : openLoops(surface))
  {
    closeLoop(surface, loop, capFor(surface, loop));
  }
}

conformal::Mesh joined(const conformal::Mesh& a, const conformal::Mesh& b)
{
  conformal::Mesh both;
  both.Positions.resize(a.Positions.rows() + b.Positions.rows(), 3);
  both.Positions << a.Positions, b.Positions;
  both.Triangles.resize(a.Triangles.rows() + b.Triangles.rows(), 3);
  both.Triangles << a.Triangles, (b.Triangles.array() + static_cast<int>(a.Positions.rows()));
  return both;
}

// The eight corners of a box and its twelve triangles.
conformal::Mesh box(double x0, double y0, double x1, double y1)
{
  conformal::Mesh mesh;
  mesh.Positions.resize(8, 3);
  for (int i = 0; i < 8; ++i)
  {
    mesh.Positions.row(i) << (i & 1 ? x1 : x0), (i & 2 ? y1 : y0), (i & 4 ? 1.0 : 0.0);
  }
  mesh.Triangles.resize(12, 3);
  mesh.Triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
    2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

// Points of equal coordinates become one.
conformal::Mesh welded(conformal::Mesh mesh)
{
  for (Index i = 0; i < mesh.Triangles.size(); ++i)
  {
    int& id = mesh.Triangles.data()[i];
    for (int j = 0; j < id; ++j)
    {
      if (mesh.Positions.row(j) == mesh.Positions.row(id))
      {
        id = j;
      }
    }
  }
  return mesh;
}
}

TEST(GluedSurface, KeepsAClosedMeshAsItIs)
{
  const conformal::Mesh mesh = conformal::makeGeodesicSphere(5);
  GluingReport report;
  const GluedSurface surface = glue(mesh, &report);
  expectGlued(surface);
  EXPECT_TRUE(trianglesOf(surface) == mesh.Triangles);
  EXPECT_TRUE(openLoops(surface).empty());
  EXPECT_EQ(report.NumberOfTurnedTriangles + report.NumberOfPartsRemoved +
      report.NumberOfDuplicates + report.NumberOfNonManifoldEdges,
    0);
}

TEST(GluedSurface, TurnsTrianglesToAgreeWithTheMost)
{
  const conformal::Mesh mesh = conformal::makeGeodesicSphere(5);
  conformal::Mesh mixed = mesh;
  Index turned = 0;
  for (Index r = 0; r < mixed.Triangles.rows(); r += 3, ++turned)
  {
    std::swap(mixed.Triangles(r, 1), mixed.Triangles(r, 2));
  }
  GluingReport report;
  const GluedSurface surface = glue(mixed, &report);
  expectGlued(surface);
  EXPECT_TRUE(trianglesOf(surface) == mesh.Triangles);
  EXPECT_EQ(report.NumberOfTurnedTriangles, turned);
  EXPECT_TRUE(openLoops(surface).empty());
}

TEST(GluedSurface, KeepsThePartOfTheLargestArea)
{
  conformal::Mesh small = conformal::makeGeodesicSphere(10);
  small.Positions *= 0.1;
  GluingReport report;
  const GluedSurface surface = glue(joined(small, conformal::makeGeodesicSphere(3)), &report);
  EXPECT_EQ(surface.numberOfTriangles(), 180);
  EXPECT_EQ(surface.TriangleIds.front(), 2000);
  EXPECT_EQ(surface.PointIds.front(), 1002);
  EXPECT_EQ(report.NumberOfPartsRemoved, 1);
  EXPECT_EQ(report.NumberOfTrianglesRemoved, 2000);
  EXPECT_NEAR(report.AreaRemoved, 0.01, 0.001);
}

TEST(GluedSurface, DropsDuplicatesAndRepeatedPoints)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(3);
  const Index size = mesh.Triangles.rows();
  mesh.Triangles.conservativeResize(size + 3, 3);
  mesh.Triangles.row(size) << mesh.Triangles(7, 1), mesh.Triangles(7, 0), mesh.Triangles(7, 2);
  mesh.Triangles.row(size + 1) = mesh.Triangles.row(7);
  mesh.Triangles.row(size + 2) << 5, 5, 6;
  GluingReport report;
  const GluedSurface surface = glue(mesh, &report);
  EXPECT_EQ(surface.numberOfTriangles(), size);
  EXPECT_EQ(report.NumberOfDuplicates, 2);
  EXPECT_EQ(report.NumberOfRepeatedPoints, 1);
  EXPECT_EQ(report.NumberOfNonManifoldEdges, 0);
}

// A wall through a sphere: the halves go on more straight, so they stay together.
TEST(GluedSurface, LeavesWallsInsideOut)
{
  const int f = 6;
  conformal::Mesh mesh = conformal::makeGeodesicSphere(f);
  // The vertices one edge around the pole and the pole's opposite, joined by a wall to the middle.
  std::vector<int> ring;
  for (int v = 0; v < mesh.Positions.rows(); ++v)
  {
    if (v != 0 && (mesh.Positions.row(v) - mesh.Positions.row(0)).norm() < 1.5 * 1.1 / f)
    {
      ring.push_back(v);
    }
  }
  ASSERT_EQ(ring.size(), 5u);
  std::sort(ring.begin(), ring.end(),
    [&](int a, int b)
    {
      return std::atan2(mesh.Positions(a, 1), mesh.Positions(a, 0)) <
        std::atan2(mesh.Positions(b, 1), mesh.Positions(b, 0));
    });
  const Index size = mesh.Triangles.rows();
  mesh.Positions.conservativeResize(mesh.Positions.rows() + 1, 3);
  mesh.Positions.bottomRows(1).setZero();
  mesh.Triangles.conservativeResize(size + 5, 3);
  for (int i = 0; i < 5; ++i)
  {
    mesh.Triangles.row(size + i) << ring[i], ring[(i + 1) % 5],
      static_cast<int>(mesh.Positions.rows()) - 1;
  }
  GluingReport report;
  const GluedSurface surface = glue(mesh, &report);
  expectGlued(surface);
  EXPECT_EQ(report.NumberOfNonManifoldEdges, 5);
  EXPECT_EQ(report.NumberOfPartsRemoved, 1);
  EXPECT_EQ(surface.numberOfTriangles(), size);
  EXPECT_TRUE(openLoops(surface).empty());
}

// They have an edge in common, or a point, but no inside.
TEST(GluedSurface, SeparatesBoxesThatTouch)
{
  const conformal::Mesh atEdge = welded(joined(box(0, 0, 3, 3), box(3, 3, 4, 4)));
  GluingReport report;
  GluedSurface surface = glue(atEdge, &report);
  fillAll(surface);
  expectGlued(surface);
  EXPECT_EQ(report.NumberOfNonManifoldEdges, 1);
  EXPECT_EQ(surface.numberOfTriangles(), 12);
  EXPECT_TRUE(checkGenusZero(trianglesOf(surface), surface.numberOfVertices()).isGenusZero());

  conformal::Mesh raised = box(3, 3, 4, 4);
  raised.Positions.col(2).array() += 1.0;
  surface = glue(welded(joined(box(0, 0, 3, 3), raised)), &report);
  expectGlued(surface);
  EXPECT_EQ(surface.numberOfTriangles(), 12);
}

TEST(GluedSurface, FillsEveryHoleByADisk)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(8);
  // Holes that share points: every third triangle is missing.
  Triangles left(mesh.Triangles.rows(), 3);
  Index size = 0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    if (r % 3 > 0)
    {
      left.row(size++) = mesh.Triangles.row(r);
    }
  }
  mesh.Triangles = left.topRows(size);
  GluedSurface surface = glue(mesh);
  fillAll(surface);
  while (splitDoubleEdges(surface) > 0)
  {
  }
  expectGlued(surface);
  EXPECT_TRUE(openLoops(surface).empty());
  const auto report = checkGenusZero(trianglesOf(surface), surface.numberOfVertices());
  EXPECT_TRUE(report.closed() && report.manifold());
  EXPECT_EQ(report.NumberOfComponents, 1);
}

TEST(GluedSurface, ClosesASingleTriangle)
{
  conformal::Mesh mesh;
  mesh.Positions = Points::Identity(3, 3);
  mesh.Triangles.resize(1, 3);
  mesh.Triangles << 0, 1, 2;
  GluedSurface surface = glue(mesh);
  fillAll(surface);
  EXPECT_EQ(surface.numberOfTriangles(), 4);
  EXPECT_TRUE(checkGenusZero(trianglesOf(surface), 4).isGenusZero());
  EXPECT_EQ(surface.Parents[3], (std::vector<int>{ 0, 2, 1 }));
}

// A torus cut around its tube is a tube, with caps a sphere.
TEST(GluedSurface, IsCutAlongALoop)
{
  const int around = 12, along = 20;
  const conformal::Mesh mesh = handles::torus(around, along);
  GluedSurface surface = glue(mesh);
  std::vector<int> loop; // the edges (0, j) to (0, j + 1)
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    if (surface.from(side) < around && surface.to(side) == (surface.from(side) + 1) % around)
    {
      loop.push_back(side);
    }
  }
  ASSERT_EQ(static_cast<int>(loop.size()), around);
  std::sort(
    loop.begin(), loop.end(), [&](int a, int b) { return surface.from(a) < surface.from(b); });
  const std::vector<int> right = cutAlong(surface, loop);
  expectGlued(surface);
  EXPECT_EQ(surface.numberOfVertices(), around * (along + 1));
  EXPECT_EQ(openLoops(surface).size(), 2u);
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    EXPECT_EQ(surface.Across[right[i]], -1);
    EXPECT_EQ(surface.to(right[i]), surface.from(right[(i + 1) % right.size()]));
  }
  fillAll(surface);
  expectGlued(surface);
  EXPECT_TRUE(checkGenusZero(trianglesOf(surface), surface.numberOfVertices()).isGenusZero());
  EXPECT_TRUE(trianglesOf(surface).rows() > mesh.Triangles.rows());
}

// Two sheets glued to each other along one edge only, twice: by its points alone that edge has four
// triangles.
TEST(GluedSurface, SplitsDoubleEdges)
{
  // Two tetrahedra that share the edge of 0 and 1; glued crosswise there they are one surface.
  GluedSurface surface;
  conformal::Mesh mesh;
  mesh.Positions.resize(6, 3);
  mesh.Positions << 0, 0, 0, 0, 0, 1, 1, 0, 0, 0.9, 0.1, 0, -1, 0, 0, -0.9, -0.1, 0;
  mesh.Triangles.resize(8, 3);
  mesh.Triangles << 0, 1, 3, 1, 0, 2, 0, 3, 2, 1, 2, 3, 0, 1, 5, 1, 0, 4, 0, 5, 4, 1, 4, 5;
  surface = glue(mesh);
  Index split = 0;
  for (Index now = 1; now > 0; split += now)
  {
    now = splitDoubleEdges(surface);
  }
  fillAll(surface);
  expectGlued(surface);
  const auto report = checkGenusZero(trianglesOf(surface), surface.numberOfVertices());
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.closed());
  EXPECT_GT(split, 0);
}

TEST(GluedSurface, RefusesWhatIsNotOrientable)
{
  conformal::Mesh band;
  const int size = 12;
  band.Positions.resize(2 * size, 3);
  band.Triangles.resize(2 * size, 3);
  for (int i = 0; i < size; ++i)
  {
    const double t = 2.0 * conformal::Pi * i / size;
    for (const int k : { 0, 1 })
    {
      const double w = (k - 0.5) * 0.4, r = 1.0 + w * std::cos(0.5 * t);
      band.Positions.row(2 * i + k) << r * std::cos(t), r * std::sin(t), w * std::sin(0.5 * t);
    }
    const bool last = i + 1 == size;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    band.Triangles.row(2 * i) << a, b, d;
    band.Triangles.row(2 * i + 1) << a, d, c;
  }
  EXPECT_THROW(glue(band), std::invalid_argument);
  // Beside something larger it does not matter.
  EXPECT_EQ(glue(joined(band, conformal::makeGeodesicSphere(3))).numberOfTriangles(), 180);
}
