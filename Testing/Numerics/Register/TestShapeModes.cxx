#include "Register/ShapeModes.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using conformal::findShapeModes;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::ShapeAlignment;
using conformal::ShapeModes;
using conformal::Vector3;
using shapes::moved;

namespace
{
const Mesh& coarseSphere()
{
  static const Mesh mesh = conformal::makeGeodesicSphere(8);
  return mesh;
}

/// An ellipsoid, longer by one hidden number and bent by another.
Points shape(double longer, double bent)
{
  return shapes::over(coarseSphere().Positions,
    [=](const Vector3& n)
    { return Vector3((2.0 + longer) * n[0], n[1] + bent * n[0] * n[0], 0.7 * n[2]); });
}

double hidden(int s, double step)
{
  return std::sin(step * s + 0.3);
}

/// Ten of them, each moved and turned.
std::vector<Points> ten(double noise = 0.0)
{
  std::vector<Points> shapes;
  for (int s = 0; s < 10; ++s)
  {
    Points one = shape(0.4 * hidden(s, 1.7), 0.2 * hidden(s, 2.9));
    for (Index i = 0; i < one.rows(); ++i)
    {
      one.row(i) *= 1.0 + noise * std::sin(37.0 * i + 11.0 * s);
    }
    shapes.push_back(moved(one, 0.6 * s, { 1.0 * s, -2.0, 0.5 * s }));
  }
  return shapes;
}

double distance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

/// The mean and all of the modes by the scores of a shape.
Points rebuilt(const ShapeModes& modes, Index s)
{
  Points points = modes.Mean;
  for (std::size_t k = 0; k < modes.Modes.size(); ++k)
  {
    points += modes.Scores(s, static_cast<Index>(k)) * modes.Modes[k];
  }
  return points;
}

/// Moved and turned, and scaled if wanted, to where it is closest to another.
Points fitted(const Points& points, const Points& other, bool scales)
{
  const Eigen::Matrix4d fit = Eigen::umeyama(
    Eigen::Matrix3Xd(points.transpose()), Eigen::Matrix3Xd(other.transpose()), scales);
  return (points * fit.topLeftCorner<3, 3>().transpose()).rowwise() +
    fit.topRightCorner<3, 1>().transpose();
}
}

TEST(ShapeModes, TwoHiddenModesAreTwo)
{
  for (const double noise : { 0.0, 0.002 })
  {
    const ShapeModes modes = findShapeModes(coarseSphere().Triangles, ten(noise));
    ASSERT_GE(modes.Explained.size(), 2u);
    EXPECT_GT(modes.Explained[0] + modes.Explained[1], 0.99);
    EXPECT_GT(modes.Explained[1], 0.05);
    EXPECT_GE(modes.Explained[0], modes.Explained[1]);
  }
}

TEST(ShapeModes, MeanAndModesAddUpToTheShapes)
{
  for (const ShapeAlignment alignment :
    { ShapeAlignment::None, ShapeAlignment::Rigid, ShapeAlignment::Similarity })
  {
    std::vector<Points> shapes = ten(0.01);
    const ShapeModes modes = findShapeModes(coarseSphere().Triangles, shapes, { alignment, 10 });
    EXPECT_EQ(modes.Modes.size(), 9u);
    EXPECT_NEAR(std::accumulate(modes.Explained.begin(), modes.Explained.end(), 0.0), 1.0, 1e-9);
    for (Index s = 0; s < 10; ++s)
    {
      const Points one = rebuilt(modes, s);
      const Points there = alignment == ShapeAlignment::None
        ? one
        : fitted(one, shapes[s], alignment == ShapeAlignment::Similarity);
      EXPECT_LT(distance(there, shapes[s]), 1e-9) << s;
      EXPECT_LT(distance(one, modes.Aligned[s]), 1e-9) << s;
      if (alignment == ShapeAlignment::None)
      {
        EXPECT_EQ(distance(modes.Aligned[s], shapes[s]), 0.0) << s;
      }
    }
  }
}

TEST(ShapeModes, ScoresHaveVarianceOneAndModesAreOrthogonal)
{
  const ShapeModes modes =
    findShapeModes(coarseSphere().Triangles, ten(0.01), { ShapeAlignment::Rigid, 4 });
  ASSERT_EQ(modes.Modes.size(), 4u);
  const Eigen::MatrixXd covariance = modes.Scores.transpose() * modes.Scores / 9.0;
  EXPECT_LT((covariance - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(modes.Scores.colwise().sum().cwiseAbs().maxCoeff(), 1e-8);
  for (Index k = 0; k < 4; ++k)
  {
    EXPECT_EQ(modes.Scores.col(k).maxCoeff(), modes.Scores.col(k).cwiseAbs().maxCoeff());
  }
}

TEST(ShapeModes, WhatIsTakenOutIsNoMode)
{
  const Points one = shape(0.0, 0.1);
  std::vector<Points> copies, sizes;
  for (int s = 0; s < 5; ++s)
  {
    copies.push_back(moved(one, 0.5 * s, { 3.0 * s, 1.0, -1.0 }));
    sizes.push_back(moved(one, 0.5 * s, { 3.0 * s, 1.0, -1.0 }, 1.0 + 0.2 * s));
  }
  const ShapeModes equal = findShapeModes(coarseSphere().Triangles, copies);
  EXPECT_TRUE(equal.Modes.empty());
  EXPECT_EQ(equal.Scores.rows(), 5);
  EXPECT_LT(distance(equal.Mean, copies[0]), 1e-10);
  EXPECT_EQ(findShapeModes(coarseSphere().Triangles, sizes).Modes.size(), 1u);
  EXPECT_TRUE(findShapeModes(coarseSphere().Triangles, sizes, { ShapeAlignment::Similarity, 10 })
                .Modes.empty());
  EXPECT_GE(
    findShapeModes(coarseSphere().Triangles, copies, { ShapeAlignment::None, 10 }).Modes.size(),
    2u);
}

// A mesh that is dense somewhere else says the same.
TEST(ShapeModes, VerticesCountByTheirArea)
{
  const Mesh even = conformal::makeGeodesicSphere(24);
  const auto explained = [&](double crowd)
  {
    std::vector<Points> shapes;
    for (int s = 0; s < 6; ++s)
    {
      Points points = even.Positions;
      for (Index i = 0; i < points.rows(); ++i)
      {
        Vector3 n = even.Positions.row(i);
        n[0] += crowd * (1.0 - n[0] * n[0]);
        n.normalize();
        points.row(i) << (2.0 + 0.4 * hidden(s, 1.7)) * n[0],
          n[1] + 0.2 * hidden(s, 2.9) * n[0] * n[0] * n[0], 0.7 * n[2];
      }
      shapes.push_back(points);
    }
    return findShapeModes(even.Triangles, shapes, { ShapeAlignment::None, 2 }).Explained[0];
  };
  EXPECT_NEAR(explained(0.0), explained(0.8), 0.01);
}

TEST(ShapeModes, OneShapeIsItsMean)
{
  const Points one = moved(shape(0.1, 0.2), 1.0, { 1.0, 2.0, 3.0 });
  const ShapeModes modes = findShapeModes(coarseSphere().Triangles, { one });
  EXPECT_LT(distance(modes.Mean, one), 1e-13);
  EXPECT_TRUE(modes.Modes.empty());
  const Points nothing = Points::Zero(one.rows(), 3);
  EXPECT_TRUE(findShapeModes(coarseSphere().Triangles, { nothing, nothing }).Mean.allFinite());
}

TEST(ShapeModes, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const std::vector<Points> shapes = ten(0.01);
  const ShapeModes one = findShapeModes(coarseSphere().Triangles, shapes),
                   two = findShapeModes(coarseSphere().Triangles, shapes, {}, runs::backwards());
  EXPECT_EQ(one.Mean, two.Mean);
  EXPECT_EQ(one.Modes, two.Modes);
  EXPECT_EQ(one.Scores, two.Scores);
  EXPECT_THROW(findShapeModes(coarseSphere().Triangles, shapes, {}, runs::stoppingAt(0.5)),
    conformal::Aborted);
}
