#include "TriangleMap/FlatMap.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using conformal::FlatMap;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::Random;
using conformal::SeamMode;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
/// A closed mesh with its map to the sphere.
struct Shape
{
  Shape(const Points& sphere, const Points& model, const conformal::Triangles& triangles)
    : Sphere(sphere)
    , Model(model)
    , Triangles(triangles)
    , Neighbors(conformal::triangleNeighbors(triangles, sphere.rows()))
  {
  }
  FlatMap map(SeamMode mode) const
  {
    return FlatMap(this->Sphere, this->Model, this->Triangles, this->Neighbors, mode);
  }

  Points Sphere, Model;
  conformal::Triangles Triangles, Neighbors;
};

Points shaken(const Points& points, double by, unsigned int seed)
{
  Random random(seed);
  Points result = points;
  for (Index i = 0; i < result.size(); ++i)
  {
    result.data()[i] += by * (2.0 * random.uniform() - 1.0);
  }
  return result;
}

double minimumAngle(const Points& points, const Triangles& triangles)
{
  double smallest = 180.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 o = points.row(triangles(r, k));
      const Vector3 u = Vector3(points.row(triangles(r, (k + 1) % 3))) - o,
                    v = Vector3(points.row(triangles(r, (k + 2) % 3))) - o;
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v)) * 45.0 / std::atan(1.0);
      smallest = std::min(smallest, angle);
    }
  }
  return smallest;
}

/// Closed meshes of triangles of any shape, on the sphere too.
Shape randomMesh(double by, unsigned int seed = 1)
{
  const Mesh network = makeGeodesicSphere(9);
  Points sphere = shaken(network.Positions, 0.025, seed);
  sphere.rowwise().normalize();
  return Shape(sphere, shaken(sphere, by, seed + 100), network.Triangles);
}

/// The sphere's own conformal maps: a stereographic plane scaled.
Shape moebiusMesh(int frequency, double factor)
{
  const Mesh network = makeGeodesicSphere(frequency);
  Points model = network.Positions;
  for (Index i = 0; i < model.rows(); ++i)
  {
    // tan of half the angle from the pole is multiplied by the factor
    const Vector3 n = network.Positions.row(i);
    const double half = factor * factor * (1.0 - n[2]), other = 1.0 + n[2];
    const double sum = half + other;
    model.row(i) << 2.0 * factor * n[0] / sum, 2.0 * factor * n[1] / sum, (other - half) / sum;
  }
  return Shape(network.Positions, model, network.Triangles);
}

Vector3 randomPoint(Random& random)
{
  double x = random.uniform(), y = random.uniform();
  if (x + y > 1.0)
  {
    x = 1.0 - x;
    y = 1.0 - y;
  }
  return { x, y, 1.0 - x - y };
}

/// Dense in the triangle, and denser towards its edges and corners.
Vector3 randomPointNearBorders(Random& random)
{
  Vector3 point = randomPoint(random);
  for (int k = 0; k < 3; ++k)
  {
    if (random.uniform() < 0.5)
    {
      point[k] *= std::pow(10.0, -6.0 * random.uniform());
    }
  }
  return point / point.sum();
}

Eigen::Matrix2d inPlane(const Eigen::Matrix3d& derivative)
{
  Eigen::Matrix2d plane;
  plane.col(0) = (derivative.col(1) - derivative.col(0)).tail<2>();
  plane.col(1) = (derivative.col(2) - derivative.col(0)).tail<2>();
  return plane;
}

/// Edge k is opposite to corner k; the same edge of the neighbor.
struct Across
{
  Index Triangle;
  int Edge;
};

Across across(const Shape& mesh, Index r, int edge)
{
  const Index other = mesh.Neighbors(r, (edge + 1) % 3);
  for (int k = 0; k < 3; ++k)
  {
    const int id = mesh.Triangles(other, k);
    if (id != mesh.Triangles(r, (edge + 1) % 3) && id != mesh.Triangles(r, (edge + 2) % 3))
    {
      return { other, k };
    }
  }
  return { -1, -1 };
}

/// Images of a point a little to either side of an edge: how far apart, in shares of the edge.
double slip(const Shape& mesh, const FlatMap& map, Index r, int edge, double t, double aside)
{
  const auto point = [&](int k, double share)
  {
    Vector3 l;
    l[k] = aside;
    l[(k + 1) % 3] = (1.0 - aside) * (1.0 - share);
    l[(k + 2) % 3] = (1.0 - aside) * share;
    return l;
  };
  const auto place = [&](Index triangle, const Vector3& l)
  {
    const Vector3 q = FlatMap::Triangle(map, triangle).toModel(l);
    Vector3 sum = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += q[k] * mesh.Model.row(mesh.Triangles(triangle, k)).transpose();
    }
    return sum;
  };
  const Across other = across(mesh, r, edge);
  const Vector3 here = place(r, point(edge, t)),
                there = place(other.Triangle, point(other.Edge, 1.0 - t));
  const double length = (mesh.Model.row(mesh.Triangles(r, (edge + 1) % 3)) -
    mesh.Model.row(mesh.Triangles(r, (edge + 2) % 3)))
                          .norm();
  return (here - there).norm() / length;
}

double maximumSlip(const Shape& mesh, const FlatMap& map, double aside, int count)
{
  Random random(5);
  double largest = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const Index r = random.index(mesh.Triangles.rows());
    const int edge = static_cast<int>(random.index(3));
    // Half of them close to an end, where exponents differ.
    double t = random.uniform();
    t = i % 2 ? t : std::pow(10.0, -8.0 * t);
    largest = std::max(largest, slip(mesh, map, r, edge, t, aside));
  }
  return largest;
}
}

TEST(FlatMap, MeetsAcrossEdgesOfTrianglesOfAnyShape)
{
  for (const double by : { 0.02, 0.06, 0.15 })
  {
    const Shape mesh = randomMesh(by);
    if (by == 0.15)
    {
      EXPECT_LT(minimumAngle(mesh.Model, mesh.Triangles), 1.0);
    }
    const FlatMap map = mesh.map(SeamMode::EdgeMatched);
    EXPECT_LT(maximumSlip(mesh, map, 1e-12, 100000), 1e-9) << by;
    EXPECT_LT(maximumSlip(mesh, map, 0.0, 10000), 1e-13) << by;
  }
}

TEST(FlatMap, PublishedMapsSlip)
{
  const Shape mesh = randomMesh(0.06);
  const FlatMap map = mesh.map(SeamMode::PerTriangle);
  double sum = 0.0, largest = 0.0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    for (const double t : { 0.1, 0.25, 0.5, 0.75, 0.9 })
    {
      const double here = slip(mesh, map, r, 0, t, 1e-12);
      sum += here;
      largest = std::max(largest, here);
    }
  }
  EXPECT_GT(sum / (5.0 * static_cast<double>(mesh.Triangles.rows())), 0.08);
  EXPECT_GT(largest, 0.5);
}

TEST(FlatMap, GoesThereAndBack)
{
  Random random(2);
  for (const double by : { 0.0, 0.06, 0.15 })
  {
    const Shape mesh = randomMesh(by);
    for (const SeamMode mode : { SeamMode::PerTriangle, SeamMode::EdgeMatched })
    {
      const FlatMap map = mesh.map(mode);
      double largest = 0.0;
      for (Index r = 0; r < mesh.Triangles.rows(); ++r)
      {
        FlatMap::Triangle triangle(map, r);
        for (int i = 0; i < 20; ++i)
        {
          const Vector3 l = i % 2 ? randomPoint(random) : randomPointNearBorders(random);
          const Vector3 q = triangle.toModel(l);
          ASSERT_GE(q.minCoeff(), 0.0);
          ASSERT_NEAR(q.sum(), 1.0, 1e-14);
          if (mode == SeamMode::EdgeMatched) // needles crowd beyond the digits of a double else
          {
            largest = std::max(largest, (triangle.toNetwork(q) - l).cwiseAbs().maxCoeff());
          }
        }
      }
      EXPECT_LT(largest, 1e-9) << by;
    }
  }
}

TEST(FlatMap, NeverFolds)
{
  Random random(3);
  for (const double by : { 0.02, 0.06, 0.15 })
  {
    const Shape mesh = randomMesh(by);
    const FlatMap map = mesh.map(SeamMode::EdgeMatched);
    double least = 1.0;
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      FlatMap::Triangle triangle(map, r);
      for (int i = 0; i < 60; ++i)
      {
        Eigen::Matrix3d derivative;
        triangle.toModel(i % 2 ? randomPoint(random) : randomPointNearBorders(random), &derivative);
        least = std::min(least, inPlane(derivative).determinant());
      }
    }
    EXPECT_GT(least, 0.0) << by;
  }
}

TEST(FlatMap, DerivativesAreThoseOfTheMap)
{
  Random random(4);
  const Shape mesh = randomMesh(0.06);
  for (const SeamMode mode : { SeamMode::PerTriangle, SeamMode::EdgeMatched })
  {
    const FlatMap map = mesh.map(mode);
    for (Index r = 0; r < mesh.Triangles.rows(); r += 3)
    {
      FlatMap::Triangle triangle(map, r);
      const Vector3 l = (randomPoint(random) + Vector3::Constant(0.1)) / 1.3;
      Eigen::Matrix3d derivative;
      EXPECT_EQ(triangle.toModel(l, &derivative), triangle.toModel(l));
      for (int k = 0; k < 3; ++k)
      {
        const double h = 1e-5;
        Vector3 step = Vector3::Zero();
        step[k] = h;
        step[(k + 1) % 3] = -h;
        const Vector3 difference =
          (triangle.toModel(l + step) - triangle.toModel(l - step)) / (2.0 * h);
        const Vector3 stated = derivative * step / h;
        // The shape's own scale of change: needles turn fast.
        EXPECT_LT((difference - stated).norm(), 1e-6 * (1.0 + 100.0 * stated.norm())) << r;
      }
    }
  }
}

TEST(FlatMap, CornersStayAndEdgesGoToEdges)
{
  const Shape mesh = randomMesh(0.06);
  const FlatMap map = mesh.map(SeamMode::EdgeMatched);
  for (Index r = 0; r < mesh.Triangles.rows(); r += 7)
  {
    FlatMap::Triangle triangle(map, r);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(triangle.toModel(Vector3::Unit(k)), Vector3(Vector3::Unit(k)));
      Vector3 onEdge = Vector3::Constant(0.3);
      onEdge[k] = 0.0;
      onEdge[(k + 1) % 3] = 0.7;
      EXPECT_EQ(triangle.toModel(onEdge)[k], 0.0);
    }
  }
}

TEST(FlatMap, TheNetworkItselfStays)
{
  Random random(6);
  const Mesh network = makeGeodesicSphere(7);
  const Shape mesh(network.Positions, 3.0 * network.Positions, network.Triangles);
  const FlatMap map = mesh.map(SeamMode::EdgeMatched);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 l = randomPoint(random);
    EXPECT_LT((FlatMap::Triangle(map, r).toModel(l) - l).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(FlatMap, DoesNotDependOnWhereATriangleStarts)
{
  Random random(7);
  const Shape mesh = randomMesh(0.06);
  Triangles turned(mesh.Triangles.rows(), 3);
  turned << mesh.Triangles.col(1), mesh.Triangles.col(2), mesh.Triangles.col(0);
  const Shape other(mesh.Sphere, mesh.Model, turned);
  const FlatMap map = mesh.map(SeamMode::EdgeMatched), otherMap = other.map(SeamMode::EdgeMatched);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 l = randomPoint(random);
    const Vector3 image = FlatMap::Triangle(map, r).toModel(l),
                  otherImage = FlatMap::Triangle(otherMap, r).toModel({ l[1], l[2], l[0] });
    EXPECT_LT((Vector3(otherImage[2], otherImage[0], otherImage[1]) - image).norm(), 1e-12);
  }
}

// What matching costs: on a mesh that is a conformal image of the network the published maps are
// conformal, affine ones are not, and the matched ones should stay near the first.
TEST(FlatMap, StaysNearlyConformalOnAConformalMesh)
{
  const Shape mesh = moebiusMesh(18, 2.0);
  const auto meanDilatation = [&](const FlatMap* map)
  {
    Random random(8);
    double sum = 0.0;
    const int pointsPerTriangle = 10;
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      const auto sides = [&](const Points& points)
      {
        const Vector3 a = points.row(mesh.Triangles(r, 0)), b = points.row(mesh.Triangles(r, 1)),
                      c = points.row(mesh.Triangles(r, 2));
        const Vector3 x = (b - a).normalized(),
                      y = (b - a).cross(c - a).normalized().cross(x).eval();
        Eigen::Matrix2d sides;
        sides << (b - a).dot(x), (c - a).dot(x), (b - a).dot(y), (c - a).dot(y);
        return sides;
      };
      for (int i = 0; i < pointsPerTriangle; ++i)
      {
        Eigen::Matrix3d derivative = Eigen::Matrix3d::Identity();
        const Vector3 l = randomPoint(random);
        if (map)
        {
          FlatMap::Triangle(*map, r).toModel(l, &derivative);
        }
        const Eigen::Matrix2d jacobian =
          sides(mesh.Model) * inPlane(derivative) * sides(mesh.Sphere).inverse();
        const double mean = 0.5 * jacobian.squaredNorm() / jacobian.determinant();
        sum += mean + std::sqrt(std::max(0.0, mean * mean - 1.0));
      }
    }
    return sum / (pointsPerTriangle * static_cast<double>(mesh.Triangles.rows()));
  };
  const FlatMap published = mesh.map(SeamMode::PerTriangle),
                matched = mesh.map(SeamMode::EdgeMatched);
  const double affine = meanDilatation(nullptr) - 1.0;
  EXPECT_LT(meanDilatation(&published) - 1.0, 1e-6);
  EXPECT_GT(affine, 0.01);
  EXPECT_LT(meanDilatation(&matched) - 1.0, 0.3 * affine);
}

TEST(FlatMap, TrianglesWithoutShapeAreMappedAffinely)
{
  const Mesh network = makeGeodesicSphere(4);
  Points model = shaken(network.Positions, 0.05, 1);
  model.row(network.Triangles(10, 1)) = model.row(network.Triangles(10, 0));
  const Shape mesh(network.Positions, model, network.Triangles);
  const Vector3 l(0.2, 0.3, 0.5);
  for (const SeamMode mode : { SeamMode::PerTriangle, SeamMode::EdgeMatched })
  {
    const FlatMap map = mesh.map(mode);
    EXPECT_TRUE(map.degenerate(10));
    EXPECT_FALSE(map.hasArea(10));
    EXPECT_FALSE(map.degenerate(0) && map.degenerate(1));
    FlatMap::Triangle triangle(map, 10);
    const Vector3 q = triangle.toModel(l);
    EXPECT_TRUE(q.allFinite());
    if (mode == SeamMode::PerTriangle)
    {
      EXPECT_EQ(q, l);
    }
    EXPECT_LT((triangle.toNetwork(q) - l).cwiseAbs().maxCoeff(), 1e-12);
  }
}
