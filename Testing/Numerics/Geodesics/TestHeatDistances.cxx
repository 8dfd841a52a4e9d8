#include "Geodesics/HeatDistances.h"

#include "Geodesics/ExactDistances.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::addFarthestVertices;
using conformal::HeatDistances;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;

namespace
{
double angleBetween(const Mesh& sphere, Index a, Index b)
{
  return 2.0 *
    std::asin(std::min(1.0, 0.5 * (sphere.Positions.row(a) - sphere.Positions.row(b)).norm()));
}

// Mean relative error of distances on the unit sphere.
double meanError(const Mesh& sphere, const std::vector<int>& sources)
{
  const Eigen::VectorXd distances = HeatDistances(sphere).from(sources);
  double sum = 0.0;
  Index count = 0;
  for (Index v = 0; v < distances.size(); ++v)
  {
    double exact = 4.0;
    for (const int source : sources)
    {
      exact = std::min(exact, angleBetween(sphere, v, source));
    }
    if (exact > 0.0)
    {
      sum += std::abs(distances[v] - exact) / exact;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

// Two spheres side by side, and a vertex without triangles.
Mesh twoSpheres()
{
  const Mesh sphere = makeGeodesicSphere(6);
  const Index size = sphere.Positions.rows();
  Mesh both;
  both.Positions.resize(2 * size + 1, 3);
  both.Positions << sphere.Positions, sphere.Positions, Eigen::RowVector3d(9.0, 9.0, 9.0);
  both.Positions.middleRows(size, size).col(0).array() += 5.0;
  both.Triangles.resize(2 * sphere.Triangles.rows(), 3);
  both.Triangles << sphere.Triangles, sphere.Triangles.array() + static_cast<int>(size);
  return both;
}
}

TEST(HeatDistances, AreThoseOfASphere)
{
  EXPECT_LT(meanError(makeGeodesicSphere(24), { 7 }), 0.008);
  EXPECT_LT(meanError(makeGeodesicSphere(48), { 7 }), 0.006);
  EXPECT_LT(meanError(makeGeodesicSphere(24), { 7, 900, 2500 }), 0.02);
}

TEST(HeatDistances, DoNotDependOnShapesOfTriangles)
{
  // A cylinder that was unrolled: a strip of 4 by 2 with thin triangles.
  const int columns = 41, rows = 201;
  Mesh strip;
  strip.Positions.resize(columns * rows, 3);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      strip.Positions.row(j * columns + i) << 0.1 * i, 0.01 * j, 0.0;
    }
  }
  strip.Triangles.resize(2 * (columns - 1) * (rows - 1), 3);
  Index t = 0;
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const int a = j * columns + i;
      strip.Triangles.row(t++) << a, a + 1, a + columns;
      strip.Triangles.row(t++) << a + 1, a + columns + 1, a + columns;
    }
  }
  const int source = 100 * columns + 20;
  const Eigen::VectorXd distances = HeatDistances(strip).from({ source });
  double sum = 0.0;
  for (Index v = 0; v < distances.size(); ++v)
  {
    const double exact = (strip.Positions.row(v) - strip.Positions.row(source)).norm();
    sum += v == source ? 0.0 : std::abs(distances[v] - exact) / exact;
  }
  EXPECT_LT(sum / static_cast<double>(distances.size()), 0.03);
}

// A cone of long triangles, and one obtuse triangle.
TEST(HeatDistances, AreThoseOfCoarseMeshesWithLongTriangles)
{
  const int count = 20;
  Mesh cone;
  cone.Positions.resize(count + 1, 3);
  cone.Positions.row(count) << 0.0, 0.0, 3.0;
  cone.Triangles.resize(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * conformal::Pi * i / count;
    cone.Positions.row(i) << std::cos(angle), std::sin(angle), 0.0;
    cone.Triangles.row(i) << i, (i + 1) % count, count;
  }
  const Eigen::VectorXd distances = HeatDistances(cone).from({ count });
  for (int i = 0; i < count; ++i)
  {
    EXPECT_NEAR(distances[i], std::sqrt(10.0), 0.05);
  }
  Mesh needle;
  needle.Positions.resize(3, 3);
  needle.Positions << 0, 0, 0, 1, 0, 0, 0.3, 0.03, 0;
  needle.Triangles.resize(1, 3);
  needle.Triangles << 0, 1, 2;
  const conformal::NearestSources nearest = HeatDistances(needle).nearestSources({ 1 });
  EXPECT_EQ(nearest.Positions, std::vector<int>({ 0, 0, 0 }));
  EXPECT_NEAR(nearest.Distances[0], 1.0, 0.01);
  EXPECT_NEAR(nearest.Distances[2], 0.7, 0.01);
}

// A narrow plate whose rows are shifted, so that angles opposite its borders are obtuse.
TEST(HeatDistances, ReachAllPointsOfAShiftedPlate)
{
  const int n = 160;
  Mesh plate;
  plate.Positions.resize((n + 1) * (n + 1), 3);
  plate.Triangles.resize(2 * n * n, 3);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const int a = j * (n + 1) + i, cell = j * n + i;
      plate.Positions.row(a) << (i + 0.5 * (j % 2)) / n, 0.05 * j / n, 0.0;
      if (i < n && j < n)
      {
        plate.Triangles.row(2 * cell) << a, a + 1, a + n + 2;
        plate.Triangles.row(2 * cell + 1) << a, a + n + 2, a + n + 1;
      }
    }
  }
  const conformal::NearestSources nearest = HeatDistances(plate).nearestSources({ 0 }),
                                  exact = conformal::ExactDistances(plate, { 0 }).nearestSources();
  EXPECT_EQ(*std::min_element(nearest.Positions.begin(), nearest.Positions.end()), 0);
  EXPECT_LT((nearest.Distances - exact.Distances).cwiseAbs().maxCoeff(), 0.02);
}

TEST(HeatDistances, DoNotReachOtherParts)
{
  const Mesh both = twoSpheres();
  const Index size = (both.Positions.rows() - 1) / 2;
  const HeatDistances surface(both);
  const Eigen::VectorXd distances = surface.from({ 3 });
  EXPECT_EQ(distances[3], 0.0);
  EXPECT_GT(distances.head(size).maxCoeff(), 2.9);
  EXPECT_GE(distances.head(size).minCoeff(), 0.0);
  EXPECT_EQ(distances.tail(size + 1).maxCoeff(), -1.0);
  const std::vector<int> nearest = surface.nearestSources({ 3 }).Positions;
  EXPECT_EQ(std::count(nearest.begin(), nearest.end(), 0), size);
  // A second source on the other sphere has its own distances.
  const Eigen::VectorXd of2 = surface.from({ 3, static_cast<int>(size) + 3 });
  EXPECT_NEAR((of2.head(size) - distances.head(size)).cwiseAbs().maxCoeff(), 0.0, 1e-9);
  EXPECT_NEAR((of2.segment(size, size) - of2.head(size)).cwiseAbs().maxCoeff(), 0.0, 1e-6);
}

TEST(HeatDistances, DoNotDependOnSizesOfOtherParts)
{
  Mesh both = twoSpheres();
  const Index size = (both.Positions.rows() - 1) / 2;
  const Eigen::VectorXd equal = HeatDistances(both).from({ static_cast<int>(size) });
  constexpr double factor = 1e-6;
  both.Positions.middleRows(size, size) *= factor;
  const Eigen::VectorXd small = HeatDistances(both).from({ static_cast<int>(size) }) / factor;
  EXPECT_NEAR((small - equal).segment(size, size).cwiseAbs().maxCoeff(), 0.0, 1e-3);
}

TEST(HeatDistances, FindFarthestVerticesOnAllParts)
{
  const Mesh both = twoSpheres();
  const int size = static_cast<int>(both.Positions.rows() - 1) / 2;
  std::vector<int> sources = { 0 };
  addFarthestVertices(HeatDistances(both), 9, sources);
  ASSERT_EQ(sources.size(), 10U);
  EXPECT_EQ(std::count_if(sources.begin(), sources.end(), [&](int v) { return v < size; }), 5);
  EXPECT_EQ(std::count(sources.begin(), sources.end(), 2 * size), 0); // it has no triangles
}

TEST(HeatDistances, DivideASphereAmongSources)
{
  const Mesh sphere = makeGeodesicSphere(24);
  const HeatDistances surface(sphere);
  const std::vector<int> sources = { 5, 1200, 3000 };
  const std::vector<int> nearest = surface.nearestSources(sources).Positions;
  Index wrong = 0;
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    double least = 9.0;
    int exact = -1;
    for (int s = 0; s < 3; ++s)
    {
      const double angle = angleBetween(sphere, v, sources[s]);
      if (angle < least)
      {
        least = angle;
        exact = s;
      }
    }
    // Near the border between two sources, a vertex can belong to either one.
    const double own = angleBetween(sphere, v, sources[nearest[v]]);
    wrong += nearest[v] != exact && own > least + 0.2;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(HeatDistances, FindFarthestVertices)
{
  const Mesh sphere = makeGeodesicSphere(16);
  const HeatDistances surface(sphere);
  std::vector<int> sources = { 0 };
  addFarthestVertices(surface, 5, sources);
  ASSERT_EQ(sources.size(), 6U);
  EXPECT_GT(angleBetween(sphere, 0, sources[1]), 3.0); // the antipode
  double closest = 9.0;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      closest = std::min(closest, angleBetween(sphere, sources[i], sources[j]));
    }
  }
  EXPECT_GT(closest, 1.2); // 1.57 for an octahedron
}

TEST(HeatDistances, AreEqualForAnyThreadsAndCanBeAborted)
{
  const Mesh sphere = makeGeodesicSphere(50);
  const Eigen::VectorXd once = HeatDistances(sphere).from({ 11 }),
                        again = HeatDistances(sphere, runs::backwards()).from({ 11 });
  EXPECT_EQ(once, again);
  EXPECT_THROW(HeatDistances(sphere, runs::stoppingAt(0.5)), conformal::Aborted);
}
