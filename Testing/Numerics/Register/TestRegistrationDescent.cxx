#include "Register/RegistrationDescent.h"

#include "Mesh/GeodesicSphere.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::countFlippedTriangles;
using conformal::descend;
using conformal::DescentOptions;
using conformal::Index;
using conformal::Points;
using conformal::SampledSurface;
using conformal::Vector3;

namespace
{
// An egg of about the unit sphere's area, with two coordinates as features.
SampledSurface egg(int frequency)
{
  SampledSurface surface;
  surface.Grid = conformal::SphereGrid(conformal::makeGeodesicSphere(frequency));
  surface.Values.resize(surface.Grid.size(), 5);
  for (Index i = 0; i < surface.Grid.size(); ++i)
  {
    const Vector3 n = surface.Grid.mesh().Positions.row(i);
    surface.Values.row(i) << 0.8 * n[0], (1.0 + 0.2 * n[2]) * n[1], (1.2 + 0.2 * n[0]) * n[2], n[2],
      n[0];
  }
  return surface;
}

DescentOptions options()
{
  DescentOptions result;
  result.Weights.Features = { 0.3, 0.3 };
  result.Tolerance = 1e-9;
  return result;
}
}

// Equal surfaces are isometric where they lie: nothing moves.
TEST(RegistrationDescent, EqualSurfacesStay)
{
  const SampledSurface surface = egg(8);
  const Points rest = surface.Grid.mesh().Positions;
  Points places = rest;
  const auto energy = descend(surface, surface, {}, options(), places);
  EXPECT_NEAR(energy.Stretch, 1.0, 1e-12);
  EXPECT_NEAR(energy.Features, 0.0, 1e-12);
  EXPECT_LT((places - rest).rowwise().norm().maxCoeff(), 1e-12);
}

// From a deformed start it comes back to where the energy is that of an isometry.
TEST(RegistrationDescent, UndoesADeformation)
{
  const SampledSurface surface = egg(8), fine = egg(16);
  const Points rest = surface.Grid.mesh().Positions;
  Points places = rest;
  for (Index i = 0; i < places.rows(); ++i)
  {
    const Vector3 n = rest.row(i);
    places.row(i) = (n + 0.3 * Vector3(n[1] * n[2], -n[0], 0.4 * n[0] * n[1])).normalized();
  }
  const double before = (places - rest).rowwise().norm().mean();
  DescentOptions none = options();
  none.MaximumNumberOfSteps = 0;
  const auto start = descend(surface, fine, {}, none, places);
  const auto energy = descend(surface, fine, {}, options(), places);
  EXPECT_GT(start.Stretch, 1.03);
  EXPECT_LT(energy.Stretch, 1.01);
  EXPECT_LT((places - rest).rowwise().norm().mean(), 0.2 * before);
  EXPECT_EQ(countFlippedTriangles(places, surface.Grid.mesh().Triangles), 0);
}

// A landmark pulls, and less is left the more it weighs.
TEST(RegistrationDescent, ComesCloserToALandmarkThatWeighsMore)
{
  const SampledSurface surface = egg(8);
  const Vector3 from = Vector3::UnitX(), to = Vector3(1.0, 0.3, 0.0).normalized();
  double before = (from - to).squaredNorm();
  for (const double weight : { 0.1, 1.0, 10.0 })
  {
    DescentOptions heavier = options();
    heavier.Weights.Landmarks = weight;
    Points places = surface.Grid.mesh().Positions;
    const auto energy = descend(surface, surface, { { from, to } }, heavier, places);
    EXPECT_LT(energy.Landmarks, before);
    EXPECT_EQ(countFlippedTriangles(places, surface.Grid.mesh().Triangles), 0);
    before = energy.Landmarks;
  }
  EXPECT_LT(std::sqrt(before), 0.05);
}
