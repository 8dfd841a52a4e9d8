#include "Register/RegistrationQuality.h"

#include "Heads.h"
#include "Linear/EdgeWeights.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Points;
using conformal::PreparedSurface;
using heads::head;
using heads::withWarpedMap;

namespace
{
PreparedSurface prepared(const conformal::RegisteredSurface& surface, bool withShape = false)
{
  return { surface, {}, withShape, false, "moving" };
}
}

TEST(RegistrationQuality, ASurfaceWithItselfIsIsometric)
{
  const PreparedSurface surface = prepared(head(12), true);
  const Points& places = surface.mesh().SpherePositions;
  EXPECT_NEAR(conformal::registrationStretch(surface, surface, places, 16), 1.0, 1e-12);
  EXPECT_NEAR(
    conformal::featureAgreement(surface, surface, places, conformal::shapeFeatureWeights()), 1.0,
    1e-12);
}

// The energy is that of the map and of its inverse, so either surface can be the moving one.
TEST(RegistrationQuality, StretchIsSymmetricAndFollowsThePlaces)
{
  const PreparedSurface a = prepared(head(12)), b = prepared(head(12, 1.4)),
                        warped = prepared(withWarpedMap(head(12), 0.0));
  const double there = conformal::registrationStretch(a, b, a.mesh().SpherePositions, 16),
               back = conformal::registrationStretch(b, a, b.mesh().SpherePositions, 16);
  EXPECT_GT(there, 1.01);
  EXPECT_NEAR(there, back, 1e-9);
  const double before =
    conformal::registrationStretch(warped, a, warped.mesh().SpherePositions, 16);
  EXPECT_GT(before, 1.01);
  // The same surface with the map of the other: an isometry, up to the interpolation.
  EXPECT_NEAR(conformal::registrationStretch(warped, a, a.mesh().SpherePositions, 16), 1.0, 1e-6);
}

// A given feature is compared at the vertices: its correlation is computed here again.
TEST(RegistrationQuality, AgreementIsTheCorrelationAtCorrespondingPoints)
{
  conformal::RegisteredSurface surface = head(12);
  surface.Features = surface.Surface.SpherePositions.col(0);
  const PreparedSurface one = prepared(surface);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.5, conformal::Vector3::UnitZ()).toRotationMatrix();
  const Points places = one.mesh().SpherePositions * turn.transpose();
  Eigen::VectorXd areas =
    conformal::vertexAreas(surface.Surface.Positions, surface.Surface.Triangles);
  areas /= areas.sum();
  Eigen::VectorXd x = surface.Surface.SpherePositions.col(0), y = places.col(0);
  x.array() -= areas.dot(x);
  y.array() -= areas.dot(y);
  const double known =
    areas.dot(x.cwiseProduct(y)) / std::sqrt(areas.dot(x.cwiseAbs2()) * areas.dot(y.cwiseAbs2()));
  EXPECT_NEAR(conformal::featureAgreement(one, one, places, { 2.0 }), known, 0.005);
  EXPECT_EQ(conformal::featureAgreement(one, one, places, { 0.0 }), 1.0);
}
