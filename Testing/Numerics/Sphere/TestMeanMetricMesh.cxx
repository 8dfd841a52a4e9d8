#include "Sphere/MeanMetricMesh.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Register/ConsistentRemesh.h"
#include "Runs.h"
#include "Search/SelfIntersections.h"
#include "Shapes.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
struct Located
{
  conformal::MappedMesh Surface;
  conformal::SphereLocator Locator;

  Located(const Points& positions, const Points& map, const Triangles& triangles)
  {
    this->Surface.Positions = positions;
    this->Surface.SpherePositions = map;
    this->Surface.Triangles = triangles;
    this->Locator = conformal::SphereLocator(map, triangles);
  }
  conformal::LocatedSurface view() const
  {
    return { &this->Surface, &this->Surface.Triangles, &this->Locator };
  }
};

/// Stretch the sphere along an axis, and normalize: a map with different scales in different
/// directions.
Points stretched(const Points& directions, double factor, int axis = 0)
{
  return shapes::over(directions,
    [=](const Vector3& n) -> Vector3
    {
      Vector3 place = n;
      place[axis] *= factor;
      return place.normalized();
    });
}

/// A sphere whose map is stretched.
Located stretchedSphere(double factor, int axis = 0)
{
  const Mesh sphere = conformal::makeGeodesicSphere(24);
  return { sphere.Positions, stretched(sphere.Positions, factor, axis), sphere.Triangles };
}

double smallestAngle(const Points& x, const Triangles& triangles, double quantile)
{
  std::vector<double> angles;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    double smallest = 180.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 p = x.row(triangles(r, k)), u = Vector3(x.row(triangles(r, (k + 1) % 3))) - p,
                    v = Vector3(x.row(triangles(r, (k + 2) % 3))) - p;
      smallest =
        std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / conformal::Pi);
    }
    angles.push_back(smallest);
  }
  std::sort(angles.begin(), angles.end());
  return angles[static_cast<std::size_t>(quantile * static_cast<double>(angles.size()))];
}

/// Points of a surface in the directions of a mesh of the sphere.
Points sampled(const Located& surface, const Points& directions)
{
  return shapes::over(directions,
    [&](const Vector3& n)
    {
      const conformal::SphereLocation at = surface.Locator.locate(n);
      Vector3 sum = Vector3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        sum += at.Barycentric[k] *
          surface.Surface.Positions.row(surface.Surface.Triangles(at.Triangle, k)).transpose();
      }
      return sum;
    });
}
}

// The map stretches the sphere by 4. On the sphere, good triangles are therefore thin.
TEST(MeanMetricMesh, TrianglesAreEquilateralOnTheSurface)
{
  const Located surface = stretchedSphere(4.0);
  const Mesh start = conformal::makeGeodesicSphere(10);
  EXPECT_LT(smallestAngle(sampled(surface, start.Positions), start.Triangles, 0.05), 20.0);
  for (const Index wanted : { 600, 1000, 3000 })
  {
    const Mesh mesh = conformal::remeshByMeanMetric({ surface.view() }, start, wanted);
    EXPECT_NEAR(
      static_cast<double>(mesh.Positions.rows()), static_cast<double>(wanted), 0.02 * wanted);
    EXPECT_TRUE(conformal::checkGenusZero(mesh.Triangles, mesh.Positions.rows(), mesh.Positions)
                  .isGenusZero());
    EXPECT_EQ(conformal::countFlippedTriangles(mesh.Positions, mesh.Triangles), 0);
    EXPECT_LT((mesh.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
    EXPECT_GT(smallestAngle(sampled(surface, mesh.Positions), mesh.Triangles, 0.05), 38.0);
    EXPECT_GT(smallestAngle(sampled(surface, mesh.Positions), mesh.Triangles, 0.0), 20.0);
    EXPECT_LT(smallestAngle(mesh.Positions, mesh.Triangles, 0.05), 25.0);
  }
}

// One map is stretched along x, the other along y. Triangles are equally good on both surfaces.
TEST(MeanMetricMesh, TheMetricIsTheMeanOverSurfacesOfAnySize)
{
  const Mesh start = conformal::makeGeodesicSphere(10);
  Located one = stretchedSphere(2.0), other = stretchedSphere(2.0, 1);
  const Mesh both = conformal::remeshByMeanMetric({ one.view(), other.view() }, start, 1000);
  const Mesh swapped = conformal::remeshByMeanMetric({ other.view(), one.view() }, start, 1000);
  const double a = smallestAngle(sampled(one, both.Positions), both.Triangles, 0.5),
               b = smallestAngle(sampled(other, both.Positions), both.Triangles, 0.5);
  EXPECT_NEAR(a, b, 4.0);
  EXPECT_NEAR(smallestAngle(both.Positions, both.Triangles, 0.5),
    smallestAngle(swapped.Positions, swapped.Triangles, 0.5), 2.0);
  // Sizes do not count.
  one.Surface.Positions *= 1024.0;
  const Mesh scaled = conformal::remeshByMeanMetric({ one.view(), other.view() }, start, 1000);
  EXPECT_EQ(both.Triangles, scaled.Triangles);
  EXPECT_EQ(both.Positions, scaled.Positions);
}

// A thin limb across which the sides of large triangles could cut.
TEST(MeanMetricMesh, AMorphOfASurfaceWithItselfDoesNotCrossItself)
{
  const Mesh sphere = conformal::makeGeodesicSphere(40);
  conformal::MappedMesh mesh;
  mesh.Triangles = sphere.Triangles;
  mesh.SpherePositions = stretched(sphere.Positions, 0.2);
  mesh.Positions = shapes::over(sphere.Positions,
    [](const Vector3& n) -> Vector3
    { return Vector3((0.05 + n[0] * n[0]) * n[0] * 4.0, n[1], 0.1 * n[2]); });
  ASSERT_TRUE(conformal::selfIntersections(mesh.Positions, mesh.Triangles).empty());
  conformal::ConsistentRemeshOptions options;
  options.NumberOfPoints = 1500;
  const conformal::ConsistentMeshes common = conformal::remeshConsistently({ mesh, mesh }, options);
  EXPECT_TRUE(conformal::selfIntersections(common.Positions[0], common.Sphere.Triangles).empty());
  EXPECT_EQ(common.Positions[0], common.Positions[1]);
}

TEST(MeanMetricMesh, ASurfaceWithoutAreaDoesNotHarm)
{
  const Mesh sphere = conformal::makeGeodesicSphere(8);
  const Located good = stretchedSphere(2.0),
                flat = { Points::Zero(sphere.Positions.rows(), 3), sphere.Positions,
                  sphere.Triangles };
  for (const auto& surfaces :
    { std::vector<conformal::LocatedSurface>{ flat.view() }, { flat.view(), good.view() } })
  {
    const Mesh mesh = conformal::remeshByMeanMetric(surfaces, sphere, 700);
    EXPECT_TRUE(mesh.Positions.allFinite());
    EXPECT_EQ(conformal::countFlippedTriangles(mesh.Positions, mesh.Triangles), 0);
  }
}

TEST(MeanMetricMesh, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const Located surface = stretchedSphere(3.0);
  const Mesh start = conformal::makeGeodesicSphere(10);
  const auto with = [&](const conformal::Run& run)
  { return conformal::remeshByMeanMetric({ surface.view() }, start, 1200, run); };
  const Mesh one = with({}), two = with(runs::backwards());
  EXPECT_EQ(one.Positions, two.Positions);
  EXPECT_EQ(one.Triangles, two.Triangles);
  EXPECT_THROW(with(runs::stoppingAt(0.5)), conformal::Aborted);
  runs::Watch watch;
  with(watch.run());
  EXPECT_GT(watch.calls(), 10);
  EXPECT_EQ(watch.last(), 1.0);
  // Each pass of the first round is reported, and each surface whose crossing triangles are found.
  runs::Watch many;
  conformal::remeshByMeanMetric(
    std::vector<conformal::LocatedSurface>(4, surface.view()), start, 1200, many.run());
  const auto countIn = [&](double begin, double end)
  {
    const auto& all = many.fractions();
    return std::count_if(
      all.begin(), all.end(), [=](double done) { return done > begin && done < end; });
  };
  EXPECT_GT(countIn(0.0, 0.08), 2);
  EXPECT_GE(countIn(0.941, 1.0), 4);
}
