#include "Volume/LayerLimits.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"
#include "Runs.h"
#include "Search/SelfIntersections.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::LayerLimits;
using conformal::layerPositions;
using conformal::limitLayers;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
// A sphere of radius 1.
Mesh sphere(int frequency)
{
  return conformal::makeGeodesicSphere(frequency);
}

// A body with two lobes and a deep, narrow groove between them.
Mesh grooved()
{
  Mesh mesh = sphere(24);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 n = mesh.Positions.row(v);
    mesh.Positions.row(v) *= 1.0 - 0.75 * std::exp(-60.0 * n[2] * n[2]);
  }
  return mesh;
}
}

// Inside of a sphere, balls reach the middle. Outside, nothing limits the layers.
TEST(LayerLimits, BallsInASphereReachItsMiddle)
{
  const Mesh mesh = sphere(20);
  const LayerLimits limits = limitLayers(mesh, mesh.Positions, { -5.0, 0.0, 2.0 });
  EXPECT_EQ(limits.NumberOfFaults, 0);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    EXPECT_NEAR(limits.Inward[v], 0.9, 0.01);
    EXPECT_EQ(limits.Outward[v], 2.0);
    EXPECT_EQ(limits.depthAt(v, 3.0), 2.0);
    EXPECT_EQ(limits.depthAt(v, -0.5), -0.5);
  }
}

// In the groove, layers outward end before the other side. Layers do not cross themselves, and, at
// different depths, not each other.
TEST(LayerLimits, LayersOfAGrooveDoNotCross)
{
  const Mesh mesh = grooved();
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const std::vector<double> depths = { -0.2, -0.1, 0.05, 0.15, 0.25 };
  const LayerLimits limits = limitLayers(mesh, normals, depths);
  EXPECT_EQ(limits.NumberOfFaults, 0);
  const double least = *std::min_element(limits.Outward.begin(), limits.Outward.end());
  EXPECT_LT(least, 0.1);
  EXPECT_GT(least, 1e-4);
  const Index size = mesh.Positions.rows(), faces = mesh.Triangles.rows();
  LayerLimits unlimited = limits;
  std::fill(unlimited.Outward.begin(), unlimited.Outward.end(), 1.0);
  EXPECT_FALSE(
    conformal::selfIntersections(layerPositions(mesh, normals, unlimited, 0.25), mesh.Triangles)
      .empty());
  for (const double depth : depths)
  {
    const Points layer = layerPositions(mesh, normals, limits, depth);
    EXPECT_TRUE(conformal::selfIntersections(layer, mesh.Triangles).empty()) << depth;
    // The surface and the layer do not cross each other either.
    Mesh both;
    both.Positions.resize(2 * size, 3);
    both.Positions << mesh.Positions, layer;
    both.Triangles.resize(2 * faces, 3);
    both.Triangles << mesh.Triangles, mesh.Triangles.array() + static_cast<int>(size);
    EXPECT_TRUE(conformal::selfIntersections(both.Positions, both.Triangles).empty()) << depth;
  }
}

TEST(LayerLimits, LimitsOfNeighborsDifferByAtMostTheirDistance)
{
  const Mesh mesh = grooved();
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const LayerLimits limits = limitLayers(mesh, normals, { -0.3, 0.3 });
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const int a = mesh.Triangles(r, 0), b = mesh.Triangles(r, 1);
    const double apart = (mesh.Positions.row(a) - mesh.Positions.row(b)).norm();
    ASSERT_LE(std::abs(limits.Outward[a] - limits.Outward[b]), apart * (1.0 + 1e-12));
    ASSERT_LE(std::abs(limits.Inward[a] - limits.Inward[b]), apart * (1.0 + 1e-12));
  }
}

TEST(LayerLimits, SameBitsOnAnyThreadsAndStops)
{
  const Mesh mesh = grooved();
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const LayerLimits one = limitLayers(mesh, normals, { -0.3, 0.3 }),
                    two = limitLayers(mesh, normals, { -0.3, 0.3 }, runs::backwards());
  EXPECT_EQ(one.Inward, two.Inward);
  EXPECT_EQ(one.Outward, two.Outward);
  EXPECT_THROW(
    limitLayers(mesh, normals, { -0.3, 0.3 }, runs::stoppingAt(0.3)), conformal::Aborted);
  const LayerLimits none = limitLayers(mesh, Points::Zero(mesh.Positions.rows(), 3), { -1.0, 1.0 });
  EXPECT_EQ(*std::max_element(none.Outward.begin(), none.Outward.end()), 0.0);
}
