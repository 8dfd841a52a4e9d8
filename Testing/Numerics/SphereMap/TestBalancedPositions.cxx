#include "SphereMap/BalancedPositions.h"

#include "Mesh/GeodesicSphere.h"
#include "Sheets.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

using conformal::balancedPositions;
using conformal::Index;
using conformal::MappedMesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
// Sphere with a limb along z, which is small in the radial map.
MappedMesh makeLimb(int frequency = 40, double length = 4.0)
{
  const auto sphere = conformal::makeGeodesicSphere(frequency);
  MappedMesh mesh;
  mesh.Triangles = sphere.Triangles;
  mesh.SpherePositions = mesh.Positions = sphere.Positions;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const double z = mesh.Positions(v, 2);
    mesh.Positions(v, 2) = z + length * std::pow(std::max(z, 0.0), 12.0);
  }
  return mesh;
}

double area(const Points& points, const conformal::Triangles& triangles, Index i)
{
  const Vector3 a = points.row(triangles(i, 0)), b = points.row(triangles(i, 1)),
                c = points.row(triangles(i, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

// Area of the surface that has less than a third of its share of the sphere, as a fraction.
double starvedShare(const MappedMesh& mesh, const Points& map)
{
  double sum = 0.0, onSphere = 0.0, starved = 0.0;
  for (Index i = 0; i < mesh.Triangles.rows(); ++i)
  {
    sum += area(mesh.Positions, mesh.Triangles, i);
    onSphere += area(map, mesh.Triangles, i);
  }
  for (Index i = 0; i < mesh.Triangles.rows(); ++i)
  {
    const double mine = area(mesh.Positions, mesh.Triangles, i) / sum;
    const double there = area(map, mesh.Triangles, i) / onSphere;
    starved += 3.0 * there < mine ? mine : 0.0;
  }
  return starved;
}
}

TEST(BalancedPositions, GiveLimbsTheirShareWithoutFolds)
{
  const MappedMesh mesh = makeLimb();
  const Points map = balancedPositions(mesh, 0.5);
  EXPECT_GT(starvedShare(mesh, mesh.SpherePositions), 0.1);
  EXPECT_LT(starvedShare(mesh, map), 0.01);
  EXPECT_LT((map.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_EQ(conformal::countFlippedTriangles(map, mesh.Triangles), 0);
}

// Interpolated in the triangles of the samples alone, these maps flip triangles.
TEST(BalancedPositions, FlipNoTriangle)
{
  for (const auto& [frequency, length] :
    { std::pair(80, 4.0), std::pair(40, 20.0), std::pair(80, 20.0) })
  {
    const MappedMesh mesh = makeLimb(frequency, length);
    const Points map = balancedPositions(mesh, 0.5);
    EXPECT_EQ(conformal::countFlippedTriangles(map, mesh.Triangles), 0)
      << frequency << " " << length;
  }
}

// A map that reverses orientation has no other balance.
TEST(BalancedPositions, DoNotDependOnTheOrientationOfTheMap)
{
  MappedMesh mesh = makeLimb();
  const Points map = balancedPositions(mesh, 0.5);
  mesh.SpherePositions.col(0) *= -1.0;
  EXPECT_LT((balancedPositions(mesh, 0.5) - map).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BalancedPositions, RejectMapsThatFold)
{
  MappedMesh mesh = makeLimb();
  mesh.SpherePositions.col(2) = mesh.SpherePositions.col(2).cwiseAbs().eval();
  EXPECT_THROW(balancedPositions(mesh, 0.5), std::invalid_argument);
}

TEST(BalancedPositions, RejectSheets)
{
  for (int rings = 2; rings < 12; ++rings)
  {
    const conformal::Mesh sheet = sheets::cap(rings, 0.5 * conformal::Pi);
    MappedMesh mesh;
    mesh.Triangles = sheet.Triangles;
    mesh.SpherePositions = mesh.Positions = sheet.Positions;
    EXPECT_THROW(balancedPositions(mesh, 0.5), std::invalid_argument) << rings;
  }
}
