#include "SphericalTexture.h"

#include "GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::chooseSphereView;
using conformal::Index;
using conformal::makeSphericalTexture;
using conformal::Points;
using conformal::sphereToTexture;
using conformal::SphereView;
using conformal::SphericalTexture;
using conformal::SphericalTextureOptions;
using conformal::textureToSphere;
using conformal::Triangles;
using conformal::Vector2;
using conformal::Vector3;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Some view that is like no other.
SphereView tiltedView()
{
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.234, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  return { rotation.col(2), rotation.col(1), rotation.col(0) };
}

SphericalTextureOptions seenFrom(const Vector3& direction, const Vector3& up)
{
  SphericalTextureOptions options;
  options.ViewDirection = direction;
  options.ViewUp = up;
  return options;
}

// An egg with a dent: no symmetry a view could profit from.
Points egg(const Points& n)
{
  Points points(n.rows(), 3);
  for (Index i = 0; i < n.rows(); ++i)
  {
    const double x = n(i, 0), y = n(i, 1), z = n(i, 2);
    points.row(i) = Vector3(x * (1.0 + 0.2 * y), 1.4 * y, z * (0.8 + 0.1 * x + 0.1 * y));
  }
  return points;
}
}

TEST(SphericalTexture, KnowsPoleEquatorAndAxes)
{
  const SphereView view = tiltedView();
  EXPECT_TRUE(sphereToTexture(view.Pole, view).isApprox(Vector2(0.5, 0.5), 1e-15));
  EXPECT_TRUE(sphereToTexture(view.Up, view).isApprox(Vector2(0.5, 1.0), 1e-15));
  EXPECT_TRUE(sphereToTexture(view.Right, view).isApprox(Vector2(1.0, 0.5), 1e-15));
  EXPECT_TRUE(sphereToTexture(-view.Right, view).isApprox(Vector2(0.0, 0.5), 1e-15));
  for (double angle = 0.0; angle < 6.0; angle += 0.7)
  {
    const Vector3 equator = std::cos(angle) * view.Right + std::sin(angle) * view.Up;
    EXPECT_NEAR((sphereToTexture(equator, view) - Vector2(0.5, 0.5)).norm(), 0.5, 1e-15);
  }
}

// What lies half the field of view from the pole lies on the inscribed circle.
TEST(SphericalTexture, FieldOfViewSpansTheInscribedCircle)
{
  const SphereView view = tiltedView();
  for (double degrees : { 0.001, 10.0, 90.0, 180.0, 250.0, 340.0 })
  {
    const double theta = 0.5 * degrees * std::acos(-1.0) / 180.0;
    const Vector3 n = std::cos(theta) * view.Pole + std::sin(theta) * view.Up;
    EXPECT_TRUE(sphereToTexture(n, view, degrees).isApprox(Vector2(0.5, 1.0), 1e-10)) << degrees;
  }
}

TEST(SphericalTexture, GoesThereAndBack)
{
  const SphereView view = tiltedView();
  const auto sphere = conformal::makeGeodesicSphere(12);
  for (double degrees : { 20.0, 180.0, 340.0 })
  {
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      const Vector3 n = sphere.Positions.row(i);
      ASSERT_LT(
        (textureToSphere(sphereToTexture(n, view, degrees), view, degrees) - n).norm(), 1e-12);
    }
  }
  // Close to the opposite pole, where 1 + cos(theta) would lose its digits.
  for (double angle : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    const Vector3 n = -std::cos(angle) * view.Pole + std::sin(angle) * view.Up;
    const Vector3 back = textureToSphere(sphereToTexture(n, view), view);
    EXPECT_NEAR(back.dot(view.Up) / angle, 1.0, 1e-3);
    EXPECT_LT((back - n).norm(), 1e-12);
  }
}

TEST(SphericalTexture, OppositePoleIsFarAwayButFinite)
{
  const SphereView view;
  const Vector2 far = sphereToTexture(-view.Pole, view);
  EXPECT_TRUE(far.allFinite());
  EXPECT_GT(far.norm(), 1e50);
  EXPECT_LT((textureToSphere(far, view) + view.Pole).norm(), 1e-90);
}

// Cauchy and Riemann: equal stretches in perpendicular directions, s and t turning like the
// viewer's right and up.
TEST(SphericalTexture, ProjectionIsConformal)
{
  const SphereView view = tiltedView();
  const double h = 1e-5;
  for (double theta : { 0.1, 0.9, 1.7, 2.6 })
  {
    for (double phi : { 0.3, 2.0, 4.5 })
    {
      const Vector3 n = std::cos(theta) * view.Pole +
        std::sin(theta) * (std::cos(phi) * view.Right + std::sin(phi) * view.Up);
      const Vector3 a = n.unitOrthogonal(), b = n.cross(a);
      const auto derivative = [&](const Vector3& along)
      {
        const Vector3 ahead = (n + h * along).normalized(), behind = (n - h * along).normalized();
        return Vector2((sphereToTexture(ahead, view) - sphereToTexture(behind, view)) / (2.0 * h));
      };
      const Vector2 da = derivative(a), db = derivative(b);
      EXPECT_NEAR(da[0], db[1], 1e-8 * da.norm());
      EXPECT_NEAR(da[1], -db[0], 1e-8 * da.norm());
    }
  }
}

// Seen by anyone, the sphere itself shows the image upright, its middle towards him.
TEST(SphericalTexture, StandsUprightOnTheSphere)
{
  const auto sphere = conformal::makeGeodesicSphere(9);
  const Vector3 views[][2] = { { { 0, 0, 1 }, { 0, 1, 0 } }, { { 0, 0, -5 }, { 0, 1, 0 } },
    { { 1, 0.3, 0 }, { 0, 0, 1e-3 } }, { { -1, 2, 3 }, { 1, 1, 1 } } };
  for (const auto& [direction, up] : views)
  {
    const SphereView view =
      chooseSphereView(sphere.Positions, sphere.Faces, sphere.Positions, seenFrom(direction, up));
    const Vector3 pole = direction.normalized(), right = up.cross(direction).normalized();
    EXPECT_LT((view.Pole - pole).norm(), 1e-12);
    EXPECT_LT((view.Right - right).norm(), 2e-2); // the lattice is not symmetric to all views
    EXPECT_LT((view.Up - pole.cross(right)).norm(), 2e-2);
  }
}

TEST(SphericalTexture, FramesAreOrthonormalAndRightHanded)
{
  const auto sphere = conformal::makeGeodesicSphere(8);
  for (double degrees : { 1.0, 180.0, 340.0 })
  {
    SphericalTextureOptions options = seenFrom({ 1, 2, 3 }, { 0, 1, 0 });
    options.FieldOfView = degrees;
    const SphereView view =
      chooseSphereView(egg(sphere.Positions), sphere.Faces, sphere.Positions, options);
    EXPECT_NEAR(view.Pole.norm(), 1.0, 1e-14);
    EXPECT_NEAR(view.Up.norm(), 1.0, 1e-14);
    EXPECT_LT((view.Right.cross(view.Up) - view.Pole).norm(), 1e-14);
  }
}

// Neither turning the model with its viewer nor turning its sphere changes the picture; a mirrored
// sphere does not mirror it.
TEST(SphericalTexture, DoesNotDependOnCoordinates)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  const Points model = egg(sphere.Positions);
  const Vector3 direction(1, 0.4, 2), up(0.1, 1, 0);
  const SphericalTexture texture =
    makeSphericalTexture(model, sphere.Faces, sphere.Positions, seenFrom(direction, up));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.1, Vector3(3, 1, -1).normalized()).toRotationMatrix();

  Points turned = 1e150 * (model * turn.transpose());
  turned.rowwise() += Eigen::RowVector3d(3e150, 0, -1e150);
  const SphericalTexture ofTurned = makeSphericalTexture(
    turned, sphere.Faces, sphere.Positions, seenFrom(turn * direction, turn * up));
  EXPECT_LT((ofTurned.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);

  const Points turnedSphere = sphere.Positions * turn.transpose();
  const SphericalTexture onTurned =
    makeSphericalTexture(model, sphere.Faces, turnedSphere, seenFrom(direction, up));
  EXPECT_LT((onTurned.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);

  Points mirrored = sphere.Positions;
  mirrored.col(1) *= -1.0;
  const SphericalTexture onMirrored =
    makeSphericalTexture(model, sphere.Faces, mirrored, seenFrom(direction, up));
  EXPECT_LT((onMirrored.Coordinates - texture.Coordinates).cwiseAbs().maxCoeff(), 1e-11);
}

// As the viewer sees the model, s grows to the right and t upwards.
TEST(SphericalTexture, IsNotMirroredOnAModel)
{
  const auto sphere = conformal::makeGeodesicSphere(10);
  const Points model = egg(sphere.Positions);
  for (const Vector3& direction : { Vector3(0, 0, 1), Vector3(1, 1, -1), Vector3(-2, 0.5, 0.2) })
  {
    const Vector3 up(0.2, 1, 0.1), right = up.cross(direction).normalized();
    const SphericalTexture texture =
      makeSphericalTexture(model, sphere.Faces, sphere.Positions, seenFrom(direction, up));
    const Vector3 upright = direction.cross(right).normalized();
    double alongRight = 0.0, alongUp = 0.0, across = 0.0;
    for (Index i = 0; i < model.rows(); ++i)
    {
      const Vector2 st = texture.Coordinates.row(i).transpose() - Vector2(0.5, 0.5);
      if (st.norm() < 0.2)
      {
        alongRight += st[0] * right.dot(model.row(i));
        alongUp += st[1] * upright.dot(model.row(i));
        across += st[0] * upright.dot(model.row(i)) - st[1] * right.dot(model.row(i));
      }
    }
    EXPECT_GT(alongRight, 0.0);
    EXPECT_GT(alongUp, 0.0);
    EXPECT_LT(std::abs(across), 0.1 * (alongRight + alongUp));
  }
}

// A lattice point is the opposite pole here.
TEST(SphericalTexture, MasksWhatTheImageDoesNotReach)
{
  const auto sphere = conformal::makeGeodesicSphere(6);
  const SphericalTexture texture =
    makeSphericalTexture(sphere.Positions, sphere.Faces, sphere.Positions);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    const Vector2 st = texture.Coordinates.row(i);
    ASSERT_TRUE(st.allFinite());
    ASSERT_TRUE((st.array() >= 0.0).all() && (st.array() <= 1.0).all());
    const double z = sphere.Positions(i, 2);
    if (z > 1e-9)
    {
      EXPECT_EQ(texture.OutsideImage[i], 0);
    }
    if (z < -1.0 / 3.0 - 1e-9) // beyond the image's corners, |w|^2 = 2
    {
      EXPECT_EQ(texture.OutsideImage[i], 1);
    }
  }
}

// A "C" in space: the line through its centroid in its plane's normal misses it.
TEST(SphericalTexture, TakesTheFarthestPointWhereTheLineMisses)
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
  const SphereView view = chooseSphereView(bow, sphere.Faces, sphere.Positions);
  Index top = 0;
  bow.col(2).maxCoeff(&top);
  EXPECT_LT((view.Pole - Vector3(sphere.Positions.row(top))).norm(), 1e-12);
}

TEST(SphericalTexture, RefusesViewsThatAreNone)
{
  const auto sphere = conformal::makeGeodesicSphere(2);
  const auto choose = [&](const SphericalTextureOptions& options)
  { return chooseSphereView(sphere.Positions, sphere.Faces, sphere.Positions, options); };
  EXPECT_THROW(choose(seenFrom({ 0, 0, 0 }, { 0, 1, 0 })), std::invalid_argument);
  EXPECT_THROW(choose(seenFrom({ 0, 0, 1 }, { 0, 0, 0 })), std::invalid_argument);
  EXPECT_THROW(choose(seenFrom({ 0, 0, 1 }, { 0, 0, -2 })), std::invalid_argument);
  EXPECT_THROW(choose(seenFrom({ 0, Infinity, 1 }, { 0, 1, 0 })), std::invalid_argument);
  EXPECT_THROW(choose(seenFrom({ 0, 0, 1 }, { 0, std::nan(""), 0 })), std::invalid_argument);
  SphericalTextureOptions options;
  for (double degrees : { 0.0, -1.0, 341.0, std::nan("") })
  {
    options.FieldOfView = degrees;
    EXPECT_THROW(choose(options), std::invalid_argument) << degrees;
  }
  EXPECT_THROW(
    chooseSphereView(sphere.Positions, Triangles(0, 3), sphere.Positions), std::invalid_argument);
}

TEST(SphericalTexture, StaysFiniteOnDegenerateModels)
{
  const auto sphere = conformal::makeGeodesicSphere(3);
  const Points point = Points::Ones(sphere.Positions.rows(), 3);
  const Points sheet = sphere.Positions * Vector3(1, 1, 0).asDiagonal();
  const Points line = sphere.Positions * Vector3(0, 0, 1).asDiagonal();
  Points collapsed = sphere.Positions;
  collapsed.rowwise() = Eigen::RowVector3d(0, 0, 1);
  for (const Points& model : { point, sheet, line })
  {
    for (const Points& positions : { sphere.Positions, collapsed })
    {
      const SphericalTexture texture = makeSphericalTexture(model, sphere.Faces, positions);
      EXPECT_TRUE(texture.Coordinates.allFinite());
      EXPECT_NEAR(texture.View.Pole.norm(), 1.0, 1e-12);
      EXPECT_NEAR(texture.View.Up.norm(), 1.0, 1e-12);
    }
  }
}
