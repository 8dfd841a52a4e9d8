#include "Cloud/FarPoints.h"

#include "Ranks.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using conformal::FarPoints;
using conformal::findFarPoints;
using conformal::Index;
using conformal::Points;
using conformal::Vector3;

namespace
{
constexpr Index Size = 3000;

// A sphere's points at random places, and below them others.
Points withOthers(const Points& others)
{
  Points points(Size + others.rows(), 3);
  points << spheres::random(Size), others;
  return points;
}

// All of the first, and none of the last ones.
void expectFar(const Points& points, Index far)
{
  const FarPoints found = findFarPoints(points);
  ASSERT_EQ(found.Count, far);
  EXPECT_EQ(found.Total, points.rows());
  EXPECT_GT(found.Distance, 2.0);
  for (Index i = 0; i < points.rows(); ++i)
  {
    ASSERT_EQ(found.contains(points.row(i)), i >= points.rows() - far) << i;
  }
  EXPECT_EQ(found.MaximumCoordinate, points.topRows(points.rows() - far).cwiseAbs().maxCoeff());
}

void expectNone(const Points& points)
{
  const FarPoints found = findFarPoints(points);
  EXPECT_EQ(found.Count, 0);
  EXPECT_FALSE(found.contains(Vector3::Constant(std::numeric_limits<double>::max())));
}
}

TEST(FarPoints, AreFoundAtAnyDistance)
{
  const Points directions = spheres::spiral(20);
  for (const double distance : { 10.0, 100.0, 300.0, 1e4, 1e6, 1e9, 1e15, 1e100, 1e300 })
  {
    SCOPED_TRACE(distance);
    for (const Index count : { 1, 3, 20 })
    {
      expectFar(withOthers(distance * directions.topRows(count)), count);
    }
    const Points cluster = (spheres::random(30).array() + distance).matrix();
    expectFar(withOthers(cluster), 30);
  }
}

TEST(FarPoints, AtOnePlaceCountAsOne)
{
  for (const Index count : { 50, 1000, 10000 })
  {
    Points moved = withOthers(Points::Zero(count, 3));
    moved.topRows(Size).rowwise() += Eigen::RowVector3d(5e3, 5e4, 0.0);
    expectFar(moved, count);
  }
}

// Each a third farther than the one before it: no gap.
TEST(FarPoints, AreFoundWithoutAGap)
{
  Points others(60, 3);
  for (Index i = 0; i < 60; ++i)
  {
    others.row(i) = std::pow(4.0 / 3.0, static_cast<double>(i)) * spheres::spiral(60).row(i);
  }
  const Points points = withOthers(others);
  const FarPoints found = findFarPoints(points);
  EXPECT_GT(found.Count, 40);
  EXPECT_LT(found.Count, 60);
  EXPECT_LE(found.Distance, 50.0);
}

TEST(FarPoints, AreNotFoundInCleanClouds)
{
  expectNone(spheres::random(Size));
  expectNone(spheres::random(Size, true));
  expectNone(1e-300 * spheres::random(Size));
  expectNone(1e308 * spheres::random(Size));
  expectNone(withOthers(2.0 * spheres::spiral(20)));
  expectNone(Points::Zero(Size, 3));
  expectNone(Points(0, 3));
  Points line = spheres::random(Size);
  line.col(0) *= 100.0;
  expectNone(line);
  line.rightCols(2).setZero();
  expectNone(line);
}

// Most points on a detail of a large sphere, or a tenth of them on a second sphere: objects.
TEST(FarPoints, AreNotFoundOnSurfaces)
{
  Points others = 60.0 * spheres::random(140);
  others.col(0).array() += 60.0;
  expectNone(withOthers(others));
  others = spheres::random(Size / 10);
  others.col(0).array() += 60.0;
  expectNone(withOthers(others));
}

TEST(FarPoints, AreNotFoundAmongFew)
{
  Points points = spheres::spiral(19);
  points.row(7) *= 1000.0;
  expectNone(points);
  Points twenty = spheres::spiral(20);
  twenty.row(19) *= 1000.0;
  expectFar(twenty, 1);
}

TEST(FarPoints, LeavesOutWhatIsSkippedOrNotFinite)
{
  Points points = withOthers(1e4 * spheres::spiral(3));
  points(0, 0) = std::numeric_limits<double>::quiet_NaN();
  const FarPoints found = findFarPoints(points, [](Index i) { return i == 1 || i == Size; });
  EXPECT_EQ(found.Count, 2);
  EXPECT_EQ(found.Total, Size);
}

TEST(FarPoints, PowersOfTwoChangeNothing)
{
  const Points points = withOthers(37.0 * spheres::spiral(5));
  const FarPoints plain = findFarPoints(points);
  ASSERT_EQ(plain.Count, 5);
  for (const int power : { -900, -10, 1, 500, 1015 })
  {
    const double factor = std::ldexp(1.0, power);
    const FarPoints found = findFarPoints(Points(factor * points));
    EXPECT_EQ(found.Count, plain.Count);
    EXPECT_EQ(found.Distance, plain.Distance);
    EXPECT_EQ(found.QuarterOfReach, factor * plain.QuarterOfReach);
    EXPECT_EQ(found.QuarterOfCenter, factor * plain.QuarterOfCenter);
  }
}

TEST(FarPoints, AreTheSameOnAnyThreadsAndRanks)
{
  Points points(60010, 3);
  points << spheres::random(30000), 1e5 * spheres::spiral(10), spheres::random(30000, true);
  const FarPoints whole = findFarPoints(points);
  ASSERT_EQ(whole.Count, 10);
  const auto expectSame = [&](const FarPoints& found)
  {
    EXPECT_EQ(found.Count, whole.Count);
    EXPECT_EQ(found.Total, whole.Total);
    EXPECT_EQ(found.Distance, whole.Distance);
    EXPECT_EQ(found.MaximumCoordinate, whole.MaximumCoordinate);
    EXPECT_EQ(found.QuarterOfReach, whole.QuarterOfReach);
    EXPECT_EQ(found.QuarterOfCenter, whole.QuarterOfCenter);
  };
  expectSame(findFarPoints(points, {}, {}, runs::backwards()));
  for (const int size : { 2, 5 })
  {
    ranks::run(size,
      [&](const conformal::Reduce& reduce)
      {
        // The last process has no points.
        const Index parts = reduce.NumberOfRanks - 1;
        const Index first = points.rows() * std::min<Index>(reduce.Rank, parts) / parts;
        const Index last = points.rows() * std::min<Index>(reduce.Rank + 1, parts) / parts;
        const Points own = points.middleRows(first, last - first);
        expectSame(findFarPoints(own, {}, reduce));
      });
  }
}
