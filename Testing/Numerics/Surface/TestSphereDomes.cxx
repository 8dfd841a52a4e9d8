#include "Surface/SphereDomes.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::FlatMap;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::SphereDomes;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
// A model of the sphere's topology, with what domes need of it.
struct Model
{
  explicit Model(int frequency)
    : Sphere(makeGeodesicSphere(frequency))
    , Positions(Sphere.Positions)
  {
    for (Index v = 0; v < this->Positions.rows(); ++v)
    {
      const Vector3 n = this->Sphere.Positions.row(v);
      this->Positions.row(v) *= 1.0 + 0.3 * std::sin(3.0 * n[0]) * n[1];
    }
    this->Neighbors = conformal::triangleNeighbors(this->Sphere.Triangles, this->Positions.rows());
    this->Map = FlatMap(this->Sphere.Positions, this->Positions, this->Sphere.Triangles,
      this->Neighbors, conformal::SeamMode::PerTriangle);
  }

  SphereDomes domes(bool insideOut = false) const
  {
    return SphereDomes(this->Sphere.Positions, this->Positions, this->Sphere.Triangles,
      this->Neighbors, this->Map, insideOut, {});
  }

  Mesh Sphere;
  Points Positions;
  Triangles Neighbors;
  FlatMap Map;
};

Vector3 at(const Points& points, const Triangles& triangles, Index r, const Vector3& barycentric)
{
  return barycentric[0] * points.row(triangles(r, 0)) +
    barycentric[1] * points.row(triangles(r, 1)) + barycentric[2] * points.row(triangles(r, 2));
}

const Vector3 Places[] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0.5, 0.5, 0 }, { 0.2, 0, 0.8 },
  { 0.1, 0.2, 0.7 }, { 0.6, 0.3, 0.1 }, Vector3::Constant(1.0 / 3.0) };
}

// |p - p'| with p = p' / |p'|, Eq. 6.
TEST(SphereDomes, AreAsHighAsTheSphereIsAboveItsTriangles)
{
  const Model model(4);
  const SphereDomes domes = model.domes();
  for (Index r = 0; r < model.Sphere.Triangles.rows(); ++r)
  {
    for (const Vector3& place : Places)
    {
      const Vector3 flat = at(model.Sphere.Positions, model.Sphere.Triangles, r, place);
      ASSERT_NEAR(domes.height(r, place), (flat.normalized() - flat).norm(), 1e-15);
    }
  }
}

// Eq. 7 at the middle's image, Eq. 8 on the edges, where neighbors agree.
TEST(SphereDomes, RiseAlongTheNormalInTheMiddleAndTheMeanOneOnEdges)
{
  const Model model(4);
  const SphereDomes domes = model.domes();
  const Triangles& triangles = model.Sphere.Triangles;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    ASSERT_TRUE(domes.defined(r));
    const Vector3 middle = FlatMap::Triangle(model.Map, r).toModel(Vector3::Constant(1.0 / 3.0));
    ASSERT_LT((domes.direction(r, middle) - domes.normal(r)).norm(), 1e-9);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const Index other = model.Neighbors(r, k);
      Vector3 ours = Vector3::Zero(), theirs = Vector3::Zero();
      ours[k] = 0.3;
      ours[next] = 0.7;
      for (int corner = 0; corner < 3; ++corner)
      {
        theirs[corner] = triangles(other, corner) == triangles(r, k) ? 0.3
          : triangles(other, corner) == triangles(r, next)           ? 0.7
                                                                     : 0.0;
      }
      const Vector3 mean = (domes.normal(r) + domes.normal(other)).normalized();
      ASSERT_LT((domes.direction(r, ours) - mean).norm(), 1e-12);
      ASSERT_LT((domes.direction(other, theirs) - mean).norm(), 1e-12);
    }
  }
}

TEST(SphereDomes, RiseOutwardWhicheverWayTrianglesRun)
{
  const Model model(3);
  const SphereDomes domes = model.domes(), turned = model.domes(true);
  for (Index r = 0; r < model.Sphere.Triangles.rows(); ++r)
  {
    const Vector3 middle =
      at(model.Positions, model.Sphere.Triangles, r, Vector3::Constant(1.0 / 3.0));
    EXPECT_GT(domes.normal(r).dot(middle), 0.0);
    EXPECT_EQ(turned.normal(r), -domes.normal(r));
    for (const Vector3& place : Places)
    {
      EXPECT_NEAR(domes.direction(r, place).norm(), 1.0, 1e-14);
    }
  }
}

TEST(SphereDomes, ATriangleWithoutAreaIsNotDefined)
{
  Model model(3);
  const auto ids = model.Sphere.Triangles.row(7);
  model.Positions.row(ids[1]) = model.Positions.row(ids[0]);
  model.Map = FlatMap(model.Sphere.Positions, model.Positions, model.Sphere.Triangles,
    model.Neighbors, conformal::SeamMode::PerTriangle);
  const SphereDomes domes = model.domes();
  EXPECT_EQ(domes.normal(7), Vector3::Zero());
  for (Index r = 0; r < model.Sphere.Triangles.rows(); ++r)
  {
    for (const Vector3& place : Places)
    {
      ASSERT_TRUE(domes.direction(r, place).allFinite());
    }
  }
}
