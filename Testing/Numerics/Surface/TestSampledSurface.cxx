#include "Surface/SampledSurface.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

using conformal::clampedSupport;
using conformal::CurvedSeamlessSurface;
using conformal::CurvedSeamlessSurfaceOptions;
using conformal::fillNormals;
using conformal::Index;
using conformal::isOrientedInward;
using conformal::makeGeodesicSphere;
using conformal::MappedMesh;
using conformal::Mesh;
using conformal::NumberView;
using conformal::Points;
using conformal::smoothNormals;
using conformal::Triangles;
using conformal::Vector3;

TEST(SampledSurface, IsOrientedInwardWhereMostAreaOpposesTheNormals)
{
  const Mesh sphere = makeGeodesicSphere(6);
  EXPECT_FALSE(isOrientedInward(sphere.Positions, sphere.Triangles, sphere.Positions));
  EXPECT_TRUE(isOrientedInward(sphere.Positions, sphere.Triangles, -sphere.Positions));
  Triangles turned = sphere.Triangles;
  turned.col(1).swap(turned.col(2));
  EXPECT_TRUE(isOrientedInward(sphere.Positions, turned, sphere.Positions));
  turned.topRows(2 * turned.rows() / 3) = sphere.Triangles.topRows(2 * turned.rows() / 3);
  EXPECT_FALSE(isOrientedInward(sphere.Positions, turned, sphere.Positions));
  EXPECT_FALSE(isOrientedInward(Points(0, 3), Triangles(0, 3), Points(0, 3)));
}

TEST(SampledSurface, SmoothNormalsAreThoseOfTheTriangles)
{
  const Mesh sphere = makeGeodesicSphere(12);
  Points positions(sphere.Positions.rows() + 1, 3);
  positions << sphere.Positions, 3.0, 0.0, 0.0; // of no triangle
  Points normals = Points::Constant(positions.rows(), 3, 7.0);
  smoothNormals(positions, sphere.Triangles, normals);
  EXPECT_LT(
    (normals.topRows(sphere.Positions.rows()) - sphere.Positions).rowwise().norm().maxCoeff(),
    0.01);
  EXPECT_EQ(Vector3(normals.bottomRows(1).transpose()), Vector3::Constant(7.0));
}

TEST(SampledSurface, MissingNormalsBecomeDirections)
{
  const Points directions = makeGeodesicSphere(40).Positions; // of several blocks
  Points normals = -directions;
  for (Index i = 0; i < normals.rows(); i += 3)
  {
    normals.row(i).setZero();
  }
  fillNormals(normals, directions, runs::backwards());
  for (Index i = 0; i < normals.rows(); ++i)
  {
    EXPECT_EQ(Vector3(normals.row(i)), (i % 3 == 0 ? 1.0 : -1.0) * Vector3(directions.row(i)));
  }
}

TEST(SampledSurface, SupportIsInterpolatedLinearlyAndClamped)
{
  const MappedMesh mesh = spheres::mapped(3);
  const CurvedSeamlessSurface surface(mesh);
  std::vector<double> support(mesh.Positions.rows(), 0.5);
  support[0] = 4.0;
  support[1] = -2.0;
  support[2] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> vertices = clampedSupport(surface, support);
  const auto at = [&](const Points& directions, const conformal::Run& run = {})
  {
    std::vector<double> numbers(directions.rows());
    conformal::SurfaceSamples samples;
    samples.VertexNumbers = vertices.data();
    samples.Numbers = numbers.data();
    conformal::evaluate(surface, directions, samples, run);
    return numbers;
  };
  const std::vector<double> atVertices = at(surface.sphere());
  for (std::size_t v = 0; v < support.size(); ++v)
  {
    EXPECT_NEAR(atVertices[v], v == 0 ? 1.0 : v < 3 ? 0.0 : 0.5, 1e-12);
  }
  // Between the corners of a triangle it lies between their numbers.
  const auto ids = surface.triangles().row(0);
  const Points middle =
    (surface.sphere().row(ids[0]) + surface.sphere().row(ids[1]) + surface.sphere().row(ids[2]))
      .normalized();
  const double expected = (atVertices[ids[0]] + atVertices[ids[1]] + atVertices[ids[2]]) / 3.0;
  EXPECT_NEAR(at(middle)[0], expected, 0.05);
  EXPECT_EQ(at(surface.sphere(), runs::backwards()), atVertices);
  EXPECT_EQ(clampedSupport(surface, NumberView()), std::vector<double>(support.size(), 0.0));
}

TEST(SampledSurface, MarksPiecesOfDegenerateTriangles)
{
  MappedMesh mesh = spheres::mapped(2);
  mesh.Positions.row(0) =
    mesh.Positions.row(mesh.Triangles(0, 0) == 0 ? mesh.Triangles(0, 1) : mesh.Triangles(0, 0));
  const CurvedSeamlessSurface surface(mesh);
  ASSERT_GT(surface.numberOfDegeneratePatches(), 0);
  constexpr int subdivisions = 3;
  const Mesh fine = conformal::subdividedNetwork(surface, subdivisions);
  std::vector<unsigned char> marks(fine.Triangles.rows(), 7);
  conformal::markDegenerate(
    surface, fine.Triangles, subdivisions, {}, marks.data(), runs::backwards());
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1),
    subdivisions * subdivisions * surface.numberOfDegeneratePatches());
  for (std::size_t r = 0; r < marks.size(); ++r)
  {
    EXPECT_EQ(marks[r], surface.degenerate()[r / (subdivisions * subdivisions)]);
  }
}

TEST(SampledSurface, MarksTrianglesWithADegenerateDirection)
{
  const CurvedSeamlessSurface surface(spheres::mapped(2));
  const Mesh sphere = makeGeodesicSphere(4);
  std::vector<unsigned char> degenerate(sphere.Positions.rows(), 0), marks(sphere.Triangles.rows());
  degenerate[5] = 1;
  conformal::markDegenerate(surface, sphere.Triangles, 0, degenerate, marks.data());
  for (Index r = 0; r < sphere.Triangles.rows(); ++r)
  {
    EXPECT_EQ(marks[r], (sphere.Triangles.row(r).array() == 5).any() ? 1 : 0);
  }
}
