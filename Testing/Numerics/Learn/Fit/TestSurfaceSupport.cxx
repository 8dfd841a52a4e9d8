#include "Learn/Fit/SurfaceSupport.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::Index;

namespace
{
struct Sphere
{
  explicit Sphere(int frequency)
    : Mesh(conformal::makeGeodesicSphere(frequency))
    , Neighbors(conformal::vertexNeighbors(this->Mesh.Triangles, this->Mesh.Positions.rows()))
  {
  }
  double unsupported(const std::vector<double>& masses) const
  {
    return conformal::areaFraction(this->Mesh.Positions, this->Mesh.Triangles,
      conformal::unsupportedVertices(
        this->Mesh.Positions, this->Mesh.Triangles, this->Neighbors, masses));
  }
  double height(Index face) const
  {
    return (this->Mesh.Positions(this->Mesh.Triangles(face, 0), 2) +
             this->Mesh.Positions(this->Mesh.Triangles(face, 1), 2) +
             this->Mesh.Positions(this->Mesh.Triangles(face, 2), 2)) /
      3.0;
  }
  conformal::Mesh Mesh;
  conformal::Adjacency Neighbors;
};
}

// Patterns thrown at random, many or few to a triangle: chance leaves no part of a surface bare.
TEST(SurfaceSupport, RandomPatternsSupportAll)
{
  const Sphere sphere(20);
  for (int patterns : { 500, 4000, 100000 })
  {
    conformal::Random random(1);
    std::vector<double> masses(sphere.Mesh.Triangles.rows(), 0.0);
    for (int i = 0; i < patterns; ++i)
    {
      masses[random.index(sphere.Mesh.Triangles.rows())] += 1.0;
    }
    EXPECT_EQ(sphere.unsupported(masses), 0.0) << patterns;
  }
}

TEST(SurfaceSupport, ABareCapIsFound)
{
  const Sphere sphere(36);
  for (double height : { 0.5, 0.8 })
  {
    std::vector<double> masses(sphere.Mesh.Triangles.rows());
    for (std::size_t r = 0; r < masses.size(); ++r)
    {
      masses[r] = sphere.height(static_cast<Index>(r)) > height ? 0.0 : 2.0;
    }
    const double cap = 0.5 * (1.0 - height); // of the sphere's area, after Archimedes
    EXPECT_GT(sphere.unsupported(masses), 0.6 * cap);
    EXPECT_LT(sphere.unsupported(masses), cap);
  }
}

TEST(SurfaceSupport, NoPatternsOrNoAreaIsNoFinding)
{
  const Sphere sphere(3);
  EXPECT_EQ(sphere.unsupported(std::vector<double>(180, 0.0)), 0.0);
  const conformal::Points point = conformal::Points::Zero(sphere.Mesh.Positions.rows(), 3);
  const std::vector<bool> vertices = conformal::unsupportedVertices(
    point, sphere.Mesh.Triangles, sphere.Neighbors, std::vector<double>(180, 1.0));
  EXPECT_EQ(std::count(vertices.begin(), vertices.end(), true), 0);
  EXPECT_EQ(conformal::areaFraction(point, sphere.Mesh.Triangles, vertices), 0.0);
}

TEST(SurfaceSupport, StretchingMakesTrianglesObtuse)
{
  Sphere sphere(10);
  EXPECT_EQ(conformal::obtuseFraction(sphere.Mesh.Positions, sphere.Mesh.Triangles), 0.0);
  sphere.Mesh.Positions.col(2) *= 4.0;
  EXPECT_GT(conformal::obtuseFraction(sphere.Mesh.Positions, sphere.Mesh.Triangles), 0.3);
}

// A sphere sampled thirty times as thinly on one half has no gap there.
TEST(SurfaceSupport, SparseIsNotBare)
{
  const auto sphere = conformal::makeGeodesicSphere(20), cloud = conformal::makeGeodesicSphere(40);
  std::vector<double> kept;
  for (conformal::Index i = 0; i < cloud.Positions.rows(); ++i)
  {
    const conformal::Vector3 x = cloud.Positions.row(i);
    if (x[2] > 0.0 || i % 30 == 0)
    {
      kept.insert(kept.end(), x.data(), x.data() + 3);
    }
  }
  const conformal::Points patterns = Eigen::Map<const conformal::Points>(
    kept.data(), static_cast<conformal::Index>(kept.size()) / 3, 3);
  const conformal::Index size = sphere.Positions.rows();
  const std::vector<bool> far =
    conformal::farFromPatterns(sphere.Positions, std::vector<bool>(size, true), patterns);
  // At the border a pattern of the dense half may be nearest.
  EXPECT_LT(std::count(far.begin(), far.end(), true), size / 400);

  const std::vector<bool> away =
    conformal::farFromPatterns(2.0 * sphere.Positions, std::vector<bool>(size, true), patterns);
  EXPECT_GT(std::count(away.begin(), away.end(), true), size / 4);
  // Only what was marked is asked.
  const std::vector<bool> none =
    conformal::farFromPatterns(2.0 * sphere.Positions, std::vector<bool>(size, false), patterns);
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

// Points of a ring every 0.1 of its height, on a cylinder: no vertex between rings is far from
// them, though rings are thirty times as far apart as the points on them. Where a ring is missing,
// what lies in its place is.
TEST(SurfaceSupport, RowsSupportWhatLiesBetweenThem)
{
  const auto ringsWithout = [](int missing)
  {
    constexpr int rings = 11, around = 1800;
    conformal::Points points(rings * around, 3);
    Index size = 0;
    for (int ring = 0; ring < rings; ++ring)
    {
      for (int k = 0; k < around && ring != missing; ++k)
      {
        const double turn = 2.0 * conformal::Pi * k / around;
        points.row(size++) << std::cos(turn), std::sin(turn), 0.1 * ring;
      }
    }
    return conformal::Points(points.topRows(size));
  };
  conformal::Points vertices(81, 3);
  for (Index i = 0; i < vertices.rows(); ++i)
  {
    vertices.row(i) << 1.0, 0.0, 0.1 + 0.01 * static_cast<double>(i);
  }
  const std::vector<bool> marked(vertices.rows(), true);
  const std::vector<bool> even = conformal::farFromPatterns(vertices, marked, ringsWithout(-1));
  EXPECT_EQ(std::count(even.begin(), even.end(), true), 0);
  const std::vector<bool> gap = conformal::farFromPatterns(vertices, marked, ringsWithout(5));
  EXPECT_GT(std::count(gap.begin(), gap.end(), true), 0);
  EXPECT_TRUE(gap[40]);
}

// A web between two rods: there is more behind the nearest pattern than the web is wide.
TEST(SurfaceSupport, RodsDoNotSupportAWeb)
{
  conformal::Points points(2 * 100 * 200, 3);
  Index size = 0;
  for (const double side : { -1.0, 1.0 })
  {
    for (int k = 0; k < 100; ++k)
    {
      const double turn = 2.0 * conformal::Pi * k / 100;
      for (int j = 0; j < 200; ++j)
      {
        points.row(size++) << side * 0.5 + 0.1 * std::cos(turn), 0.1 * std::sin(turn), 0.006 * j;
      }
    }
  }
  conformal::Points web(20, 3);
  for (Index i = 0; i < web.rows(); ++i)
  {
    web.row(i) << -0.3 + 0.03 * static_cast<double>(i), 0.0, 0.6;
  }
  const std::vector<bool> far =
    conformal::farFromPatterns(web, std::vector<bool>(web.rows(), true), points);
  EXPECT_EQ(std::count(far.begin(), far.end(), true), web.rows());
}
