#include "Mesh/Remeshing.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>

using conformal::Index;
using conformal::Points;
using conformal::remesh;
using conformal::RemeshingOptions;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
using Surface = conformal::Mesh;

// An ellipsoid; stretched triangles where its axes differ.
Surface ellipsoid(int frequency, const Vector3& axes)
{
  const auto sphere = conformal::makeGeodesicSphere(frequency);
  return { sphere.Positions * axes.asDiagonal(), sphere.Triangles };
}

Surface cone(int sides)
{
  Surface surface;
  surface.Positions.resize(sides + 1, 3);
  surface.Positions.row(0) << 0.0, 0.0, 2.0;
  surface.Triangles.resize(2 * sides - 2, 3);
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / sides;
    surface.Positions.row(i + 1) << 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0;
    surface.Triangles.row(i) << 0, i + 1, (i + 1) % sides + 1;
    if (i + 2 < sides)
    {
      surface.Triangles.row(sides + i) << 1, i + 3, i + 2;
    }
  }
  return surface;
}

RemeshingOptions exactly(Index count)
{
  RemeshingOptions options;
  options.NumberOfVertices = count;
  options.NumberOfIterations = 6;
  options.MeetNumber = true;
  return options;
}

double minimumAngle(const Surface& surface, Index r)
{
  double smallest = 4.0;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 at = surface.Positions.row(surface.Triangles(r, k));
    const Vector3 u = Vector3(surface.Positions.row(surface.Triangles(r, (k + 1) % 3))) - at;
    const Vector3 v = Vector3(surface.Positions.row(surface.Triangles(r, (k + 2) % 3))) - at;
    smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return smallest * 180.0 / std::acos(-1.0);
}

double meanMinimumAngle(const Surface& surface)
{
  double sum = 0.0;
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    sum += minimumAngle(surface, r);
  }
  return sum / static_cast<double>(surface.Triangles.rows());
}

double farthest(const Points& points, const Surface& from)
{
  const conformal::TriangleTree tree(from.Positions, from.Triangles);
  double square = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    square = std::max(square, tree.closestPoint(points.row(i)).SquareDistance);
  }
  return std::sqrt(square);
}

bool isGenusZero(const Surface& surface)
{
  return conformal::checkGenusZero(surface.Triangles, surface.Positions.rows(), surface.Positions)
    .isGenusZero();
}
}

// From many vertices to few and from few to many.
TEST(Remeshing, MeetsTheNumberWithEvenTriangles)
{
  for (const Index count : { 300, 1500, 6000 })
  {
    Surface surface = ellipsoid(12, { 3.0, 1.0, 0.7 });
    const double before = meanMinimumAngle(surface);
    remesh(surface, exactly(count));
    EXPECT_EQ(surface.Positions.rows(), count);
    EXPECT_EQ(surface.Triangles.rows(), 2 * count - 4);
    EXPECT_TRUE(isGenusZero(surface));
    EXPECT_LT(before, 35.0);
    EXPECT_GT(meanMinimumAngle(surface), 50.0) << count;
    for (Index r = 0; r < surface.Triangles.rows(); ++r)
    {
      ASSERT_GT(minimumAngle(surface, r), 15.0) << count;
    }
  }
}

TEST(Remeshing, StaysOnTheSurface)
{
  const Surface original = ellipsoid(24, { 1.5, 1.0, 0.8 });
  Surface surface = original;
  remesh(surface, exactly(1500));
  // The sagitta of an edge of length 0.11 where the radius is 0.4 is 0.004.
  EXPECT_LT(farthest(surface.Positions, original), 0.01);
  EXPECT_LT(farthest(original.Positions, surface), 0.02);
  EXPECT_NEAR(conformal::signedVolume(surface.Positions, surface.Triangles) /
      conformal::signedVolume(original.Positions, original.Triangles),
    1.0, 0.02);
}

// Edges of these surfaces are up to fifty times as long as those of the result.
TEST(Remeshing, DividesCoarseMeshesWithoutSlivers)
{
  const auto check = [](const Surface& original)
  {
    Surface surface = original;
    remesh(surface, exactly(2562));
    EXPECT_EQ(surface.Positions.rows(), 2562);
    EXPECT_NEAR(conformal::signedVolume(surface.Positions, surface.Triangles) /
        conformal::signedVolume(original.Positions, original.Triangles),
      1.0, 0.02);
    Index slivers = 0;
    for (Index r = 0; r < surface.Triangles.rows(); ++r)
    {
      slivers += minimumAngle(surface, r) < 5.0;
    }
    EXPECT_EQ(slivers, 0);
  };
  check(cone(3));
  check(cone(32));
}

TEST(Remeshing, DoesNotDependOnTheOrderOfBlocks)
{
  Surface one = ellipsoid(16, { 2.0, 1.0, 0.7 }), other = one;
  remesh(one, exactly(1000));
  remesh(other, exactly(1000), runs::backwards());
  EXPECT_EQ(one.Positions, other.Positions);
  EXPECT_EQ(one.Triangles, other.Triangles);
}

TEST(Remeshing, ScalesBitByBitWithPowersOfTwo)
{
  Surface one = ellipsoid(10, { 2.0, 1.0, 0.7 }), other = one;
  other.Positions *= 8.0;
  remesh(one, exactly(500));
  remesh(other, exactly(500));
  EXPECT_EQ(8.0 * one.Positions, other.Positions);
  EXPECT_EQ(one.Triangles, other.Triangles);
}

// Around an ellipsoid as thin as an edge is long, no loop of three edges leads. A map to the sphere
// would distort the part that hangs on it.
TEST(Remeshing, DoesNotPinchThinParts)
{
  constexpr double thickness = 0.03;
  Surface surface = ellipsoid(12, { 1.0, thickness, thickness });
  RemeshingOptions options = exactly(100);
  options.MeetNumber = false;
  remesh(surface, options);
  std::set<std::array<int, 3>> faces;
  std::set<std::pair<int, int>> edges;
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    std::array<int, 3> ids = { surface.Triangles(r, 0), surface.Triangles(r, 1),
      surface.Triangles(r, 2) };
    std::sort(ids.begin(), ids.end());
    faces.insert(ids);
    edges.insert({ { ids[0], ids[1] }, { ids[0], ids[2] }, { ids[1], ids[2] } });
  }
  Index pinches = 0;
  for (const auto& [a, b] : edges)
  {
    for (auto other = edges.lower_bound({ b, 0 }); other != edges.end() && other->first == b;
         ++other)
    {
      const int c = other->second;
      pinches += edges.count({ a, c }) > 0 && faces.count({ a, b, c }) == 0;
    }
  }
  EXPECT_EQ(pinches, 0);
}

// The smallest closed surface, and one that has too few vertices to collapse any.
TEST(Remeshing, KeepsTheTopologyOfTheSmallest)
{
  Surface tetrahedron;
  tetrahedron.Positions.resize(4, 3);
  tetrahedron.Positions << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1;
  tetrahedron.Triangles.resize(4, 3);
  tetrahedron.Triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  for (const Index count : { 4, 100 })
  {
    Surface surface = tetrahedron;
    remesh(surface, exactly(count));
    EXPECT_TRUE(isGenusZero(surface));
    EXPECT_TRUE(surface.Positions.allFinite());
    EXPECT_EQ(surface.Positions.rows(), count);
  }
}

TEST(Remeshing, ReportsProgressAndStops)
{
  Surface surface = ellipsoid(10, { 2.0, 1.0, 0.7 });
  runs::Watch watch;
  remesh(surface, exactly(500), watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_THROW(remesh(surface, exactly(500), runs::stoppingAt(0.3)), conformal::Aborted);
}

TEST(Remeshing, RefusesOptionsOutOfRange)
{
  Surface surface = ellipsoid(4, { 1.0, 1.0, 1.0 });
  EXPECT_THROW(remesh(surface, exactly(3)), std::invalid_argument);
  RemeshingOptions options;
  options.NumberOfIterations = -1;
  EXPECT_THROW(remesh(surface, options), std::invalid_argument);
}
