#include "Texture/SphereViewChoice.h"

#include "Mesh/GeodesicSphere.h"
#include "TextureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::chooseSphereView;
using conformal::Index;
using conformal::Points;
using conformal::SphereView;
using conformal::SphereViewOptions;
using conformal::Triangles;
using conformal::Vector3;
using fixtures::egg;
using fixtures::seenFrom;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

// Seen by anyone, the sphere itself shows the image upright, its middle towards him.
TEST(SphereViewChoice, StandsUprightOnTheSphere)
{
  const auto sphere = conformal::makeGeodesicSphere(9);
  const Vector3 views[][2] = { { { 0, 0, 1 }, { 0, 1, 0 } }, { { 0, 0, -5 }, { 0, 1, 0 } },
    { { 1, 0.3, 0 }, { 0, 0, 1e-3 } }, { { -1, 2, 3 }, { 1, 1, 1 } } };
  for (const auto& [direction, up] : views)
  {
    const SphereView view = chooseSphereView(sphere.Positions, sphere.Triangles, sphere.Positions,
      seenFrom<SphereViewOptions>(direction, up));
    const Vector3 pole = direction.normalized(), right = up.cross(direction).normalized();
    EXPECT_LT((view.Pole - pole).norm(), 1e-12);
    EXPECT_LT((view.Right - right).norm(), 2e-2); // the lattice is not symmetric to all views
    EXPECT_LT((view.Up - pole.cross(right)).norm(), 2e-2);
  }
}

TEST(SphereViewChoice, FramesAreOrthonormalAndRightHanded)
{
  const auto sphere = conformal::makeGeodesicSphere(8);
  for (double degrees : { 1.0, 180.0, 340.0 })
  {
    SphereViewOptions options = seenFrom<SphereViewOptions>({ 1, 2, 3 }, { 0, 1, 0 });
    options.FieldOfView = degrees;
    const SphereView view =
      chooseSphereView(egg(sphere.Positions), sphere.Triangles, sphere.Positions, options);
    EXPECT_NEAR(view.Pole.norm(), 1.0, 1e-14);
    EXPECT_NEAR(view.Up.norm(), 1.0, 1e-14);
    EXPECT_LT((view.Right.cross(view.Up) - view.Pole).norm(), 1e-14);
  }
}

// A "C" in space: the line through its centroid in its plane's normal misses it.
TEST(SphereViewChoice, TakesTheFarthestPointWhereTheLineMisses)
{
  const auto sphere = conformal::makeGeodesicSphere(12);
  Points bow(sphere.Positions.rows(), 3);
  for (Index i = 0; i < bow.rows(); ++i)
  {
    const double along = 2.2 * sphere.Positions(i, 0);
    const double radius = 1.0 + 0.2 * sphere.Positions(i, 1);
    bow.row(i) = Vector3(radius * std::sin(along), radius * std::cos(along),
      0.2 * sphere.Positions(i, 2) + 0.1 * along);
  }
  const SphereView view = chooseSphereView(bow, sphere.Triangles, sphere.Positions);
  Index top = 0;
  bow.col(2).maxCoeff(&top);
  EXPECT_LT((view.Pole - Vector3(sphere.Positions.row(top))).norm(), 1e-12);
}

TEST(SphereViewChoice, RefusesViewsThatAreNone)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  const auto choose = [&](const SphereViewOptions& options)
  { return chooseSphereView(sphere.Positions, sphere.Triangles, sphere.Positions, options); };
  EXPECT_THROW(
    choose(seenFrom<SphereViewOptions>({ 0, 0, 0 }, { 0, 1, 0 })), std::invalid_argument);
  EXPECT_THROW(
    choose(seenFrom<SphereViewOptions>({ 0, 0, 1 }, { 0, 0, 0 })), std::invalid_argument);
  EXPECT_THROW(
    choose(seenFrom<SphereViewOptions>({ 0, 0, 1 }, { 0, 0, -2 })), std::invalid_argument);
  EXPECT_THROW(
    choose(seenFrom<SphereViewOptions>({ 0, Infinity, 1 }, { 0, 1, 0 })), std::invalid_argument);
  EXPECT_THROW(choose(seenFrom<SphereViewOptions>({ 0, 0, 1 }, { 0, std::nan(""), 0 })),
    std::invalid_argument);
  SphereViewOptions options;
  for (double degrees : { 0.0, -1.0, 341.0, std::nan("") })
  {
    options.FieldOfView = degrees;
    EXPECT_THROW(choose(options), std::invalid_argument) << degrees;
  }
  options = {};
  options.Rotation = std::nan("");
  EXPECT_THROW(choose(options), std::invalid_argument);
  options = {};
  options.UseViewPoint = true;
  options.ViewPoint = { 0, Infinity, 0 };
  EXPECT_THROW(choose(options), std::invalid_argument);
  EXPECT_THROW(
    chooseSphereView(sphere.Positions, Triangles(0, 3), sphere.Positions), std::invalid_argument);
}

// A scan far from the origin, so that it is flat, and a point that is almost infinitely far away.
TEST(SphereViewChoice, FindsThePointClosestToOneFarAway)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  Points flat = sphere.Positions;
  flat.col(0).setConstant(-1.0);
  SphereViewOptions options;
  options.UseViewPoint = true;
  for (const double far : { 1e30, 1e154, 1e200, 1.7e308 })
  {
    options.ViewPoint = { far, 0.0, 0.0 };
    const SphereView view = chooseSphereView(flat, sphere.Triangles, sphere.Positions, options);
    EXPECT_NEAR(view.Pole.norm(), 1.0, 1e-14) << far;
  }
  for (const double far : { 1e30, 1.7e308 })
  {
    options.ViewPoint = { 0.0, -far, 0.0 };
    const SphereView view =
      chooseSphereView(egg(sphere.Positions), sphere.Triangles, sphere.Positions, options);
    Index lowest = 0;
    egg(sphere.Positions).col(1).minCoeff(&lowest);
    EXPECT_LT((view.Pole - Vector3(sphere.Positions.row(lowest))).norm(), 0.5) << far;
  }
}

// The picked point is the pole whatever ViewDirection says, and who looks at it from outside sees
// the image upright; a surface turned inside out makes no difference.
TEST(SphereViewChoice, TakesAPickedPointAsThePole)
{
  const auto sphere = conformal::makeGeodesicSphere(12);
  const Points model = egg(sphere.Positions);
  Triangles insideOut = sphere.Triangles;
  insideOut.col(1).swap(insideOut.col(2));
  SphereViewOptions options = seenFrom<SphereViewOptions>({ 0, 0, 1 }, { 0, 1, 0 });
  options.UseViewPoint = true;
  for (Index picked : { 5, 40, 333, 900 })
  {
    options.ViewPoint = 1.01 * Vector3(model.row(picked)); // a little off the surface
    const SphereView view = chooseSphereView(model, sphere.Triangles, sphere.Positions, options);
    EXPECT_GT(view.Pole.dot(sphere.Positions.row(picked)), std::cos(0.05));
    EXPECT_GT(view.Up[1], 0.0);
    EXPECT_LT(std::abs(view.Right[1]), 0.15);
    EXPECT_NEAR(view.Right.cross(view.Up).dot(view.Pole), 1.0, 1e-12);
    const SphereView same = chooseSphereView(model, insideOut, sphere.Positions, options);
    EXPECT_LT((same.Up - view.Up).norm(), 1e-9);
    EXPECT_LT((same.Right - view.Right).norm(), 1e-9);
  }
}

TEST(SphereViewChoice, RotatesAsTheViewerSeesIt)
{
  const auto sphere = conformal::makeGeodesicSphere(8);
  SphereViewOptions options = seenFrom<SphereViewOptions>({ 1, 2, 3 }, { 0, 1, 0 });
  const SphereView upright =
    chooseSphereView(egg(sphere.Positions), sphere.Triangles, sphere.Positions, options);
  options.Rotation = 90.0; // counter-clockwise: the image's right edge goes up
  const SphereView turned =
    chooseSphereView(egg(sphere.Positions), sphere.Triangles, sphere.Positions, options);
  EXPECT_LT((turned.Pole - upright.Pole).norm(), 1e-15);
  EXPECT_LT((turned.Right - upright.Up).norm(), 1e-14);
  EXPECT_LT((turned.Up + upright.Right).norm(), 1e-14);
}
