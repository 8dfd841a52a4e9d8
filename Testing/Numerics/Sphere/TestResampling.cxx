#include "Sphere/Resampling.h"

#include "Mesh/GeodesicSphere.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::Points;
using conformal::resample;

TEST(Resampling, GivesBackTheVerticesValues)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const Points values = sphere.Positions.array().square();
  const Points same = resample(sphere.Positions, values, sphere.Triangles, sphere.Positions);
  EXPECT_LT((same - values).cwiseAbs().maxCoeff(), 1e-14);
}

// p' of Eq. 9 lies on the direction's own ray, in the flat triangle.
TEST(Resampling, InterpolatesAlongTheRay)
{
  const auto coarse = conformal::makeGeodesicSphere(3), fine = conformal::makeGeodesicSphere(11);
  const Points flat =
    resample(coarse.Positions, coarse.Positions, coarse.Triangles, fine.Positions);
  for (Index i = 0; i < flat.rows(); ++i)
  {
    EXPECT_LT((flat.row(i).normalized() - fine.Positions.row(i)).norm(), 1e-13);
    EXPECT_LE(flat.row(i).norm(), 1.0 + 1e-14);
    EXPECT_GT(flat.row(i).norm(), 0.9);
  }
}

// Eq. 9 is the intersection of a ray and a plane, t = -N / D with the center c in the last column
// of N. As printed, with p there and without the sign, it is 1 - t: p' would lie near the center.
TEST(Resampling, Equation9AsPrintedMissesTheTriangle)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  const auto ids = sphere.Triangles.row(5);
  const conformal::Vector3 p = (0.5 * sphere.Positions.row(ids[0]) +
    0.3 * sphere.Positions.row(ids[1]) + 0.2 * sphere.Positions.row(ids[2]))
                                 .normalized();
  const auto determinant = [&](double one, const conformal::Vector3& last)
  {
    Eigen::Matrix4d matrix;
    matrix.row(0) << 1.0, 1.0, 1.0, one;
    for (int k = 0; k < 3; ++k)
    {
      matrix.col(k).tail<3>() = sphere.Positions.row(ids[k]).transpose();
    }
    matrix.col(3).tail<3>() = last;
    return matrix.determinant();
  };
  const double below = determinant(0.0, p); // c is the origin
  const double t = -determinant(1.0, conformal::Vector3::Zero()) / below;
  const Points flat = resample(sphere.Positions, sphere.Positions, sphere.Triangles, p.transpose());
  EXPECT_LT((t * p - conformal::Vector3(flat.row(0))).norm(), 1e-13);
  EXPECT_NEAR(determinant(1.0, p) / below, 1.0 - t, 1e-12);
  EXPECT_LT(determinant(1.0, p) / below, 0.1);
}

TEST(Resampling, TurnsAMirroredMapRound)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  Points mirrored = sphere.Positions;
  mirrored.col(0) *= -1.0;
  const Points same = resample(mirrored, sphere.Positions, sphere.Triangles, sphere.Positions);
  EXPECT_LT((same - sphere.Positions).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Resampling, RefusesMapsThatFoldOrMiss)
{
  const auto sphere = conformal::makeGeodesicSphere(4);
  Points folded = sphere.Positions;
  folded.row(40) = -folded.row(40);
  EXPECT_THROW(
    resample(folded, sphere.Positions, sphere.Triangles, sphere.Positions), std::invalid_argument);
  const conformal::Triangles part = sphere.Triangles.topRows(20);
  EXPECT_THROW(
    resample(sphere.Positions, sphere.Positions, part, sphere.Positions), std::invalid_argument);
}

// The hole covers 0.8 % of the sphere, and is wider than the triangles around it.
TEST(Resampling, RefusesDirectionsInAHole)
{
  const auto sphere = conformal::makeGeodesicSphere(40);
  const conformal::Vector3 middle(0.0, 0.0, 1.0);
  conformal::Triangles part = sphere.Triangles;
  Index count = 0;
  for (Index f = 0; f < sphere.Triangles.rows(); ++f)
  {
    if (sphere.Positions.row(sphere.Triangles(f, 0)).dot(middle) < std::cos(0.17))
    {
      part.row(count++) = sphere.Triangles.row(f);
    }
  }
  part.conservativeResize(count, 3);
  EXPECT_THROW(
    resample(sphere.Positions, sphere.Positions, part, middle.transpose()), std::invalid_argument);
  const Points away = -middle.transpose();
  EXPECT_LT((resample(sphere.Positions, sphere.Positions, part, away) - away).norm(), 1e-2);
}
