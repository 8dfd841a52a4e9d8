#include "Surface/CurvedTriangles.h"

#include "Base/Random.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using conformal::CurvedTriangle;
using conformal::CurvedTriangles;
using conformal::CurvedTriangleTree;
using conformal::FootPoint;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::Random;
using conformal::ShadingNormals;
using conformal::Vector3;

namespace
{
/// An ellipsoid with bumps.
CurvedTriangles lumps(int frequency)
{
  const Mesh sphere = makeGeodesicSphere(frequency);
  Points positions = sphere.Positions;
  for (Index i = 0; i < positions.rows(); ++i)
  {
    const Vector3 n = sphere.Positions.row(i);
    positions.row(i) *= 1.0 + 0.2 * std::sin(4.0 * n[0] + 1.0) * std::cos(3.0 * n[1]);
    positions(i, 2) *= 0.7;
  }
  return CurvedTriangles(
    positions, conformal::vertexNormals(positions, sphere.Triangles), sphere.Triangles);
}

Vector3 randomPoint(Random& random)
{
  const double x = random.uniform(), y = (1.0 - x) * random.uniform();
  return { 1.0 - x - y, x, y };
}

double volume(const CurvedTriangles& surface, int cuts)
{
  // Every triangle cut into cuts^2 small ones.
  double sum = 0.0;
  for (Index r = 0; r < surface.triangles().rows(); ++r)
  {
    const CurvedTriangle triangle = surface[r];
    const auto at = [&](int i, int j)
    {
      const double x = static_cast<double>(i) / cuts, y = static_cast<double>(j) / cuts;
      return triangle.position({ 1.0 - x - y, x, y });
    };
    for (int i = 0; i < cuts; ++i)
    {
      for (int j = 0; i + j < cuts; ++j)
      {
        const Vector3 a = at(i, j), b = at(i + 1, j), c = at(i, j + 1);
        sum += a.dot(b.cross(c)) / 6.0;
        if (i + j + 1 < cuts)
        {
          const Vector3 d = at(i + 1, j + 1);
          sum += b.dot(d.cross(c)) / 6.0;
        }
      }
    }
  }
  return sum;
}
}

TEST(CurvedTriangles, NeighborsMeetToTheBit)
{
  const CurvedTriangles surface = lumps(5);
  const conformal::Triangles& triangles = surface.triangles();
  const conformal::Triangles neighbors =
    conformal::triangleNeighbors(triangles, surface.positions().rows());
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index other = neighbors(r, k);
      for (const double share : { 0.0, 0.25, 0.3, 0.5 })
      {
        Vector3 here = Vector3::Zero(), there = Vector3::Zero();
        here[k] = 1.0 - share;
        here[(k + 1) % 3] = share;
        for (int l = 0; l < 3; ++l)
        {
          there[l] = triangles(other, l) == triangles(r, k)    ? 1.0 - share
            : triangles(other, l) == triangles(r, (k + 1) % 3) ? share
                                                               : 0.0;
        }
        EXPECT_EQ(surface[r].position(here), surface[other].position(there));
        EXPECT_LT(
          (ShadingNormals(surface[r])(here) - ShadingNormals(surface[other])(there)).norm(), 1e-15);
      }
      // At its corners a triangle is tangent to the plane across the normal.
      EXPECT_LT((surface[r].surfaceNormal(Vector3::Unit(k)) -
                  Vector3(surface.normals().row(triangles(r, k))))
                  .norm(),
        1e-12);
    }
  }
}

TEST(CurvedTriangles, DerivativesAreDifferences)
{
  const CurvedTriangles surface = lumps(3);
  Random random(1);
  for (Index r = 0; r < surface.triangles().rows(); ++r)
  {
    const CurvedTriangle triangle = surface[r];
    const Vector3 m = randomPoint(random);
    const Eigen::Matrix3d derivative = triangle.derivative(m);
    const double h = 1e-5;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 step = h * Vector3::Unit(k);
      const Vector3 difference =
        (triangle.position(m + step) - triangle.position(m - step)) / (2.0 * h);
      EXPECT_LT((difference - derivative.col(k)).norm(), 1e-9);
    }
  }
}

TEST(CurvedTriangles, BoundsHoldTheTriangle)
{
  const CurvedTriangles surface = lumps(3);
  Random random(2);
  for (Index r = 0; r < surface.triangles().rows(); ++r)
  {
    const CurvedTriangle triangle = surface[r];
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_LT(triangle.bounds().squareDistance(triangle.position(randomPoint(random))), 1e-30);
    }
  }
}

TEST(CurvedTriangles, WithoutNormalsTheyAreFlat)
{
  const Mesh sphere = makeGeodesicSphere(1);
  const CurvedTriangles flat(sphere.Positions, Points::Zero(12, 3), sphere.Triangles);
  const Vector3 m(0.2, 0.3, 0.5);
  Vector3 expected = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    expected += m[k] * sphere.Positions.row(sphere.Triangles(4, k)).transpose();
  }
  EXPECT_LT((flat[4].position(m) - expected).norm(), 1e-16);
  EXPECT_EQ(flat[4].moment(1), Vector3(Vector3::Zero()));
  // The angle between an icosahedron's faces.
  const auto jumps = conformal::measureNormalJumps(
    flat, conformal::triangleNeighbors(sphere.Triangles, sphere.Positions.rows()));
  const double angle = 180.0 - std::acos(-std::sqrt(5.0) / 3.0) * 180.0 / std::acos(-1.0);
  EXPECT_NEAR(jumps.Mean, angle, 1e-10);
  EXPECT_NEAR(jumps.Maximum, angle, 1e-10);
}

TEST(CurvedTriangles, NormalsJumpLittleOnARoundSurface)
{
  const CurvedTriangles surface = lumps(12);
  const conformal::Triangles neighbors =
    conformal::triangleNeighbors(surface.triangles(), surface.positions().rows());
  const CurvedTriangles flat(
    surface.positions(), Points::Zero(surface.positions().rows(), 3), surface.triangles());
  const auto jumps = conformal::measureNormalJumps(surface, neighbors);
  EXPECT_GT(jumps.Mean, 0.0);
  EXPECT_LT(jumps.Mean, 0.1 * conformal::measureNormalJumps(flat, neighbors).Mean);
}

TEST(CurvedTriangles, LoweringProjectsTheDisplacementOntoLinearFunctions)
{
  const CurvedTriangles surface = lumps(8);
  const Points& x = surface.positions();
  const Points lowered = conformal::lowerVertices(
    surface, conformal::vertexTriangles(surface.triangles(), x.rows()), 1.0);
  const Eigen::VectorXd moves = (x - lowered).cwiseProduct(surface.normals()).rowwise().sum();
  EXPECT_GT(moves.maxCoeff(), 1e-3);
  // Quadrature of degree 4 is exact: three permutations of each of two points.
  const std::array<std::array<double, 2>, 2> rule{ { { 0.108103018168070, 0.223381589678011 },
    { 0.816847572980459, 0.109951743655322 } } };
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(x.rows()), scale = residual;
  for (Index r = 0; r < surface.triangles().rows(); ++r)
  {
    const auto ids = surface.triangles().row(r);
    const Vector3 a = x.row(ids[0]), b = x.row(ids[1]), c = x.row(ids[2]);
    const double area = 0.5 * (b - a).cross(c - a).norm();
    for (const auto& [first, weight] : rule)
    {
      for (int turn = 0; turn < 3; ++turn)
      {
        Vector3 m = Vector3::Constant(0.5 * (1.0 - first));
        m[turn] = first;
        const Vector3 rise = surface[r].position(m) - (m[0] * a + m[1] * b + m[2] * c);
        const double move = m[0] * moves[ids[0]] + m[1] * moves[ids[1]] + m[2] * moves[ids[2]];
        for (int k = 0; k < 3; ++k)
        {
          const double height = rise.dot(surface.normals().row(ids[k]));
          residual[ids[k]] += area * weight * m[k] * (height - move);
          scale[ids[k]] += area * weight * m[k] * std::abs(height);
        }
      }
    }
  }
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-3 * scale.maxCoeff());
}

TEST(CurvedTriangles, LoweredVerticesKeepTheVolume)
{
  const CurvedTriangles surface = lumps(8);
  const conformal::Adjacency around =
    conformal::vertexTriangles(surface.triangles(), surface.positions().rows());
  const double flat = conformal::signedVolume(surface.positions(), surface.triangles());
  const auto excess = [&](double share)
  {
    const Points lowered = conformal::lowerVertices(surface, around, share);
    return volume(CurvedTriangles(lowered, conformal::vertexNormals(lowered, surface.triangles()),
                    surface.triangles()),
             6) -
      flat;
  };
  EXPECT_EQ(conformal::lowerVertices(surface, around, 0.0), surface.positions());
  EXPECT_GT(excess(0.0), 0.003);
  EXPECT_LT(std::abs(excess(1.0)), 0.1 * excess(0.0));
  EXPECT_NEAR(excess(0.5), 0.5 * excess(0.0), 0.1 * excess(0.0));
}

TEST(CurvedTriangles, ClosestPointsAreTheClosest)
{
  const CurvedTriangles surface = lumps(4);
  const CurvedTriangleTree tree(surface);
  Random random(3);
  for (int i = 0; i < 300; ++i)
  {
    Vector3 x(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    x *= 3.0;
    const FootPoint foot = tree.closestPoint(x);
    ASSERT_GE(foot.Triangle, 0);
    const CurvedTriangle triangle = surface[foot.Triangle];
    EXPECT_LT((triangle.position(foot.Barycentric) - foot.Position).norm(), 1e-15);
    EXPECT_DOUBLE_EQ((foot.Position - x).squaredNorm(), foot.SquareDistance);
    double least = std::numeric_limits<double>::infinity();
    for (Index r = 0; r < surface.triangles().rows(); ++r)
    {
      for (int a = 0; a <= 10; ++a)
      {
        for (int b = 0; a + b <= 10; ++b)
        {
          const Vector3 q = surface[r].position({ 1.0 - 0.1 * (a + b), 0.1 * a, 0.1 * b });
          least = std::min(least, (q - x).squaredNorm());
        }
      }
    }
    EXPECT_LE(foot.SquareDistance, least * (1.0 + 1e-12));
    EXPECT_LT(std::sqrt(least) - std::sqrt(foot.SquareDistance), 0.02);
    const FootPoint hinted = tree.closestPoint(x, static_cast<int>(random.index(320)));
    EXPECT_NEAR(hinted.SquareDistance, foot.SquareDistance, 1e-12);
  }
  EXPECT_EQ(CurvedTriangleTree().closestPoint(Vector3::Zero()).Triangle, -1);
}
