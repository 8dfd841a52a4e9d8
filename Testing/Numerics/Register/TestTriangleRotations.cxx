#include "Register/TriangleRotations.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using conformal::Index;
using conformal::Points;
using conformal::rotationOf;
using conformal::triangleRotation;
using conformal::triangleRotations;
using conformal::Vector3;

namespace
{
Eigen::Matrix3d cornersOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Eigen::Matrix3d corners;
  corners << a, b, c;
  return corners;
}

/// A bar along z whose upper half is twisted about it.
Points twisted(const Points& sphere, double angle)
{
  return shapes::over(sphere,
    [=](const Vector3& n) -> Vector3
    {
      const double turn = angle * (0.5 + 0.5 * std::sin(0.5 * conformal::Pi * n[2]));
      return Eigen::AngleAxisd(turn, Vector3::UnitZ()) *
        Vector3(0.5 * n[0], 0.3 * n[1], 4.0 * n[2]);
    });
}
}

TEST(TriangleRotations, VectorsAreThoseOfEigen)
{
  EXPECT_EQ(rotationOf(Vector3::Zero()), Eigen::Matrix3d::Identity());
  const Vector3 axis = Vector3(1.0, -2.0, 0.5).normalized();
  EXPECT_LT(
    (rotationOf(1.7 * axis) - Eigen::AngleAxisd(1.7, axis).toRotationMatrix()).norm(), 1e-15);
}

// The factor of the gradient with the normals, by a singular value decomposition.
TEST(TriangleRotations, AreThePolarFactorOfTheGradient)
{
  for (int i = 0; i < 200; ++i)
  {
    const auto vector = [&](int k)
    { return Vector3(std::sin(9.1 * i + k), std::cos(5.3 * i + 2.0 * k), std::sin(i + 3.0 * k)); };
    const Eigen::Matrix3d from = cornersOf(vector(1), vector(2), vector(3)),
                          to = cornersOf(vector(4), vector(5), vector(6));
    const auto framed = [](const Eigen::Matrix3d& corners)
    {
      const Vector3 u = corners.col(1) - corners.col(0), v = corners.col(2) - corners.col(0);
      return cornersOf(u, v, u.cross(v).normalized());
    };
    const Eigen::Matrix3d gradient = framed(to) * framed(from).inverse();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d expected = svd.matrixU() * svd.matrixV().transpose();
    EXPECT_LT((triangleRotation(from, to, Eigen::Matrix3d::Zero()) - expected).norm(), 1e-9) << i;
  }
}

TEST(TriangleRotations, TrianglesWithoutAreaTakeTheOther)
{
  const Eigen::Matrix3d good = cornersOf({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 });
  const Eigen::Matrix3d other = rotationOf({ 0.1, 0.2, 0.3 });
  for (const Eigen::Matrix3d& flat : { cornersOf({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }),
         cornersOf({ 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 }) })
  {
    EXPECT_EQ(triangleRotation(flat, good, other), other);
    EXPECT_EQ(triangleRotation(good, flat, other), other);
  }
}

TEST(TriangleRotations, AreWhatIsLeftOfTheTurnOfAll)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const auto neighbors = conformal::triangleNeighbors(sphere.Triangles, sphere.Positions.rows());
  const Vector3 turn(0.4, 1.1, -0.7);
  const Points to = 2.0 * (sphere.Positions * rotationOf(turn).transpose());
  for (const Vector3& vector :
    triangleRotations(sphere.Triangles, neighbors, sphere.Positions, to, turn))
  {
    EXPECT_LT(vector.norm(), 1e-14);
  }
  for (const Vector3& vector :
    triangleRotations(sphere.Triangles, neighbors, sphere.Positions, to, Vector3::Zero()))
  {
    EXPECT_LT((vector - turn).norm(), 1e-13);
  }
}

// A shortest vector is at most half a turn long; the end of the bar is turned by 300 degrees.
TEST(TriangleRotations, FollowNeighborsBeyondHalfATurn)
{
  const auto sphere = conformal::makeGeodesicSphere(24);
  const auto neighbors = conformal::triangleNeighbors(sphere.Triangles, sphere.Positions.rows());
  const double whole = 5.0 / 3.0 * conformal::Pi;
  const auto vectors = triangleRotations(sphere.Triangles, neighbors,
    twisted(sphere.Positions, 0.0), twisted(sphere.Positions, whole), Vector3::Zero());
  double lowest = whole, highest = 0.0;
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    const Vector3 middle = (sphere.Positions.row(sphere.Triangles(r, 0)) +
      sphere.Positions.row(sphere.Triangles(r, 1)) + sphere.Positions.row(sphere.Triangles(r, 2)))
                             .normalized();
    if (std::abs(middle[2]) > 0.95) // where the twist is even
    {
      lowest = std::min(lowest, vectors[r][2]);
      highest = std::max(highest, vectors[r][2]);
    }
  }
  EXPECT_NEAR(lowest, 0.0, 0.4);
  EXPECT_NEAR(highest, whole, 0.4);
}

TEST(TriangleRotations, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const auto sphere = conformal::makeGeodesicSphere(60);
  const auto neighbors = conformal::triangleNeighbors(sphere.Triangles, sphere.Positions.rows());
  const Points from = twisted(sphere.Positions, 0.0), to = twisted(sphere.Positions, 5.0);
  const auto with = [&](const conformal::Run& run) {
    return triangleRotations(sphere.Triangles, neighbors, from, to, { 0.0, 0.0, 1.0 }, run);
  };
  EXPECT_EQ(with({}), with(runs::backwards()));
  EXPECT_THROW(with(runs::stoppingAt(0.7)), conformal::Aborted);
}
