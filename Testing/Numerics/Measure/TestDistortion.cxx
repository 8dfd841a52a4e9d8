#include "Measure/Distortion.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::Distortion;
using conformal::Index;
using conformal::measureDistortion;
using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
Triangles oneTriangle()
{
  Triangles one(1, 3);
  one << 0, 1, 2;
  return one;
}

// Equilateral, as seen from outside counter-clockwise.
Points octant()
{
  return Points::Identity(3, 3);
}

// The sphere's conformal map that doubles lengths in the stereographic plane.
Points mobiusImage(const Points& n)
{
  Points image(n.rows(), 3);
  for (Index i = 0; i < n.rows(); ++i)
  {
    const double near = 1.0 + n(i, 2), far = 4.0 * (1.0 - n(i, 2));
    image.row(i) = Vector3(4.0 * n(i, 0), 4.0 * n(i, 1), near - far) / (near + far);
  }
  return image;
}
}

TEST(Distortion, IdentityHasNone)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  for (double unit : { 1.0, 1e-180, 1e180 })
  {
    const Points mesh = unit * sphere.Positions;
    const Distortion distortion = measureDistortion(mesh, sphere.Triangles, sphere.Positions);
    EXPECT_NEAR(distortion.SphereDegree, 1.0, 1e-12);
    EXPECT_EQ(distortion.NumberOfFlippedTriangles, 0);
    EXPECT_EQ(distortion.NumberOfZeroAreaTriangles, 0);
    EXPECT_NEAR(distortion.AreaDistortionDeviation, 0.0, 1e-12);
    for (Index r = 0; r < sphere.Triangles.rows(); ++r)
    {
      ASSERT_NEAR(distortion.AngleDistortion[r], 0.0, 1e-10);
      ASSERT_NEAR(distortion.AreaDistortion[r], 0.0, 1e-12);
      ASSERT_NEAR(distortion.QuasiConformalError[r], 1.0, 1e-7);
    }
  }
}

// Right and isosceles instead of equilateral: corners change by 30, 15 and 15 degrees.
TEST(Distortion, KnowsAnglesOfARightTriangle)
{
  Points mesh(3, 3);
  mesh << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  const Distortion distortion = measureDistortion(mesh, oneTriangle(), octant());
  EXPECT_NEAR(distortion.AngleDistortion[0], 20.0, 1e-12);
  EXPECT_NEAR(distortion.MeanAngleDistortion, 20.0, 1e-12);
  EXPECT_NEAR(distortion.QuasiConformalError[0], std::sqrt(3.0), 1e-12);
}

// K is the factor of a stretch in any direction of the triangle's plane, area is not in it.
TEST(Distortion, QuasiConformalErrorIsTheStretch)
{
  const Vector3 normal = Vector3::Ones().normalized();
  for (double angle : { 0.0, 0.4, 1.1, 2.0 })
  {
    const Vector3 side = Vector3(1, -1, 0).normalized();
    const Vector3 direction = std::cos(angle) * side + std::sin(angle) * normal.cross(side);
    for (double stretch : { 1.0, 1.5, 40.0 })
    {
      const Points mesh = 3.0 * octant() *
        (Eigen::Matrix3d::Identity() + (stretch - 1.0) * direction * direction.transpose());
      const Distortion distortion = measureDistortion(mesh, oneTriangle(), octant());
      EXPECT_NEAR(distortion.QuasiConformalError[0], stretch, 1e-7 * stretch);
      EXPECT_EQ(distortion.AreaDistortion[0], 0.0);
    }
  }
}

// Two triangles with 1/2 and 1/2 of the sphere's area, 1/3 and 2/3 of the mesh's.
TEST(Distortion, KnowsSharesOfArea)
{
  Points mesh(4, 3), sphere(4, 3);
  mesh << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -2, 0;
  sphere << 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1;
  Triangles two(2, 3);
  two << 0, 1, 2, 1, 0, 3;
  const Distortion distortion = measureDistortion(mesh, two, sphere);
  EXPECT_NEAR(distortion.AreaDistortion[0], std::log(3.0 / 2.0), 1e-14);
  EXPECT_NEAR(distortion.AreaDistortion[1], std::log(3.0 / 4.0), 1e-14);
  EXPECT_NEAR(distortion.AreaDistortionDeviation, 0.5 * std::log(2.0), 1e-14);
  EXPECT_NEAR(distortion.SphereDegree, 0.25, 1e-14); // two octants
  // The areas of the triangles are 1/2 and 1. The images are equilateral.
  EXPECT_NEAR(distortion.QuasiConformalError[0], std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(distortion.AreaMeanQuasiConformalError,
    (distortion.QuasiConformalError[0] + 2.0 * distortion.QuasiConformalError[1]) / 3.0, 1e-12);
}

// A Moebius transform is conformal; what is left comes from flat triangles and halves with them.
TEST(Distortion, MobiusImageIsConformalInTheLimit)
{
  double previous = 0.0;
  for (int f : { 12, 24, 48 })
  {
    const auto sphere = conformal::makeGeodesicSphere(f);
    const Distortion distortion =
      measureDistortion(sphere.Positions, sphere.Triangles, mobiusImage(sphere.Positions));
    const double error = distortion.MeanQuasiConformalError - 1.0;
    if (previous > 0.0)
    {
      EXPECT_NEAR(error / previous, 0.5, 0.03);
    }
    previous = error;
    EXPECT_EQ(distortion.NumberOfFlippedTriangles, 0);
    EXPECT_NEAR(distortion.SphereDegree, 1.0, 1e-12);
    EXPECT_GT(distortion.AreaDistortionDeviation, 0.3);
  }
  EXPECT_LT(previous, 0.01);
}

// A vertex pulled just over an edge of its ring turns one triangle over.
TEST(Distortion, CountsFlipsWhateverTheOrientationOfTheWhole)
{
  const auto sphere = conformal::makeGeodesicSphere(5);
  const Index inside = 200; // of six triangles
  Points positions = sphere.Positions;
  const conformal::Adjacency around =
    conformal::vertexTriangles(sphere.Triangles, sphere.Positions.rows());
  ASSERT_EQ(around.size(inside), 6);
  const auto corners = sphere.Triangles.row(*around.begin(inside));
  Vector3 edge = Vector3::Zero();
  for (int id : { corners[0], corners[1], corners[2] })
  {
    edge += id == inside ? Vector3::Zero().eval() : Vector3(0.5 * sphere.Positions.row(id));
  }
  const Vector3 old = sphere.Positions.row(inside);
  positions.row(inside) = (old + 1.1 * (edge - old)).normalized();
  EXPECT_EQ(
    measureDistortion(sphere.Positions, sphere.Triangles, positions).NumberOfFlippedTriangles, 1);
  positions.col(0) *= -1.0;
  const Distortion mirrored = measureDistortion(sphere.Positions, sphere.Triangles, positions);
  EXPECT_EQ(mirrored.NumberOfFlippedTriangles, 1);
  EXPECT_NEAR(mirrored.SphereDegree, -1.0, 1e-12);
}

TEST(Distortion, LeavesOutWhatHasNoArea)
{
  Points mesh(6, 3), sphere(6, 3);
  mesh << 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 0, 0, 1, 0, 0, 2;
  sphere << Points::Identity(3, 3), Points::Identity(3, 3);
  sphere.row(5) = sphere.row(4);
  Triangles triangles(4, 3);
  triangles << 0, 1, 2, 0, 1, 3, 1, 4, 5, 2, 2, 2; // good, flat mesh, flat on the sphere, a point
  const Distortion distortion = measureDistortion(mesh, triangles, sphere);
  EXPECT_EQ(distortion.NumberOfZeroAreaTriangles, 3);
  EXPECT_NEAR(distortion.MeanAngleDistortion, 20.0, 1e-12);
  for (int r : { 1, 2, 3 })
  {
    EXPECT_EQ(distortion.AngleDistortion[r], 0.0);
    EXPECT_EQ(distortion.AreaDistortion[r], 0.0);
    EXPECT_EQ(distortion.QuasiConformalError[r], 1.0);
  }
  const Distortion nothing = measureDistortion(Points(Points::Zero(6, 3)), triangles, sphere);
  EXPECT_EQ(nothing.NumberOfZeroAreaTriangles, 4);
  EXPECT_EQ(nothing.MeanQuasiConformalError, 1.0);
}

TEST(Distortion, RefusesWhatCannotBeMeasured)
{
  Points bad = octant();
  EXPECT_THROW(
    measureDistortion(bad, oneTriangle(), Points::Identity(2, 3)), std::invalid_argument);
  bad(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(measureDistortion(bad, oneTriangle(), octant()), std::invalid_argument);
}
