#include "SphereMap/PuncturedSphereMap.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Sphere/ClosestMoebiusTransform.h"

#include <gtest/gtest.h>

using conformal::choosePuncture;
using conformal::EdgeWeights;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::MoebiusTransform;
using conformal::Points;
using conformal::Vector3;

namespace
{
Vector3 middleOf(const Points& points, const conformal::Triangles& triangles, Index r)
{
  return (points.row(triangles(r, 0)) + points.row(triangles(r, 1)) + points.row(triangles(r, 2))) /
    3.0;
}
}

// Conformal maps of the sphere to itself are Moebius transforms, wherever the puncture is.
TEST(PuncturedSphereMap, OfTheSphereIsAMoebiusTransform)
{
  const Mesh sphere = makeGeodesicSphere(20);
  const EdgeWeights strings =
    conformal::harmonicStrings(sphere.Positions, sphere.Triangles).Strings;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(sphere.Positions.rows());
  for (Index puncture : { 0, 2345, 7999 })
  {
    Points map = conformal::punctureToSphere(sphere.Positions, sphere.Triangles, strings, puncture);
    EXPECT_LT((map.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
    conformal::closestMoebiusTransform(map, sphere.Positions, ones).applyTo(map);
    EXPECT_LT((map - sphere.Positions).rowwise().norm().maxCoeff(), 5e-3) << puncture;
  }
}

TEST(PuncturedSphereMap, IsNotMadeAtTheEndOfALimb)
{
  Mesh mesh = makeGeodesicSphere(20);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    double& z = mesh.Positions(v, 2);
    z = z > 0.9 ? 0.9 + 40.0 * (z - 0.9) : z; // five times as long as it is wide
  }
  EXPECT_LT(
    middleOf(mesh.Positions, mesh.Triangles, choosePuncture(mesh.Positions, mesh.Triangles))[2],
    1.0);
}

TEST(PuncturedSphereMap, IsMadeWhereAMapHasRoom)
{
  const Mesh sphere = makeGeodesicSphere(10);
  MoebiusTransform zoom;
  zoom.Center = { 0.0, 0.8, 0.0 }; // draws all away from here
  Points map = sphere.Positions;
  zoom.applyTo(map);
  const Index puncture = choosePuncture(sphere.Positions, sphere.Triangles, map);
  EXPECT_GT(middleOf(sphere.Positions, sphere.Triangles, puncture)[1], 0.9);
}
