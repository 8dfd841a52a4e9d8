#include "Learn/Fit/Untangling.h"

#include "Mesh/GeodesicSphere.h"
#include "Search/SelfIntersections.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Points;

TEST(Untangling, PullsAPinBack)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(16);
  mesh.Positions.col(2) *= 0.1; // a flat body
  const Points clean = mesh.Positions;
  Index top = 0;
  (mesh.Positions.rowwise() - Eigen::RowVector3d(0.3, 0.2, 0.1)).rowwise().norm().minCoeff(&top);
  mesh.Positions(top, 2) = -0.2;
  ASSERT_FALSE(conformal::selfIntersections(mesh.Positions, mesh.Triangles).empty());
  EXPECT_EQ(conformal::untangle(mesh.Positions, mesh.Triangles), 0);
  EXPECT_TRUE(conformal::selfIntersections(mesh.Positions, mesh.Triangles).empty());
  Index moved = 0;
  for (Index v = 0; v < clean.rows(); ++v)
  {
    moved += (mesh.Positions.row(v) - clean.row(v)).norm() > 1e-12;
  }
  EXPECT_LT(moved, clean.rows() / 10); // only what is near
}

TEST(Untangling, ACleanMeshKeepsItsBits)
{
  const conformal::Mesh mesh = conformal::makeGeodesicSphere(10);
  Points positions = mesh.Positions;
  EXPECT_EQ(conformal::untangle(positions, mesh.Triangles), 0);
  EXPECT_EQ(positions, mesh.Positions);
}

// Two copies of a sphere, one shifted by half its radius, cannot be separated by smoothing a
// little.
TEST(Untangling, WhatRemainsIsCounted)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(6);
  const Index size = sphere.Positions.rows(), faces = sphere.Triangles.rows();
  Points positions(2 * size, 3);
  positions << sphere.Positions, sphere.Positions.rowwise() + Eigen::RowVector3d(0.5, 0.1, 0.2);
  conformal::Triangles triangles(2 * faces, 3);
  triangles << sphere.Triangles, sphere.Triangles.array() + static_cast<int>(size);
  const Index before =
    static_cast<Index>(conformal::selfIntersections(positions, triangles).size());
  const Index after = conformal::untangle(positions, triangles);
  EXPECT_EQ(after, static_cast<Index>(conformal::selfIntersections(positions, triangles).size()));
  EXPECT_LE(after, before);
}
