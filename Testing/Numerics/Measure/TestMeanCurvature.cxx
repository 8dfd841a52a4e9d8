#include "Measure/MeanCurvature.h"

#include "Measure/SurfaceMismatch.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <utility>

using conformal::Index;
using conformal::MeanCurvature;
using conformal::Mesh;
using conformal::Points;
using conformal::SurfaceMismatchOptions;
using conformal::Vector3;

namespace
{
Mesh sphere(int frequency, double radius)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  mesh.Positions *= radius;
  return mesh;
}

double errorBetween(const Mesh& model, const Mesh& reference, double unit = 1.0)
{
  SurfaceMismatchOptions options;
  options.LengthUnit = conformal::MismatchUnit::None;
  options.NumberOfSamples = 500;
  options.CoordinateUnit = unit;
  return conformal::measureSurfaceMismatch(
    model.Positions, model.Triangles, reference.Positions, reference.Triangles, options)
    .RootMeanSquareCurvatureError;
}
}

// Normals are exact on a sphere, so that only the flatness of the triangles is left.
TEST(MeanCurvature, KnowsSpheres)
{
  const Mesh mesh = sphere(12, 4.0);
  const MeanCurvature curvature(mesh.Positions, mesh.Triangles);
  MeanCurvature::Memory memory;
  for (Index r = 0; r < mesh.Triangles.rows(); r += 17)
  {
    const Vector3 corner = mesh.Positions.row(mesh.Triangles(r, 0));
    EXPECT_NEAR(curvature.over(corner, r, 0.0, memory), 0.25, 0.002);
    EXPECT_NEAR(curvature.over(corner, r, 1.0, memory), 0.25, 0.001);
  }
}

// At the end of the first axis of an ellipsoid with semi-axes a, b, c: H = a / 2 (1 / b^2 + 1 /
// c^2).
TEST(MeanCurvature, KnowsAnEllipsoid)
{
  Mesh mesh = sphere(60, 1.0);
  mesh.Positions.col(1) *= 0.7;
  mesh.Positions.col(2) *= 0.5;
  const MeanCurvature curvature(mesh.Positions, mesh.Triangles);
  MeanCurvature::Memory memory;
  Index nearest = 0;
  double most = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const double x = mesh.Positions(mesh.Triangles(r, 0), 0);
    nearest = x > most ? r : nearest;
    most = std::max(most, x);
  }
  const double exact = 0.5 * (1.0 / 0.49 + 1.0 / 0.25);
  EXPECT_NEAR(curvature.over(Vector3(1.0, 0.0, 0.0), nearest, 0.05, memory), exact, 0.03);
}

TEST(MeanCurvature, HasNoValueForATriangleWithoutArea)
{
  Points points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  conformal::Triangles triangles(1, 3);
  triangles << 0, 1, 2;
  MeanCurvature::Memory memory;
  EXPECT_EQ(MeanCurvature(points, triangles).over(Vector3::Zero(), 0, 1.0, memory), 0.0);
}

TEST(SurfaceMismatch, ComparesCurvatures)
{
  const Mesh small = sphere(20, 1.0), large = sphere(24, 2.0);
  EXPECT_NEAR(errorBetween(small, large), 0.5, 0.002);
  EXPECT_NEAR(errorBetween(small, sphere(24, 1.0)), 0.0, 0.002);
  EXPECT_NEAR(errorBetween(small, large, 0.001), 500.0, 2.0);
  Mesh reversed = large;
  reversed.Triangles.col(0).swap(reversed.Triangles.col(1));
  EXPECT_NEAR(errorBetween(small, reversed), 0.5, 0.002);
}

// A soup has three points for each triangle. In a mesh of mixed orientation, neighboring triangles
// have opposite orientations.
TEST(SurfaceMismatch, ComparesCurvaturesOfSoupsAndOfMixedOrientation)
{
  const Mesh small = sphere(10, 1.0), large = sphere(12, 2.0);
  const double expected = errorBetween(small, large);
  EXPECT_NEAR(expected, 0.5, 0.01);
  Mesh soup, mixed = large;
  soup.Positions.resize(large.Triangles.size(), 3);
  soup.Triangles.resize(large.Triangles.rows(), 3);
  for (Index r = 0; r < large.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      soup.Triangles(r, k) = static_cast<int>(3 * r + k);
      soup.Positions.row(3 * r + k) = large.Positions.row(large.Triangles(r, k));
    }
    if (r % 2 == 0)
    {
      std::swap(mixed.Triangles(r, 0), mixed.Triangles(r, 1));
      std::swap(soup.Triangles(r, 0), soup.Triangles(r, 1));
    }
  }
  EXPECT_NEAR(errorBetween(small, soup), expected, 1e-9);
  EXPECT_NEAR(errorBetween(small, mixed), expected, 1e-9);
  EXPECT_NEAR(errorBetween(soup, small), errorBetween(large, small), 1e-3);
}
