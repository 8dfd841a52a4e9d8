#include "Texture/SurfaceTangents.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::surfaceTangents;
using conformal::TextureCoordinates;
using conformal::Vector2;
using conformal::Vector3;

namespace
{
// Grid of 6 x 6 points in the plane z = 0.
Mesh plane()
{
  constexpr int side = 6;
  Mesh mesh;
  mesh.Positions.resize(side * side, 3);
  mesh.Triangles.resize(2 * (side - 1) * (side - 1), 3);
  Index f = 0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const int v = j * side + i;
      mesh.Positions.row(v) = Vector3(0.2 * i, 0.2 * j, 0.0);
      if (i + 1 < side && j + 1 < side)
      {
        mesh.Triangles.row(f++) << v, v + 1, v + side + 1;
        mesh.Triangles.row(f++) << v, v + side + 1, v + side;
      }
    }
  }
  return mesh;
}

Points upward(const Mesh& mesh)
{
  Points normals = Points::Zero(mesh.Positions.rows(), 3);
  normals.col(2).setOnes();
  return normals;
}

TextureCoordinates transformed(const Mesh& mesh, const Eigen::Matrix2d& matrix)
{
  return mesh.Positions.leftCols<2>() * matrix.transpose();
}
}

// For (s, t) = A (x, y), s increases along the first column of the inverse of A, with t constant.
TEST(SurfaceTangents, AreTheDirectionOfIncreasingS)
{
  const Mesh mesh = plane();
  Eigen::Matrix2d matrix;
  for (const auto& [a, b, c, d] : { std::array{ 1.0, 0.0, 0.0, 1.0 }, { 0.3, 0.4, -0.5, 2.0 },
         { 0.0, 3.0, -1.0, 0.0 }, { 1e-9, 0.0, 4e-10, 1e-9 } })
  {
    matrix << a, b, c, d;
    const Vector2 along = matrix.inverse().col(0).normalized();
    const Points tangents = surfaceTangents(mesh, upward(mesh), transformed(mesh, matrix));
    for (Index v = 0; v < tangents.rows(); ++v)
    {
      EXPECT_LT((tangents.row(v) - Eigen::RowVector3d(along[0], along[1], 0.0)).norm(), 1e-12);
    }
  }
}

// On a sphere with longitude as s, tangents point east.
TEST(SurfaceTangents, PointEastOnAGlobe)
{
  Mesh sphere = conformal::makeGeodesicSphere(20);
  TextureCoordinates coordinates(sphere.Positions.rows(), 2);
  for (Index v = 0; v < coordinates.rows(); ++v)
  {
    const Vector3 p = sphere.Positions.row(v);
    coordinates.row(v) << std::atan2(p[1], p[0]), std::asin(p[2]);
  }
  const Points tangents = surfaceTangents(sphere, sphere.Positions, coordinates);
  for (Index v = 0; v < tangents.rows(); ++v)
  {
    const Vector3 p = sphere.Positions.row(v);
    EXPECT_NEAR(tangents.row(v).norm(), 1.0, 1e-12);
    EXPECT_NEAR(tangents.row(v).dot(p), 0.0, 1e-12);
    if (p[0] > -0.8 && std::abs(p[2]) < 0.6)
    {
      const Vector3 east = Vector3(-p[1], p[0], 0.0).normalized();
      EXPECT_LT((tangents.row(v).transpose() - east).norm(), 0.02) << v;
    }
  }
}

// Copies of a vertex with equal texture coordinates get one tangent, as other programs compute it.
TEST(SurfaceTangents, AreEqualAtCopiesOfAVertex)
{
  const Mesh mesh = plane();
  TextureCoordinates coordinates = mesh.Positions.leftCols<2>();
  coordinates.col(0).array() += coordinates.col(1).array().square();
  const Points joined = surfaceTangents(mesh, upward(mesh), coordinates);
  Mesh soup;
  soup.Positions.resize(3 * mesh.Triangles.rows(), 3);
  soup.Triangles.resize(mesh.Triangles.rows(), 3);
  TextureCoordinates ofSoup(soup.Positions.rows(), 2);
  for (Index i = 0; i < mesh.Triangles.size(); ++i)
  {
    soup.Positions.row(i) = mesh.Positions.row(mesh.Triangles.data()[i]);
    ofSoup.row(i) = coordinates.row(mesh.Triangles.data()[i]);
    soup.Triangles.data()[i] = static_cast<int>(i);
  }
  const Points apart = surfaceTangents(soup, upward(soup), ofSoup);
  for (Index i = 0; i < mesh.Triangles.size(); ++i)
  {
    EXPECT_LT((apart.row(i) - joined.row(mesh.Triangles.data()[i])).norm(), 1e-12);
  }
}

TEST(SurfaceTangents, ArePerpendicularToNormalsWithoutAnImage)
{
  const Mesh mesh = plane();
  Eigen::Matrix2d mirror;
  mirror << -1.0, 0.0, 0.0, 1.0;
  for (const TextureCoordinates& coordinates : { TextureCoordinates(transformed(mesh, mirror)),
         TextureCoordinates(0.0 * mesh.Positions.leftCols<2>()) })
  {
    const Points tangents = surfaceTangents(mesh, upward(mesh), coordinates);
    EXPECT_LT(tangents.col(2).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((tangents.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  }
  EXPECT_THROW(
    surfaceTangents(mesh, Points(3, 3), TextureCoordinates(3, 2)), std::invalid_argument);
}
