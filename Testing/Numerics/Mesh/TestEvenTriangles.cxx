#include "Mesh/EvenTriangles.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/Remeshing.h"

#include <gtest/gtest.h>

using conformal::hasEvenTriangles;
using conformal::Mesh;

TEST(EvenTriangles, AreThoseOfRemeshing)
{
  Mesh mesh = conformal::makeGeodesicSphere(30);
  mesh.Positions.col(0) *= 4.0; // needles at the waist
  mesh.Positions.col(2).array() *= 1.0 + 0.3 * (3.0 * mesh.Positions.col(1)).array().sin();
  EXPECT_FALSE(hasEvenTriangles(mesh));
  conformal::RemeshingOptions options;
  options.NumberOfVertices = 4000;
  options.NumberOfIterations = 6;
  options.MeetNumber = true;
  conformal::remesh(mesh, options);
  EXPECT_TRUE(hasEvenTriangles(mesh));
}

TEST(EvenTriangles, NeedBothAnglesAndValences)
{
  Mesh sphere = conformal::makeGeodesicSphere(20);
  EXPECT_TRUE(hasEvenTriangles(sphere));
  sphere.Positions.col(2) *= 2.0; // the valences alone do not do
  EXPECT_FALSE(hasEvenTriangles(sphere));
  // Nor do the angles.
  EXPECT_TRUE(hasEvenTriangles(conformal::makeGeodesicSphere(1)));
  Mesh octahedron;
  octahedron.Positions.resize(6, 3);
  octahedron.Positions << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  octahedron.Triangles.resize(8, 3);
  octahedron.Triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  EXPECT_FALSE(hasEvenTriangles(octahedron)); // 60 degrees, four triangles around each vertex
}
