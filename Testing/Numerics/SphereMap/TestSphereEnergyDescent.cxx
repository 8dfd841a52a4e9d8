#include "SphereMap/SphereEnergyDescent.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/ProgressiveSphereMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

using conformal::BoundedTriangles;
using conformal::descendSphereEnergy;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::SphereEnergyDescentOptions;
using conformal::SphereEnergyMinimum;
using conformal::Vector3;

namespace
{
/// The sphere with a limb along x and a dent.
Mesh pear(int frequency)
{
  Mesh mesh = conformal::makeGeodesicSphere(frequency);
  mesh.Positions = shapes::over(mesh.Positions,
    [](const Vector3& n) -> Vector3
    {
      const double radius = 0.4 + 0.6 * std::exp(-(1.0 - n[0]) / 0.1) - 0.1 * n[1] * n[2];
      return radius * n;
    });
  return mesh;
}

/// Divide each triangle into four, at the middles of its sides.
Mesh divided(const Mesh& mesh)
{
  std::map<std::pair<int, int>, int> middles;
  std::vector<Vector3> positions;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    positions.emplace_back(mesh.Positions.row(v));
  }
  const auto middle = [&](int a, int b)
  {
    const auto [at, isNew] = middles.emplace(std::minmax(a, b), static_cast<int>(positions.size()));
    if (isNew)
    {
      positions.emplace_back(0.5 * (positions[a] + positions[b]));
    }
    return at->second;
  };
  Mesh result;
  result.Triangles.resize(4 * mesh.Triangles.rows(), 3);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const int a = mesh.Triangles(r, 0), b = mesh.Triangles(r, 1), c = mesh.Triangles(r, 2);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.Triangles.middleRows<4>(4 * r) << a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca;
  }
  result.Positions.resize(static_cast<Index>(positions.size()), 3);
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    result.Positions.row(static_cast<Index>(v)) = positions[v];
  }
  return result;
}

SphereEnergyDescentOptions balanced()
{
  SphereEnergyDescentOptions options;
  options.Energy.AreaExponent = 0.0;
  options.Energy.AreaWeight = 0.4;
  options.Tolerance = 1e-9;
  options.MaximumNumberOfSteps = 200;
  return options;
}

/// Mean angle between two maps in degrees, weighted by area, after the best rotation.
double meanDifference(const Mesh& mesh, const Points& one, const Points& other)
{
  const Eigen::VectorXd areas = conformal::vertexAreas(mesh.Positions, mesh.Triangles);
  const Points turned = one * conformal::closestRotation(one, other, areas).transpose();
  double sum = 0.0;
  for (Index v = 0; v < one.rows(); ++v)
  {
    const Vector3 a = turned.row(v), b = other.row(v);
    sum += areas[v] * std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return sum / areas.sum() * 180.0 / conformal::Pi;
}

Points mapped(const Mesh& mesh, conformal::SphereMapFinish finish)
{
  conformal::ProgressiveSphereMapOptions options;
  options.Finish = finish;
  return conformal::mapToSphere(mesh, options).Positions;
}
}

// The sphere is its own best map. From a Moebius transform of it, the descent finds it again.
TEST(SphereEnergyDescent, TheMapOfASphereIsARotation)
{
  const Mesh sphere = conformal::makeGeodesicSphere(12);
  const BoundedTriangles shapes(sphere.Positions, sphere.Triangles);
  Points positions = shapes::over(sphere.Positions,
    [](const Vector3& n) { return Vector3(n[0], n[1], n[2] + 0.6).normalized(); });
  EXPECT_GT(meanDifference(sphere, positions, sphere.Positions), 5.0);
  const SphereEnergyMinimum result =
    descendSphereEnergy(sphere.Triangles, shapes, positions, balanced());
  EXPECT_TRUE(result.Converged);
  EXPECT_LT(result.NumberOfSteps, 60);
  EXPECT_LT(meanDifference(sphere, positions, sphere.Positions), 0.05);
  EXPECT_LT((positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_NEAR(result.Energy, 4.0 * conformal::Pi * 1.4, 0.02 * 4.0 * conformal::Pi);
}

// At the minimum, no vertex gains by a small move. The energy of stars is an independent formula.
TEST(SphereEnergyDescent, TheResultIsAMinimum)
{
  const Mesh mesh = pear(10);
  const BoundedTriangles shapes(mesh.Positions, mesh.Triangles);
  Points positions = mapped(mesh, conformal::SphereMapFinish::Sweeps);
  SphereEnergyDescentOptions options = balanced();
  options.Tolerance = 1e-13;
  ASSERT_TRUE(descendSphereEnergy(mesh.Triangles, shapes, positions, options).Converged);
  EXPECT_EQ(conformal::countFlippedTriangles(positions, mesh.Triangles), 0);
  const conformal::VertexRings rings(mesh.Triangles, mesh.Positions.rows());
  std::vector<Vector3> places;
  for (Index v = 0; v < positions.rows(); ++v)
  {
    places.emplace_back(positions.row(v));
  }
  for (int v = 0; v < static_cast<int>(places.size()); ++v)
  {
    std::vector<conformal::Corner> corners;
    shapes.cornersOf(v, rings[v], corners);
    const auto at = [&](const Vector3& place)
    {
      return conformal::starEnergy(
        places, place, corners.data(), static_cast<int>(corners.size()), options.Energy);
    };
    const Vector3 x = places[v].unitOrthogonal();
    for (const Vector3& side : { x, Vector3(places[v].cross(x)) })
    {
      constexpr double h = 1e-4;
      const double before = at((places[v] - h * side).normalized()),
                   after = at((places[v] + h * side).normalized());
      ASSERT_LT(std::abs(after - before), 1e-2 * (before + after - 2.0 * at(places[v])) + 1e-12);
    }
  }
}

// Sweeps end far from the minimum, at a place that depends on the triangles.
TEST(SphereEnergyDescent, DividedTrianglesHaveTheSameMap)
{
  const Mesh mesh = pear(16), fine = divided(mesh);
  const auto difference = [&](conformal::SphereMapFinish finish)
  {
    return meanDifference(
      mesh, mapped(fine, finish).topRows(mesh.Positions.rows()), mapped(mesh, finish));
  };
  const double minimum = difference(conformal::SphereMapFinish::Minimum),
               sweeps = difference(conformal::SphereMapFinish::Sweeps);
  EXPECT_LT(minimum, 0.25);
  EXPECT_GT(sweeps, 4.0 * minimum);
}

TEST(SphereEnergyDescent, AFoldedMapIsReturnedUnchanged)
{
  const Mesh sphere = conformal::makeGeodesicSphere(6);
  const BoundedTriangles shapes(sphere.Positions, sphere.Triangles);
  Points folded = sphere.Positions;
  folded.row(40) *= -1.0;
  const Points before = folded;
  const SphereEnergyMinimum result =
    descendSphereEnergy(sphere.Triangles, shapes, folded, balanced());
  EXPECT_FALSE(result.Converged);
  EXPECT_EQ(result.NumberOfSteps, 0);
  EXPECT_EQ(folded, before);
}

TEST(SphereEnergyDescent, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const Mesh mesh = pear(20);
  const BoundedTriangles shapes(mesh.Positions, mesh.Triangles);
  const Points start = mapped(mesh, conformal::SphereMapFinish::Sweeps);
  const auto with = [&](const conformal::Run& run)
  {
    Points positions = start;
    descendSphereEnergy(mesh.Triangles, shapes, positions, balanced(), run);
    return positions;
  };
  EXPECT_EQ(with({}), with(runs::backwards()));
  EXPECT_THROW(with(runs::stoppingAt(0.5)), conformal::Aborted);
  runs::Watch watch;
  with(watch.run());
  EXPECT_GT(watch.calls(), 5);
}
