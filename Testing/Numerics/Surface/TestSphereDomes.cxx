#include "Surface/SphereDomes.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

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

namespace
{
// The border of a dome over edge k of triangle r: how far along the edge, and how high.
struct Border
{
  std::vector<double> Along, High;

  Border(const Model& model, Index r, int first, int second)
  {
    const SphereDomes domes = model.domes();
    FlatMap::Triangle map(model.Map, r);
    constexpr int Steps = 400;
    for (int i = 0; i <= Steps; ++i)
    {
      const double t = static_cast<double>(i) / Steps;
      Vector3 place = Vector3::Zero();
      place[first] = 1.0 - t;
      place[second] = t;
      this->Along.push_back(map.toModel(place)[second]);
      this->High.push_back(domes.height(r, place));
    }
  }

  double heightAt(double along) const
  {
    const auto after = std::upper_bound(this->Along.begin(), this->Along.end(), along);
    const auto i = std::clamp<std::ptrdiff_t>(
      after - this->Along.begin(), 1, static_cast<std::ptrdiff_t>(this->Along.size()) - 1);
    const double from = this->Along[i - 1], to = this->Along[i];
    const double t = to > from ? (along - from) / (to - from) : 0.0;
    return (1.0 - t) * this->High[i - 1] + t * this->High[i];
  }
};
}

// The published surface is not seamless: both borders over an edge rise along the mean normal, but
// at other places of it, so that they differ as curves, by much of their height.
TEST(SphereDomes, BordersOfNeighborsDifferAsPublished)
{
  const Model model(4);
  const Triangles& triangles = model.Sphere.Triangles;
  double sum = 0.0, largest = 0.0;
  int edges = 0;
  for (Index r = 0; r < triangles.rows(); r += 7)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const Index other = model.Neighbors(r, k);
      int first = 0, second = 0;
      for (int corner = 0; corner < 3; ++corner)
      {
        first = triangles(other, corner) == triangles(r, k) ? corner : first;
        second = triangles(other, corner) == triangles(r, next) ? corner : second;
      }
      const Border ours(model, r, k, next), theirs(model, other, first, second);
      const double height = *std::max_element(ours.High.begin(), ours.High.end());
      double crack = 0.0;
      for (std::size_t i = 0; i < ours.Along.size(); ++i)
      {
        crack = std::max(crack, std::abs(ours.High[i] - theirs.heightAt(ours.Along[i])) / height);
      }
      sum += crack;
      largest = std::max(largest, crack);
      ++edges;
    }
  }
  RecordProperty("Mean", std::to_string(sum / edges));
  RecordProperty("Largest", std::to_string(largest));
  EXPECT_GT(sum / edges, 0.05);
  EXPECT_LE(largest, 1.0 + 1e-9);
}

// Lemma 3: no two points of a flat triangle have the same point of the dome. With the published
// directions that holds in each subtriangle: along the edge and across it the order of points
// stays.
TEST(SphereDomes, KeepTheOrderOfPointsInASubtriangle)
{
  const Model model(4);
  const SphereDomes domes = model.domes();
  for (Index r = 0; r < model.Sphere.Triangles.rows(); r += 5)
  {
    FlatMap::Triangle map(model.Map, r);
    const auto risen = [&](const Vector3& place)
    {
      const Vector3 flat = map.toModel(place);
      return Vector3(at(model.Positions, model.Sphere.Triangles, r, flat) +
        domes.height(r, place) * domes.direction(r, flat));
    };
    const Vector3 normal = domes.normal(r);
    constexpr double Step = 1e-4;
    for (const Vector3& place :
      { Vector3(0.1, 0.2, 0.7), Vector3(0.6, 0.3, 0.1), Vector3(0.25, 0.5, 0.25) })
    {
      const Vector3 u = risen(place + Step * Vector3(1.0, -1.0, 0.0)) - risen(place);
      const Vector3 v = risen(place + Step * Vector3(0.0, -1.0, 1.0)) - risen(place);
      const Vector3 flatU = at(model.Positions, model.Sphere.Triangles, r,
                      map.toModel(place + Step * Vector3(1.0, -1.0, 0.0)) - map.toModel(place)),
                    flatV = at(model.Positions, model.Sphere.Triangles, r,
                      map.toModel(place + Step * Vector3(0.0, -1.0, 1.0)) - map.toModel(place));
      EXPECT_GT(u.cross(v).dot(normal) * flatU.cross(flatV).dot(normal), 0.0) << r;
    }
  }
}

// The sphere is above its triangles everywhere, so that published domes rise in hollows too, where
// the model's surface lies below its triangles: its volume grows.
TEST(SphereDomes, RiseInHollowsToo)
{
  const Model model(4);
  const SphereDomes domes = model.domes();
  int hollows = 0;
  const Vector3 middle = Vector3::Constant(1.0 / 3.0);
  for (Index r = 0; r < model.Sphere.Triangles.rows(); ++r)
  {
    const Vector3 here = at(model.Positions, model.Sphere.Triangles, r, middle);
    double above = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      above += domes.normal(r).dot(
        at(model.Positions, model.Sphere.Triangles, model.Neighbors(r, k), middle) - here);
    }
    hollows += above > 0.0;
    EXPECT_GT(domes.height(r, middle), 0.0);
  }
  EXPECT_GT(hollows, 5) << "the model has hollows";
}
