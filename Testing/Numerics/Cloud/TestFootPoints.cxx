#include "Cloud/FootPoints.h"

#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

using conformal::FootPoint;
using conformal::forEachFoot;
using conformal::Index;
using conformal::Points;
using conformal::TrainingSamples;
using conformal::TriangleTree;
using conformal::Vector3;

namespace
{
// Around the origin, in no order at all.
Points cloudAroundOrigin(Index size)
{
  return 2.0 * clouds::inUnitCube(size, 2).array() - 1.0;
}
}

// More patterns than are looked for at a time, and blocks that are not full.
TEST(FootPoints, VisitsEachPatternOnceAndAlone)
{
  const auto sphere = conformal::makeGeodesicSphere(12);
  const TriangleTree tree(sphere.Positions, sphere.Triangles);
  const Points points = cloudAroundOrigin(40001);
  const TrainingSamples samples{ conformal::PointView(points) };
  for (const conformal::Run& run : { conformal::Run(), runs::backwards() })
  {
    std::vector<int> visits(points.rows() / 2, 0);
    std::atomic<int> inside(0);
    double way = 0.0;
    Vector3 last = Vector3::Zero();
    forEachFoot(
      samples, tree, points.rows() / 2, [](Index i) { return 2 * i; },
      [&](Index i, const Vector3& x, const FootPoint& foot)
      {
        EXPECT_EQ(++inside, 1);
        ++visits[i];
        EXPECT_EQ(x, samples[2 * i]);
        const FootPoint expected = tree.closestPoint(x);
        EXPECT_EQ(foot.Triangle, expected.Triangle);
        EXPECT_EQ(foot.Position, expected.Position);
        way += (x - last).norm();
        last = x;
        --inside;
      },
      run);
    EXPECT_EQ(visits, std::vector<int>(points.rows() / 2, 1));
    // Neighbors follow each other: in the cloud's order the mean way is about 0.6.
    EXPECT_LT(way / static_cast<double>(visits.size()), 0.1);
  }
}

TEST(FootPoints, KeepsTheOrderForOtherSurfaces)
{
  const Points points = cloudAroundOrigin(40001);
  const TrainingSamples samples{ conformal::PointView(points) };
  const conformal::ClosestPoint closest = [](Index id, const Vector3& x, int)
  {
    FootPoint foot;
    foot.Triangle = static_cast<int>(id);
    foot.Position = x.normalized();
    return foot;
  };
  Index next = 0;
  forEachFoot(
    samples, closest, points.rows(), {},
    [&](Index id, const Vector3&, const FootPoint& foot)
    {
      EXPECT_EQ(id, next++);
      EXPECT_EQ(foot.Triangle, id);
    },
    runs::backwards());
  EXPECT_EQ(next, points.rows());
}

// The order of the samples changes only the sequence of the visits.
TEST(FootPoints, AreTheSameForSortedSamples)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const TriangleTree tree(sphere.Positions, sphere.Triangles);
  const Points points = cloudAroundOrigin(3000);
  TrainingSamples samples{ conformal::PointView(points) };
  const auto feetOf = [&](Index stride)
  {
    std::vector<int> triangles(3000, -1);
    forEachFoot(
      samples, tree, 3000 / stride, [&](Index i) { return stride * i; },
      [&](Index i, const Vector3& x, const FootPoint& foot)
      {
        EXPECT_EQ(x, samples[stride * i]);
        EXPECT_EQ(triangles[i], -1);
        triangles[i] = foot.Triangle;
      });
    return triangles;
  };
  const std::vector<int> all = feetOf(1), some = feetOf(7), few = feetOf(100);
  const TrainingSamples copy = samples; // shares the order
  EXPECT_EQ(copy.sorted(), nullptr);
  samples.sortAlongCurve();
  ASSERT_NE(copy.sorted(), nullptr);
  EXPECT_EQ(feetOf(1), all);
  EXPECT_EQ(feetOf(7), some);
  EXPECT_EQ(feetOf(100), few);
  EXPECT_EQ(samples.selected([](Index i) { return i > 0; }).sorted(), nullptr);
}
