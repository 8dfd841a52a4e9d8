#include "Cloud/StrayPoints.h"

#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>

using conformal::Index;
using conformal::isolatedPoints;
using conformal::Points;
using conformal::strayPoints;

TEST(StrayPoints, AreThoseBesideTheSurface)
{
  Points points = conformal::makeGeodesicSphere(30).Positions;
  const std::vector<std::uint8_t> none = strayPoints(points);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
  for (Index i : { 100, 2000, 7000 })
  {
    points.row(i) *= 1.2;
  }
  points.row(5000) *= 0.7;
  const std::vector<std::uint8_t> some = strayPoints(points);
  for (Index i : { 100, 2000, 5000, 7000 })
  {
    EXPECT_EQ(some[i], 1) << i;
  }
  EXPECT_EQ(std::count(some.begin(), some.end(), 1), 4);
}

TEST(StrayPoints, FewPointsAreNoSurface)
{
  const Points points = conformal::makeGeodesicSphere(1).Positions.topRows(8);
  const std::vector<std::uint8_t> marks = strayPoints(points);
  EXPECT_EQ(marks, std::vector<std::uint8_t>(8, 0));
}

TEST(IsolatedPoints, AreThoseFarFromAllOthers)
{
  Points points = conformal::makeGeodesicSphere(30).Positions;
  const std::vector<std::uint8_t> none = isolatedPoints(points);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
  for (Index i : { 100, 2000, 7000 })
  {
    points.row(i) *= 1.5;
  }
  points.row(5000) *= 0.5;
  const std::vector<std::uint8_t> some = isolatedPoints(points);
  for (Index i : { 100, 2000, 5000, 7000 })
  {
    EXPECT_EQ(some[i], 1) << i;
  }
  EXPECT_EQ(std::count(some.begin(), some.end(), 1), 4);
}

// Half a sphere has a sixteenth of the points of the other.
TEST(IsolatedPoints, AreNotThoseOfAThinPart)
{
  const Points dense = conformal::makeGeodesicSphere(40).Positions;
  const Points thin = conformal::makeGeodesicSphere(10).Positions;
  Points points(dense.rows() + thin.rows(), 3);
  Index size = 0;
  for (const Points* part : { &dense, &thin })
  {
    for (Index i = 0; i < part->rows(); ++i)
    {
      if (((*part)(i, 2) > 0.0) == (part == &dense))
      {
        points.row(size++) = part->row(i);
      }
    }
  }
  const std::vector<std::uint8_t> marks = isolatedPoints(points.topRows(size));
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 0);
}

TEST(IsolatedPoints, AreNotAmongFew)
{
  const Points points = conformal::makeGeodesicSphere(1).Positions.topRows(8);
  EXPECT_EQ(isolatedPoints(points), std::vector<std::uint8_t>(8, 0));
}

// More than half of the points are copies: 13 at each of some places of the surface.
TEST(IsolatedPoints, AreNotThoseBesideManyCopies)
{
  const Points single = conformal::makeGeodesicSphere(10).Positions;
  const Points places = conformal::makeGeodesicSphere(4).Positions;
  Points points(single.rows() + 13 * places.rows(), 3);
  points << single, places.replicate(13, 1);
  std::vector<std::uint8_t> marks = isolatedPoints(points);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 0);
  points.row(500) *= 2.0;
  marks = isolatedPoints(points);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 1);
  EXPECT_EQ(marks[500], 1);
  const Points copies = places.replicate(10, 1);
  EXPECT_EQ(isolatedPoints(copies), std::vector<std::uint8_t>(copies.rows(), 0));
}

// A hundredth as dense at once, and thrown at random: most lie flat among their neighbors, which
// points scattered in space do not.
TEST(IsolatedPoints, AreNotThoseOfASparseHalfButThoseOfSpace)
{
  const Points uneven = spheres::random(20000, true);
  const auto sparse = (uneven.col(0).array() < 0.0).count();
  std::vector<std::uint8_t> marks = isolatedPoints(uneven);
  ASSERT_GT(sparse, 150);
  EXPECT_LE(std::count(marks.begin(), marks.end(), 1), sparse / 20);

  Points scattered(20500, 3);
  scattered << spheres::random(20000), 3.0 * clouds::inUnitCube(500, 3).array() - 1.5;
  marks = isolatedPoints(scattered);
  EXPECT_EQ(std::count(marks.begin(), marks.begin() + 20000, 1), 0);
  EXPECT_GT(std::count(marks.begin() + 20000, marks.end(), 1), 400);
}
