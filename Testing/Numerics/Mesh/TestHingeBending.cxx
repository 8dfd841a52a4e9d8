#include "Mesh/HingeBending.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::HingeBending;
using conformal::Index;
using conformal::Points;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
const Triangles Tetrahedron = (Triangles(4, 3) << 0, 1, 2, 0, 3, 1, 1, 3, 2, 0, 2, 3).finished();

/// The value of the form at x.
double energy(HingeBending& bending, const Points& x)
{
  bending.bend(x, {});
  double sum = 0.0;
  for (int i = 0; i < x.rows(); ++i)
  {
    sum += x.row(i).dot(bending.forceAt(i));
  }
  return sum;
}

/// Half as far along x, and sheared: a geodesic sphere squeezed flat has triangles of all shapes.
Points squeezed(const Points& sphere)
{
  Points flat = sphere;
  flat.col(0) = 0.2 * sphere.col(0) + 0.5 * sphere.col(1);
  flat.col(2).setZero();
  return flat;
}
}

TEST(HingeBending, WhatIsFlatFeelsNoForceHoweverThinItsTriangles)
{
  const auto sphere = conformal::makeGeodesicSphere(8);
  const auto around = conformal::vertexTriangles(sphere.Triangles, sphere.Positions.rows());
  const Points flat = squeezed(sphere.Positions);
  const Eigen::VectorXd stiffness = Eigen::VectorXd::Ones(flat.rows());
  HingeBending bending(sphere.Triangles, around, flat, stiffness, {});
  bending.bend(flat, {});
  const auto neighbors = conformal::vertexNeighbors(sphere.Triangles, flat.rows());
  int inside = 0;
  for (int i = 0; i < flat.rows(); ++i)
  {
    // Where the sphere was folded over, at its equator, hinges are bent by 180 degrees.
    bool folded = false;
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      for (const int* k = neighbors.begin(*j); k != neighbors.end(*j); ++k)
      {
        folded = folded || sphere.Positions(*k, 2) * sphere.Positions(i, 2) <= 0.0;
      }
    }
    if (!folded)
    {
      ++inside;
      EXPECT_LT(bending.forceAt(i).norm(), 1e-6) << i;
    }
  }
  EXPECT_GT(inside, flat.rows() / 2);
}

// All six hinges of a regular tetrahedron are bent by 180 - arccos(1/3) degrees.
TEST(HingeBending, MeasuresTheAnglesOfEdges)
{
  Points places(4, 3);
  places << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  const auto around = conformal::vertexTriangles(Tetrahedron, 4);
  HingeBending bending(Tetrahedron, around, places, Eigen::VectorXd::Constant(4, 14.0), {});
  const double theta = std::acos(-1.0 / 3.0), edge = std::sqrt(8.0);
  EXPECT_NEAR(energy(bending, places), 6.0 * std::pow(2.0 * edge * std::sin(theta / 2.0), 2), 1e-4);
}

TEST(HingeBending, IsOneQuadraticForm)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  const auto around = conformal::vertexTriangles(sphere.Triangles, sphere.Positions.rows());
  Points places = sphere.Positions;
  places.col(1) *= 0.3;
  HingeBending bending(
    sphere.Triangles, around, places, Eigen::VectorXd::LinSpaced(places.rows(), 1.0, 2.0), {});
  conformal::Random random(5);
  Points x(places.rows(), 3), y(places.rows(), 3);
  for (Index i = 0; i < x.size(); ++i)
  {
    x.data()[i] = random.uniform();
    y.data()[i] = random.uniform();
  }
  const auto product = [&](const Points& a, const Points& b)
  {
    bending.bend(a, {});
    double sum = 0.0;
    for (int i = 0; i < b.rows(); ++i)
    {
      sum += b.row(i).dot(bending.forceAt(i));
    }
    return sum;
  };
  EXPECT_NEAR(product(x, y), product(y, x), 1e-6 * std::abs(product(x, y)));
  EXPECT_GT(product(x, x), 0.0);
  for (int i : { 0, 7, 50 })
  {
    Points unit = Points::Zero(places.rows(), 3);
    unit(i, 1) = 1.0;
    EXPECT_NEAR(product(unit, unit), bending.diagonalAt(i), 1e-6 * bending.diagonalAt(i));
  }
  // Moving all does not bend.
  EXPECT_LT(energy(bending, Points::Constant(places.rows(), 3, 1.0)), 1e-9);
}

// A lattice of equilateral triangles feels it as it feels the uniform Laplacian.
TEST(HingeBending, IsAsStiffAsTheUniformLaplacian)
{
  const auto sphere = conformal::makeGeodesicSphere(32);
  const Index size = sphere.Positions.rows();
  const auto around = conformal::vertexTriangles(sphere.Triangles, size);
  const auto neighbors = conformal::vertexNeighbors(sphere.Triangles, size);
  HingeBending bending(sphere.Triangles, around, sphere.Positions, Eigen::VectorXd::Ones(size), {});
  const int i = static_cast<int>(size) - 1; // inside a face of the icosahedron
  double laplacian = 1.0;
  for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
  {
    laplacian += 1.0 / (neighbors.size(*j) * neighbors.size(*j));
  }
  EXPECT_NEAR(bending.diagonalAt(i) / laplacian, 1.0, 0.1);
}
