#include "Search/PointTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

using conformal::Index;
using conformal::Neighbor;
using conformal::Points;
using conformal::PointTree;
using conformal::PointView;
using conformal::Vector3;

namespace
{
Points randomPoints(Index size, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Points points(size, 3);
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] = uniform(random);
  }
  return points;
}

// Coordinates of few values: many points coincide, and many are equally far.
Points gridPoints(Index size, unsigned int seed)
{
  return (2.0 * randomPoints(size, seed)).array().round().matrix();
}

std::vector<Neighbor> nearestByBruteForce(const Points& points, const Vector3& x, Index k)
{
  std::vector<Neighbor> all;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 difference = x - Vector3(points.row(i));
    all.push_back({ static_cast<int>(i), difference.dot(difference) });
  }
  std::sort(all.begin(), all.end());
  all.resize(std::min<std::size_t>(k, all.size()));
  return all;
}

void expectSame(const std::vector<Neighbor>& found, const std::vector<Neighbor>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_EQ(found[i].Id, expected[i].Id);
    ASSERT_EQ(found[i].SquareDistance, expected[i].SquareDistance);
  }
}
}

TEST(PointTree, FindsWhatBruteForceFinds)
{
  std::vector<Neighbor> found;
  for (const Index size : { 1, 8, 9, 17, 1000 })
  {
    const Points points = randomPoints(size, 1), queries = 1.5 * randomPoints(200, 2);
    const PointTree tree{ PointView(points) };
    for (Index i = 0; i < queries.rows(); ++i)
    {
      const Vector3 x = queries.row(i);
      for (const int k : { 1, 2, 10, 100 })
      {
        tree.nearest(x, k, found);
        expectSame(found, nearestByBruteForce(points, x, k));
      }
      expectSame({ tree.nearest(x) }, nearestByBruteForce(points, x, 1));
    }
  }
}

TEST(PointTree, GivesTheLowestIdsOfPointsEquallyNear)
{
  const Points points = gridPoints(2000, 3), queries = gridPoints(100, 4);
  const PointTree tree{ PointView(points) };
  std::vector<Neighbor> found;
  for (Index i = 0; i < queries.rows(); ++i)
  {
    for (const double shift : { 0.0, 0.5 })
    {
      const Vector3 x = queries.row(i).array() + shift;
      tree.nearest(x, 20, found);
      expectSame(found, nearestByBruteForce(points, x, 20));
      expectSame({ tree.nearest(x) }, nearestByBruteForce(points, x, 1));
    }
  }
}

TEST(PointTree, ReadsFloats)
{
  const Points points = randomPoints(500, 5);
  const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> floats = points.cast<float>();
  const PointTree fromFloats(PointView(floats.data(), floats.rows()));
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Neighbor same = fromFloats.nearest(floats.row(i).cast<double>());
    EXPECT_EQ(same.Id, i);
    EXPECT_EQ(same.SquareDistance, 0.0);
  }
}

TEST(PointTree, KnowsCloudsThatAreTooSmall)
{
  std::vector<Neighbor> found(3);
  const PointTree empty{ PointView(Points(0, 3)) };
  EXPECT_EQ(empty.nearest(Vector3::Zero()).Id, -1);
  empty.nearest(Vector3::Zero(), 5, found);
  EXPECT_TRUE(found.empty());
  const PointTree three{ PointView(Points(Points::Identity(3, 3))) };
  three.nearest(Vector3(0.0, 0.0, 2.0), 5, found);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].Id, 2);
  EXPECT_EQ(found[1].Id, 0);
  EXPECT_EQ(found[2].Id, 1);
  three.nearest(Vector3::Zero(), 0, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointTree, RefusesPointsThatAreNotFinite)
{
  Points points = randomPoints(5, 6);
  points(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PointTree{ PointView(points) }, std::invalid_argument);
}
