#include "Mesh/VertexNormals.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;
using conformal::vertexNormals;

TEST(VertexNormals, PointOutwardsOnTheSphereInAnyUnit)
{
  const auto sphere = conformal::makeGeodesicSphere(12);
  for (const double unit : { 1e-200, 1.0, 1e200 })
  {
    const Points normals = vertexNormals(unit * sphere.Positions, sphere.Triangles);
    EXPECT_LT((normals - sphere.Positions).rowwise().norm().maxCoeff(), 0.01);
  }
}

TEST(VertexNormals, AreWeightedByArea)
{
  // Two triangles at a right angle share an edge; one is three times as large.
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3;
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 3, 1; // normals +z and +y
  const Points normals = vertexNormals(points, triangles);
  EXPECT_LT((Vector3(normals.row(0)) - Vector3(0, 3, 1).normalized()).norm(), 1e-15);
  EXPECT_EQ(Vector3(normals.row(2)), Vector3(0, 0, 1));
  EXPECT_EQ(Vector3(normals.row(3)), Vector3(0, 1, 0));
}

TEST(VertexNormals, AreZeroWhereNothingIsKnown)
{
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5;
  Triangles triangles(1, 3);
  triangles << 0, 1, 2;
  EXPECT_EQ(vertexNormals(points, triangles), Points(Points::Zero(4, 3)));
  EXPECT_EQ(vertexNormals(Points(0, 3), Triangles(0, 3)).rows(), 0);
}
