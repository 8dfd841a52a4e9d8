#include "Texture/SphereProjection.h"

#include "Mesh/GeodesicSphere.h"
#include "TextureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Points;
using conformal::SphereImage;
using conformal::SphereProjection;
using conformal::sphereToTexture;
using conformal::SphereView;
using conformal::textureToSphere;
using conformal::Vector2;
using conformal::Vector3;
using fixtures::AllProjections;

namespace
{
// Some view that is like no other.
SphereView tiltedView()
{
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.234, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  return { rotation.col(2), rotation.col(1), rotation.col(0) };
}

SphereImage imageOf(SphereProjection projection, double fieldOfView = 180.0)
{
  SphereImage image;
  image.Projection = projection;
  image.View = tiltedView();
  image.FieldOfView = fieldOfView;
  return image;
}

SphereImage stereographic(double fieldOfView = 180.0)
{
  return imageOf(SphereProjection::Stereographic, fieldOfView);
}
}

TEST(SphereProjection, KnowsPoleEquatorAndAxes)
{
  const SphereImage image = stereographic();
  const SphereView view = image.View;
  EXPECT_TRUE(sphereToTexture(view.Pole, image).isApprox(Vector2(0.5, 0.5), 1e-15));
  EXPECT_TRUE(sphereToTexture(view.Up, image).isApprox(Vector2(0.5, 1.0), 1e-15));
  EXPECT_TRUE(sphereToTexture(view.Right, image).isApprox(Vector2(1.0, 0.5), 1e-15));
  EXPECT_TRUE(sphereToTexture(-view.Right, image).isApprox(Vector2(0.0, 0.5), 1e-15));
  for (double angle = 0.0; angle < 6.0; angle += 0.7)
  {
    const Vector3 equator = std::cos(angle) * view.Right + std::sin(angle) * view.Up;
    EXPECT_NEAR((sphereToTexture(equator, image) - Vector2(0.5, 0.5)).norm(), 0.5, 1e-15);
  }
}

// What lies half the field of view from the pole lies on the inscribed circle.
TEST(SphereProjection, FieldOfViewSpansTheInscribedCircle)
{
  const SphereImage image = stereographic();
  const SphereView view = image.View;
  for (double degrees : { 0.001, 10.0, 90.0, 180.0, 250.0, 340.0 })
  {
    const double theta = 0.5 * degrees * std::acos(-1.0) / 180.0;
    const Vector3 n = std::cos(theta) * view.Pole + std::sin(theta) * view.Up;
    EXPECT_TRUE(sphereToTexture(n, stereographic(degrees)).isApprox(Vector2(0.5, 1.0), 1e-10))
      << degrees;
  }
}

TEST(SphereProjection, GoesThereAndBack)
{
  const SphereImage image = stereographic();
  const SphereView view = image.View;
  const auto sphere = conformal::makeGeodesicSphere(12);
  for (double degrees : { 20.0, 180.0, 340.0 })
  {
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      const Vector3 n = sphere.Positions.row(i);
      ASSERT_LT(
        (textureToSphere(sphereToTexture(n, stereographic(degrees)), stereographic(degrees)) - n)
          .norm(),
        1e-12);
    }
  }
  // Close to the opposite pole, where 1 + cos(theta) would lose its digits.
  for (double angle : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    const Vector3 n = -std::cos(angle) * view.Pole + std::sin(angle) * view.Up;
    const Vector3 back = textureToSphere(sphereToTexture(n, image), image);
    EXPECT_NEAR(back.dot(view.Up) / angle, 1.0, 1e-3);
    EXPECT_LT((back - n).norm(), 1e-12);
  }
}

TEST(SphereProjection, OppositePoleIsFarAwayButFinite)
{
  const SphereImage image;
  const SphereView view = image.View;
  const Vector2 far = sphereToTexture(-view.Pole, image);
  EXPECT_TRUE(far.allFinite());
  EXPECT_GT(far.norm(), 1e50);
  EXPECT_LT((textureToSphere(far, image) + view.Pole).norm(), 1e-90);
}

// Cauchy and Riemann: equal stretches in perpendicular directions, s and t turning like the
// viewer's right and up.
TEST(SphereProjection, ProjectionIsConformal)
{
  const SphereImage image = stereographic();
  const SphereView view = image.View;
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
        return Vector2(
          (sphereToTexture(ahead, image) - sphereToTexture(behind, image)) / (2.0 * h));
      };
      const Vector2 da = derivative(a), db = derivative(b);
      EXPECT_NEAR(da[0], db[1], 1e-8 * da.norm());
      EXPECT_NEAR(da[1], -db[0], 1e-8 * da.norm());
    }
  }
}

TEST(SphereProjection, KnowsWhereTheSidesAre)
{
  const SphereView view = tiltedView();
  const auto expect = [&](SphereProjection projection, const Vector3& n, double s, double t)
  {
    const Vector2 st = sphereToTexture(n, imageOf(projection));
    EXPECT_NEAR(st[0], s, 1e-12);
    EXPECT_NEAR(st[1], t, 1e-12);
  };
  const SphereProjection map = SphereProjection::LongitudeLatitude;
  expect(map, view.Pole, 0.5, 0.5);
  expect(map, view.Right, 0.75, 0.5);
  expect(map, -view.Right, 0.25, 0.5);
  expect(map, view.Pole + view.Up, 0.5, 0.75);
  const SphereProjection octahedron = SphereProjection::Octahedral;
  expect(octahedron, view.Pole, 0.5, 0.5);
  expect(octahedron, view.Right, 1.0, 0.5);
  expect(octahedron, view.Up, 0.5, 1.0);
  expect(octahedron, view.Right + view.Up - view.Pole, 5.0 / 6.0, 5.0 / 6.0);
  const SphereProjection cube = SphereProjection::CubeMap;
  expect(cube, view.Pole, 0.5, 0.75);
  expect(cube, view.Right, 5.0 / 6.0, 0.75);
  expect(cube, -view.Right, 1.0 / 6.0, 0.75);
  expect(cube, -view.Up, 1.0 / 6.0, 0.25);
  expect(cube, -view.Pole, 0.5, 0.25);
  expect(cube, view.Up, 5.0 / 6.0, 0.25);
  expect(cube, view.Pole + 0.5 * view.Up, 0.5, 0.875);
}

TEST(SphereProjection, EveryProjectionGoesThereAndBack)
{
  const auto sphere = conformal::makeGeodesicSphere(12);
  for (SphereProjection projection : AllProjections)
  {
    SphereImage image = imageOf(projection);
    image.Scale = { 1.25, 0.8 };
    image.Margin = 0.07;
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      const Vector3 n = sphere.Positions.row(i);
      ASSERT_LT((textureToSphere(sphereToTexture(n, image), image) - n).norm(), 1e-11)
        << static_cast<int>(projection);
    }
  }
}

// Seen from outside none is mirrored: s, t and outwards are right-handed.
TEST(SphereProjection, NoneIsMirrored)
{
  const double h = 1e-4;
  for (SphereProjection projection : AllProjections)
  {
    const SphereImage image = imageOf(projection);
    for (double s = 0.013; s < 1.0; s += 0.0713)
    {
      for (double t = 0.017; t < 1.0; t += 0.0591)
      {
        const Vector3 n = textureToSphere({ s, t }, image);
        const Vector3 alongS = textureToSphere({ s + h, t }, image) - n;
        const Vector3 alongT = textureToSphere({ s, t + h }, image) - n;
        ASSERT_GT(alongS.cross(alongT).dot(n), 0.0) << static_cast<int>(projection);
      }
    }
  }
}

// Beyond its seam an image goes on with what lies next to it on the sphere.
TEST(SphereProjection, MarginsGoOnBeyondTheSeam)
{
  for (SphereProjection projection : { SphereProjection::Octahedral, SphereProjection::CubeMap })
  {
    SphereImage image = imageOf(projection);
    image.Margin = 0.1;
    // A path from the middle of a side out over it: no step may jump.
    const Vector2 middle =
      projection == SphereProjection::CubeMap ? Vector2(0.5, 0.75) : Vector2(0.5, 0.5);
    const Vector2 rim =
      projection == SphereProjection::CubeMap ? Vector2(0.55, 0.999) : Vector2(0.6, 0.999);
    Vector3 previous = textureToSphere(middle, image);
    double length = 0.0;
    for (int i = 1; i <= 1000; ++i)
    {
      const Vector3 n = textureToSphere(middle + i / 1000.0 * (rim - middle), image);
      ASSERT_LT((n - previous).norm(), 0.01);
      length += (n - previous).norm();
      previous = n;
    }
    const bool isBeyond = (sphereToTexture(previous, image) - rim).norm() > 0.05;
    EXPECT_TRUE(isBeyond) << "the path ends in the margin";
    EXPECT_GT(length, 0.7);
  }
}

TEST(SphereProjection, PatchesAreWhatTheirBordersSay)
{
  const auto sphere = conformal::makeGeodesicSphere(11);
  for (SphereProjection projection : AllProjections)
  {
    const SphereImage image = imageOf(projection);
    const auto patches = conformal::spherePatches(image);
    std::vector<int> sizes(patches.size(), 0);
    for (Index i = 0; i < sphere.Positions.rows(); ++i)
    {
      const Eigen::Vector4d n = sphere.Positions.row(i).transpose().homogeneous();
      const int own = conformal::patchOf(n.head<3>(), image);
      ++sizes[own];
      for (std::size_t p = 0; p < patches.size(); ++p)
      {
        const double side = (patches[p].Borders * n).minCoeff();
        ASSERT_TRUE(static_cast<int>(p) == own ? side > -1e-12 : side < 1e-12);
      }
    }
    for (int size : sizes)
    {
      EXPECT_GT(size, 0);
    }
  }
}

// A triangle between opposite places of the sphere has points without a direction.
TEST(SphereProjection, HasAPlaceForTheCenter)
{
  for (SphereProjection projection : AllProjections)
  {
    const SphereImage image = imageOf(projection);
    const int count = static_cast<int>(conformal::spherePatches(image).size());
    for (int patch = 0; patch < count; ++patch)
    {
      EXPECT_TRUE(conformal::patchToTexture(Vector3::Zero(), image, patch).allFinite())
        << static_cast<int>(projection) << " " << patch;
    }
  }
}

TEST(SphereProjection, DiskAndSquareShowTheHemisphere)
{
  for (const SphereProjection projection : { SphereProjection::Disk, SphereProjection::Square })
  {
    const SphereImage image = imageOf(projection);
    for (double angle = 0.05; angle < 6.2; angle += 0.3)
    {
      const Vector3 onBorder(std::cos(angle), std::sin(angle), 0.0);
      const Vector2 q = sphereToTexture(onBorder, image) - Vector2(0.5, 0.5);
      const double size = projection == SphereProjection::Disk ? q.norm() : q.cwiseAbs().maxCoeff();
      EXPECT_NEAR(size, 0.5, 1e-12);
      for (const double height : { 0.1, 0.5, 0.95 })
      {
        const double r = std::sqrt(1.0 - height * height);
        const Vector3 n(r * std::cos(angle), r * std::sin(angle), height);
        EXPECT_TRUE(textureToSphere(sphereToTexture(n, image), image).isApprox(n, 1e-12));
        EXPECT_EQ(conformal::patchOf(n, image), 0);
        EXPECT_EQ(conformal::patchOf(-n, image), 1);
      }
    }
    EXPECT_TRUE(sphereToTexture(Vector3::UnitZ(), image).isApprox(Vector2(0.5, 0.5), 1e-12));
    EXPECT_TRUE(conformal::spherePatches(image)[0].InImage);
    EXPECT_FALSE(conformal::spherePatches(image)[1].InImage);
    // The image before the border and beyond it is the same.
    EXPECT_TRUE(
      textureToSphere({ 1.02, 0.5 }, image).isApprox(textureToSphere({ 0.98, 0.5 }, image), 5e-3));
  }
  EXPECT_TRUE(sphereToTexture(Vector3(1, 1, 0), imageOf(SphereProjection::Square))
                .isApprox(Vector2(1.0, 1.0), 1e-7));
}

// Both are conformal: small squares of the image are small squares of the sphere.
TEST(SphereProjection, DiskAndSquareAreConformal)
{
  for (const SphereProjection projection : { SphereProjection::Disk, SphereProjection::Square })
  {
    const SphereImage image = imageOf(projection);
    for (const Vector2& st : { Vector2(0.5, 0.5), Vector2(0.3, 0.62), Vector2(0.7, 0.21) })
    {
      constexpr double step = 1e-5;
      const Vector3 n = textureToSphere(st, image),
                    right = (textureToSphere(st + Vector2(step, 0), image) - n) / step,
                    up = (textureToSphere(st + Vector2(0, step), image) - n) / step;
      EXPECT_NEAR(right.norm() / up.norm(), 1.0, 1e-4);
      EXPECT_NEAR(right.normalized().dot(up.normalized()), 0.0, 1e-4);
      EXPECT_GT(right.cross(up).dot(n), 0.0);
    }
  }
}
