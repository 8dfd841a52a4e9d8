#include "Body/BodyRelief.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::measureRelief;
using conformal::Mesh;
using conformal::Pi;
using conformal::ReferenceEllipsoid;
using conformal::Vector3;

namespace
{
Eigen::Matrix3d turn()
{
  return Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
}

Mesh ellipsoid(const Vector3& radii, int frequency = 30)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  mesh.Positions = mesh.Positions * radii.asDiagonal() * turn().transpose();
  mesh.Positions.rowwise() += Eigen::RowVector3d(5, 6, 7);
  return mesh;
}

double largest(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double value : values)
  {
    most = std::max(most, std::abs(value));
  }
  return most;
}
}

// It has neither heights nor slopes over itself, but for what a mesh lacks of it: h^2.
TEST(BodyRelief, FindsAnEllipsoid)
{
  for (const int frequency : { 20, 40 })
  {
    const Mesh mesh = ellipsoid({ 3, 2, 1 }, frequency);
    const ReferenceEllipsoid reference = conformal::referenceEllipsoid(mesh);
    const double tolerance = 2.0 / (frequency * frequency);
    EXPECT_LT((reference.Center - Vector3(5, 6, 7)).norm(), 1e-12);
    EXPECT_LT((reference.Radii - Vector3(3, 2, 1)).norm(), tolerance);
    EXPECT_NEAR(reference.Axes.determinant(), 1.0, 1e-12);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(std::abs(reference.Axes.col(k).dot(turn().col(k))), 1.0, 1e-10);
    }
    const conformal::BodyRelief relief = measureRelief(mesh, reference);
    EXPECT_LT(largest(relief.Heights), tolerance);
    EXPECT_LT(largest(relief.Slopes), 180.0 * tolerance);
  }
}

TEST(BodyRelief, MeasuresFromASphere)
{
  const Mesh mesh = ellipsoid({ 3, 2, 1 });
  const ReferenceEllipsoid sphere = conformal::referenceSphere(mesh);
  EXPECT_NEAR(sphere.Radii[0], std::cbrt(6.0), 0.01);
  EXPECT_EQ(sphere.Radii[0], sphere.Radii[2]);
  const conformal::BodyRelief relief = measureRelief(mesh, sphere);
  EXPECT_NEAR(
    *std::max_element(relief.Heights.begin(), relief.Heights.end()), 3.0 - sphere.Radii[0], 0.01);
  EXPECT_NEAR(
    *std::min_element(relief.Heights.begin(), relief.Heights.end()), 1.0 - sphere.Radii[0], 0.01);
  // The largest angle between the normal and the radius is where tan(angle) = (a - c) (a + c) /
  // 2ac.
  EXPECT_NEAR(largest(relief.Slopes), std::atan2(8.0, 6.0) * 180.0 / Pi, 1.0);
}

// All is as large as the body, to the bit, and none of it depends on which side is out.
TEST(BodyRelief, ScalesWithTheBody)
{
  Mesh mesh = ellipsoid({ 3, 2, 1 }, 8);
  const conformal::BodyRelief one = measureRelief(mesh, conformal::referenceEllipsoid(mesh));
  mesh.Positions *= 1024.0;
  const conformal::BodyRelief large = measureRelief(mesh, conformal::referenceEllipsoid(mesh));
  for (std::size_t i = 0; i < one.Heights.size(); ++i)
  {
    EXPECT_NEAR(large.Heights[i], 1024.0 * one.Heights[i], 1e-9);
    EXPECT_NEAR(large.Slopes[i], one.Slopes[i], 1e-9);
  }
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  const conformal::BodyRelief turned = measureRelief(mesh, conformal::referenceEllipsoid(mesh));
  for (std::size_t i = 0; i < one.Heights.size(); ++i)
  {
    EXPECT_NEAR(turned.Heights[i], large.Heights[i], 1e-9);
    EXPECT_NEAR(turned.Slopes[i], large.Slopes[i], 1e-9);
  }
}

TEST(BodyRelief, NeedsAVolume)
{
  Mesh flat = conformal::makeGeodesicSphere(4);
  flat.Positions.col(2).setZero();
  EXPECT_THROW(conformal::referenceEllipsoid(flat), std::invalid_argument);
  EXPECT_THROW(conformal::referenceSphere(flat), std::invalid_argument);
  EXPECT_THROW(conformal::referenceSphere(Mesh()), std::invalid_argument);
}
