#include "Cloud/WindingNumbers.h"

#include "Base/Random.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

using conformal::Index;
using conformal::Pi;
using conformal::Points;
using conformal::Vector3;
using conformal::WindingNumbers;

namespace
{
// Area vectors of points that are spread evenly over the unit sphere: their shares of its area.
Points sharesOf(const Points& points)
{
  return 4.0 * Pi / static_cast<double>(points.rows()) * points;
}

Points randomPoints(Index size, unsigned int seed)
{
  conformal::Random random(seed);
  Points points(size, 3);
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] = random.uniform() - 0.5;
  }
  return points;
}

Vector3 kernel(const Vector3& d, double width)
{
  return d / (4.0 * Pi * std::pow(std::max(d.norm(), width), 3));
}

// The definition, term by term.
double numberAt(const Vector3& x, const Points& points, const Points& areas, double width)
{
  double sum = 0.0;
  for (Index j = 0; j < points.rows(); ++j)
  {
    sum += areas.row(j).dot(kernel(Vector3(points.row(j)) - x, width));
  }
  return sum;
}

}

TEST(WindingNumbers, AreOneInsideAndZeroOutside)
{
  const Points points = spheres::spiral(9000);
  const WindingNumbers cloud(points);
  const WindingNumbers::Sources sources = cloud.sources(sharesOf(points));
  Points places(200, 3);
  for (Index i = 0; i < places.rows(); ++i)
  {
    const double radius =
      i < 100 ? 0.009 * static_cast<double>(i) : 0.1 + 0.01 * static_cast<double>(i);
    places.row(i) = radius * Vector3(points.row(37 * i));
  }
  const Eigen::VectorXd numbers = cloud.at(places, sources, 0.02);
  for (Index i = 0; i < places.rows(); ++i)
  {
    EXPECT_NEAR(numbers[i], i < 100 ? 1.0 : 0.0, 0.01) << places.row(i).norm();
  }
  const Eigen::VectorXd atPoints = cloud.atPoints(sharesOf(points), 0.05);
  EXPECT_NEAR(atPoints.minCoeff(), 0.5, 0.03);
  EXPECT_NEAR(atPoints.maxCoeff(), 0.5, 0.03);
}

TEST(WindingNumbers, AreTheSumsThatTheyStandFor)
{
  const Points points = randomPoints(3000, 1), places = 1.5 * randomPoints(200, 2);
  const Points areas = randomPoints(3000, 3) + Points::Constant(3000, 3, 0.5);
  const WindingNumbers cloud(points);
  for (const double width : { 0.01, 0.1 })
  {
    const Eigen::VectorXd numbers = cloud.at(places, cloud.sources(areas), width);
    double scale = 0.0;
    Eigen::VectorXd expected(places.rows());
    for (Index i = 0; i < places.rows(); ++i)
    {
      expected[i] = numberAt(places.row(i), points, areas, width);
      scale = std::max(scale, std::abs(expected[i]));
    }
    EXPECT_LT((numbers - expected).cwiseAbs().maxCoeff(), 0.01 * scale) << width;
    EXPECT_GT(scale, 10.0);
  }
}

// Few points are added up one by one: all is exact but for the rounding of floats.
TEST(WindingNumbers, AreTransposedExactly)
{
  const Points points = randomPoints(20, 1), areas = randomPoints(20, 2);
  const Eigen::VectorXd values = randomPoints(20, 3).col(0);
  const WindingNumbers cloud(points);
  const double width = 0.1;
  const Eigen::VectorXd numbers = cloud.atPoints(areas, width);
  for (Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_NEAR(numbers[i], numberAt(points.row(i), points, areas, width), 1e-4);
  }
  const double left = numbers.dot(values);
  const double right = areas.cwiseProduct(cloud.transposed(values, width)).sum();
  EXPECT_GT(std::abs(left), 0.1);
  EXPECT_NEAR(left, right, 1e-4 * std::abs(left));
}

TEST(WindingNumbers, DescendAsTheyDiffer)
{
  const Points points = randomPoints(20, 1), areas = randomPoints(20, 2);
  const WindingNumbers cloud(points);
  const double width = 0.05, step = 1e-5;
  const Points descent = cloud.descentAtPoints(areas, width);
  for (Index i = 0; i < points.rows(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      Vector3 up = points.row(i), down = up;
      up[c] += step;
      down[c] -= step;
      const double slope =
        (numberAt(up, points, areas, width) - numberAt(down, points, areas, width)) / (2.0 * step);
      EXPECT_NEAR(descent(i, c), -slope, 1e-3 * descent.row(i).norm());
    }
  }
}

TEST(WindingNumbers, AreTheSameOnAnyThreads)
{
  const Points points = randomPoints(2000, 1), areas = randomPoints(2000, 2);
  const Points places = randomPoints(1000, 3);
  const WindingNumbers one(points), many(points, runs::backwards());
  const Eigen::VectorXd values = areas.col(0);
  EXPECT_EQ(one.atPoints(areas, 0.02), many.atPoints(areas, 0.02, runs::backwards()));
  EXPECT_EQ(one.descentAtPoints(areas, 0.02), many.descentAtPoints(areas, 0.02, runs::backwards()));
  EXPECT_EQ(one.transposed(values, 0.02), many.transposed(values, 0.02, runs::backwards()));
  EXPECT_EQ(one.at(places, one.sources(areas), 0.02),
    many.at(places, many.sources(areas), 0.02, runs::backwards()));
}

TEST(WindingNumbers, NeedNoManyPoints)
{
  const WindingNumbers none(Points(0, 3));
  EXPECT_EQ(none.atPoints(Points(0, 3), 0.1).size(), 0);
  EXPECT_EQ(none.at(Points::Zero(3, 3), none.sources(Points(0, 3)), 0.1), Eigen::VectorXd::Zero(3));
  // Equal points are one with all of their areas.
  Points same = Points::Zero(100, 3), areas = Points::Zero(100, 3);
  areas.col(0).setConstant(0.01);
  const WindingNumbers cloud(same);
  Points place(1, 3);
  place << -2.0, 0.0, 0.0;
  EXPECT_NEAR(cloud.at(place, cloud.sources(areas), 0.1)[0], 1.0 / (16.0 * Pi), 1e-6);
  EXPECT_TRUE(cloud.atPoints(areas, 0.1).isZero());
}
