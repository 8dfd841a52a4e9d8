#include "Linear/EdgeWeights.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Points;
using conformal::Triangles;

namespace
{
// A tetrahedron of given heights over an equilateral base of side 1.
Points pyramid(double height)
{
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0.5, std::sqrt(0.75), 0, 0.5, std::sqrt(0.75) / 3.0, height;
  return points;
}

Triangles pyramidFaces()
{
  Triangles triangles(4, 3);
  triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  return triangles;
}
}

TEST(EdgeWeights, OfARegularTetrahedron)
{
  const auto strings = conformal::harmonicStrings(pyramid(std::sqrt(2.0 / 3.0)), pyramidFaces());
  EXPECT_EQ(strings.NumberOfNegative, 0);
  EXPECT_EQ(strings.NumberOfInfinite, 0);
  ASSERT_EQ(strings.Strings.Weights.size(), 12u);
  for (double weight : strings.Strings.Weights)
  {
    EXPECT_NEAR(weight, 1.0 / std::sqrt(3.0), 1e-14);
  }
}

// Flat, the three angles at the tip are 120 degrees; each base edge is opposite to one of them and
// to 60 degrees on the base: cot 120 + cot 60 = 0. A little higher is positive; deeper is not
// possible, so a second flat pyramid below makes them negative.
TEST(EdgeWeights, CountsWhatBreaksAHarmonicMap)
{
  Points points(5, 3);
  points << pyramid(0.05), 0.5, std::sqrt(0.75) / 3.0, -0.05;
  Triangles triangles(6, 3);
  triangles << 0, 1, 3, 1, 2, 3, 2, 0, 3, 1, 0, 4, 2, 1, 4, 0, 2, 4;
  EXPECT_EQ(conformal::harmonicStrings(points, triangles).NumberOfNegative, 3);
  EXPECT_EQ(conformal::harmonicStrings(points, triangles).NumberOfInfinite, 0);
  points.row(3) = 0.5 * (points.row(0) + points.row(1)); // on an edge: a triangle without area
  EXPECT_EQ(conformal::harmonicStrings(points, triangles).NumberOfInfinite, 3);
}

// Half the sum of string times squared length is the area for the surface itself.
TEST(EdgeWeights, TheEnergyOfASurfaceIsItsArea)
{
  const auto sphere = conformal::makeGeodesicSphere(30);
  const auto strings = conformal::harmonicStrings(sphere.Positions, sphere.Triangles);
  double area = 0.0;
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    const conformal::Vector3 a = sphere.Positions.row(sphere.Triangles(r, 0));
    area += 0.5 *
      (sphere.Positions.row(sphere.Triangles(r, 1)).transpose() - a)
        .cross(sphere.Positions.row(sphere.Triangles(r, 2)).transpose() - a)
        .norm();
  }
  EXPECT_NEAR(conformal::stringEnergy(strings.Strings, sphere.Positions), area, 1e-10);
  EXPECT_NEAR(conformal::vertexAreas(sphere.Positions, sphere.Triangles).sum(), 6.0 * area, 1e-9);
}
