#include "Register/SphericalRegistration.h"

#include "Heads.h"
#include "Runs.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

using conformal::RegisteredSurface;
using conformal::registerSpheres;
using conformal::SpaceOfTransforms;
using conformal::SphericalRegistrationOptions;
using conformal::Vector3;
using heads::head;
using heads::meanAngle;
using heads::twoEnds;
using heads::withWarpedMap;

TEST(SphericalRegistration, EqualSurfacesStay)
{
  const RegisteredSurface surface = head(12);
  const auto result = registerSpheres(surface, surface, {}, {});
  EXPECT_LT(
    (result.SpherePositions - surface.Surface.SpherePositions).rowwise().norm().maxCoeff(), 0.01);
  EXPECT_NEAR(result.Stretch, 1.0, 1e-3);
  EXPECT_NEAR(result.AgreementBefore, 1.0, 1e-9);
  EXPECT_GT(result.AgreementAfter, 0.999);
  EXPECT_EQ(result.NumberOfFolds, 0);
}

// A surface with itself under a known warp of its map.
TEST(SphericalRegistration, FindsAKnownWarp)
{
  const RegisteredSurface fixed = head(20), moving = withWarpedMap(fixed, 1.9);
  ASSERT_EQ(
    conformal::countFlippedTriangles(moving.Surface.SpherePositions, moving.Surface.Triangles), 0);
  SphericalRegistrationOptions options;
  options.Frequency = 32;
  const auto result = registerSpheres(moving, fixed, {}, {}, options);
  EXPECT_LT(meanAngle(result.SpherePositions, fixed.Surface.SpherePositions), 0.5);
  EXPECT_EQ(result.NumberOfFolds, 0);
  EXPECT_LT(result.AgreementBefore, 0.5);
  EXPECT_GT(result.AgreementAfter, 0.99);
}

TEST(SphericalRegistration, ARotationIsFoundWithAndWithoutLandmarks)
{
  const RegisteredSurface fixed = head(12);
  RegisteredSurface moving = fixed;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, Vector3::UnitY()).toRotationMatrix();
  moving.Surface.SpherePositions = (fixed.Surface.SpherePositions * turn.transpose()).eval();
  SphericalRegistrationOptions options;
  for (const auto space : { SpaceOfTransforms::Rotation, SpaceOfTransforms::Moebius })
  {
    options.Space = space;
    const auto free = registerSpheres(moving, fixed, {}, {}, options);
    EXPECT_LT(meanAngle(free.SpherePositions, fixed.Surface.SpherePositions), 0.5);
    const auto held =
      registerSpheres(moving, fixed, { { 0, 0 }, { 5, 5 }, { 300, 300 } }, {}, options);
    EXPECT_LT(meanAngle(held.SpherePositions, fixed.Surface.SpherePositions), 1e-4);
    EXPECT_LT(held.LandmarkError, 1e-5);
  }
}

TEST(SphericalRegistration, LandmarksAreMet)
{
  const RegisteredSurface fixed = head(16), moving = withWarpedMap(head(14), 0.8);
  std::vector<std::pair<int, int>> landmarks;
  for (int i = 0; i < 12; ++i)
  {
    landmarks.emplace_back(i, i); // the icosahedron's, the same in both
  }
  const auto result = registerSpheres(moving, fixed, landmarks, {});
  EXPECT_LT(result.LandmarkError, 1e-6);
  EXPECT_EQ(result.NumberOfUnmetLandmarks, 0);
  EXPECT_EQ(result.NumberOfFolds, 0);
  EXPECT_EQ(conformal::countFlippedTriangles(result.SpherePositions, moving.Surface.Triangles), 0);
}

// Landmarks that would turn a triangle over are left, and nothing folds.
TEST(SphericalRegistration, LandmarksThatFoldAreNotMet)
{
  const RegisteredSurface surface = head(10);
  const auto triangle = surface.Surface.Triangles.row(200);
  const auto result = registerSpheres(surface, surface,
    { { triangle[0], triangle[1] }, { triangle[1], triangle[0] }, { triangle[2], triangle[2] } },
    {});
  EXPECT_GT(result.NumberOfUnmetLandmarks, 0);
  EXPECT_EQ(result.NumberOfFolds, 0);
}

// A landmark in a warped map brings the points around it along, not only itself.
TEST(SphericalRegistration, LandmarksHelpOtherPoints)
{
  const RegisteredSurface fixed = head(14), moving = withWarpedMap(fixed, 0.8);
  SphericalRegistrationOptions options;
  options.ShapeWeight = 0.0;
  double last = 1e9;
  for (const int count : { 2, 6, 12 })
  {
    std::vector<std::pair<int, int>> landmarks;
    for (int i = 0; i < count; ++i)
    {
      landmarks.emplace_back(i, i);
    }
    const auto result = registerSpheres(moving, fixed, landmarks, {}, options);
    const double error = meanAngle(result.SpherePositions, fixed.Surface.SpherePositions);
    EXPECT_LT(error, last) << count;
    last = error;
  }
}

TEST(SphericalRegistration, EqualEndsAreAmbiguousUnlessALandmarkDecides)
{
  const RegisteredSurface surface = twoEnds();
  const auto result = registerSpheres(surface, surface, {}, {});
  ASSERT_TRUE(result.IsAmbiguous);
  ASSERT_EQ(result.Second.size(), 1U);
  conformal::Points turned = surface.Surface.SpherePositions;
  turned.leftCols<2>() *= -1.0;
  const auto& second = result.Second.front();
  const double same = meanAngle(result.SpherePositions, surface.Surface.SpherePositions);
  EXPECT_LT(std::min(same, meanAngle(result.SpherePositions, turned)), 2.0);
  EXPECT_LT(
    meanAngle(second.SpherePositions, same < 2.0 ? turned : surface.Surface.SpherePositions), 2.0);
  EXPECT_EQ(second.NumberOfFolds, 0);
  EXPECT_NEAR(second.AgreementAfter, 1.0, 0.02);
  conformal::Index end = 0;
  surface.Surface.Positions.col(0).maxCoeff(&end);
  const int id = static_cast<int>(end);
  const auto decided = registerSpheres(surface, surface, { { id, id } }, {});
  EXPECT_FALSE(decided.IsAmbiguous);
  EXPECT_LT(meanAngle(decided.SpherePositions, surface.Surface.SpherePositions), 2.0);
  EXPECT_FALSE(registerSpheres(head(12), head(12), {}, {}).IsAmbiguous);
}

TEST(SphericalRegistration, SameBitsOnAnyThreads)
{
  const RegisteredSurface fixed = head(10), moving = withWarpedMap(head(9), 0.5);
  const std::vector<std::pair<int, int>> landmarks = { { 4, 4 }, { 7, 7 } };
  EXPECT_EQ(registerSpheres(moving, fixed, {}, {}).SpherePositions,
    registerSpheres(moving, fixed, {}, {}, {}, runs::backwards()).SpherePositions);
  EXPECT_EQ(registerSpheres(moving, fixed, landmarks, {}).SpherePositions,
    registerSpheres(moving, fixed, landmarks, {}, {}, runs::backwards()).SpherePositions);
}

TEST(SphericalRegistration, ReportsAndStops)
{
  const RegisteredSurface surface = head(8);
  runs::Watch watch;
  registerSpheres(surface, surface, {}, {}, {}, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GT(watch.calls(), 20);
  EXPECT_THROW(
    registerSpheres(surface, surface, {}, {}, {}, runs::stoppingAt(0.5)), conformal::Aborted);
}

TEST(SphericalRegistration, RefusesMapsThatFold)
{
  const RegisteredSurface good = head(8);
  RegisteredSurface bad = good;
  bad.Surface.SpherePositions.row(30) *= -1.0;
  for (const bool isMoving : { true, false })
  {
    try
    {
      registerSpheres(isMoving ? bad : good, isMoving ? good : bad, {}, {});
      FAIL();
    }
    catch (const std::invalid_argument& error)
    {
      const std::string expected =
        isMoving ? "the map of the moving surface" : "the map of the fixed surface";
      EXPECT_EQ(std::string(error.what()).rfind(expected, 0), 0U) << error.what();
    }
  }
}
