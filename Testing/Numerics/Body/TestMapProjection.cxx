#include "Body/MapProjection.h"

#include "Projections.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::halfSizeOfMap;
using conformal::Index;
using conformal::MapProjection;
using conformal::mapToSphere;
using conformal::Pi;
using conformal::Points;
using conformal::sphereToMap;
using conformal::Vector2;
using conformal::Vector3;
using projections::Whole;

namespace
{
// Directions all over the sphere, and those at which formulas are delicate.
Points directions()
{
  Points n = spheres::random(20000);
  const Index size = n.rows();
  const double tiny[] = { 0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3 };
  n.conservativeResize(size + 6 * 8 * 3, 3);
  Index i = size;
  for (const double t : tiny)
  {
    for (int k = 0; k < 8; ++k)
    {
      const double a = 0.25 * Pi * k, c = std::cos(a), s = std::sin(a);
      n.row(i++) << c * std::sin(t), s * std::sin(t), std::cos(t);  // the north pole
      n.row(i++) << c * std::sin(t), s * std::sin(t), -std::cos(t); // the south pole
      n.row(i++) << c * std::cos(t), s * std::cos(t), std::sin(t);  // the equator
    }
  }
  return n;
}

// How a projection stretches: its derivatives towards the east and the north.
void derivatives(const Vector3& n, MapProjection projection, Vector2& east, Vector2& north)
{
  const double h = 1e-6;
  const Vector3 e = Vector3(-n[1], n[0], 0.0).normalized(), u = n.cross(e);
  const auto at = [&](const Vector3& d)
  { return sphereToMap((n + d).normalized(), projection, 0.0); };
  east = (at(h * e) - at(-h * e)) / (2.0 * h);
  north = (at(h * u) - at(-h * u)) / (2.0 * h);
}
}

// All of the sphere is on the map, and comes back.
TEST(MapProjection, ComesBackFromTheMap)
{
  const Points all = directions();
  for (const MapProjection projection : Whole)
  {
    for (const double central : { 0.0, 77.0, -180.0 })
    {
      const Vector2 half = halfSizeOfMap(projection);
      double worst = 0.0;
      for (Index i = 0; i < all.rows(); ++i)
      {
        const Vector3 n = all.row(i);
        const Vector2 place = sphereToMap(n, projection, central);
        ASSERT_TRUE(place.allFinite());
        ASSERT_LE((place.cwiseAbs() - half).maxCoeff(), 1e-13 * half[0]) << n.transpose();
        Vector3 back;
        const Vector2 inside = place.cwiseMax(-half).cwiseMin(half);
        // What lies on the outline may be off it by rounding.
        if (!mapToSphere(inside, projection, central, back))
        {
          ASSERT_TRUE(mapToSphere((1.0 - 1e-13) * inside, projection, central, back))
            << n.transpose();
        }
        worst = std::max(worst, (back - n).norm());
      }
      EXPECT_LT(worst, 1e-9) << static_cast<int>(projection);
    }
  }
}

TEST(MapProjection, KnowsThePolesAndTheCentralMeridian)
{
  const double tolerance = 1e-14, root = std::sqrt(2.0), corner = halfSizeOfMap(Whole[3])[0];
  const Vector3 north(0, 0, 1), south(0, 0, -1), zero(1, 0, 0), east(0, 1, 0);
  EXPECT_LT((sphereToMap(east, Whole[0], 0.0) - Vector2(90, 0)).norm(), 1e-12);
  EXPECT_LT((sphereToMap(east, Whole[0], 90.0) - Vector2(0, 0)).norm(), 1e-12);
  EXPECT_EQ(sphereToMap(north, Whole[0], 0.0)[1], 90.0);
  EXPECT_LT((sphereToMap(north, Whole[1], 0.0) - Vector2(-root, 0)).norm(), tolerance);
  EXPECT_LT((sphereToMap(south, Whole[1], 0.0) - Vector2(root, 0)).norm(), tolerance);
  EXPECT_LT((sphereToMap(zero, Whole[1], 0.0) - Vector2(-root, -root)).norm(), tolerance);
  EXPECT_LT((sphereToMap(east, Whole[1], 0.0) - Vector2(0.0, 0.0)).norm(), tolerance);
  EXPECT_LT(
    (sphereToMap(Vector3(1, 0, -1e-16), Whole[1], 0.0) - Vector2(root, -root)).norm(), 1e-14);
  EXPECT_LT((sphereToMap(north, Whole[2], 0.0) - Vector2(0, root)).norm(), tolerance);
  EXPECT_LT((sphereToMap(east, Whole[2], 0.0) - Vector2(root, 0)).norm(), tolerance);
  EXPECT_LT(sphereToMap(north, Whole[3], 0.0).norm(), tolerance);
  EXPECT_LT((sphereToMap(south, Whole[3], 0.0).cwiseAbs() - Vector2(corner, corner)).norm(), 1e-13);
  EXPECT_LT((sphereToMap(zero, Whole[3], 0.0) - Vector2(0, -corner)).norm(), 1e-7);
  EXPECT_LT((sphereToMap(east, Whole[3], 0.0) - Vector2(corner, 0)).norm(), 1e-7);
  EXPECT_NEAR(corner, 2.62205755429211981, 1e-15); // half of the lemniscate
}

// Lambert's and Mollweide's maps keep areas, Peirce's keeps angles; nothing is mirrored.
TEST(MapProjection, KeepsAreasOrAngles)
{
  const Points all = spheres::random(2000);
  for (Index i = 0; i < all.rows(); ++i)
  {
    const Vector3 n = all.row(i);
    Vector2 east, north;
    const auto area = [&]() { return east[0] * north[1] - east[1] * north[0]; };
    const bool isNearSeam = std::abs(n[2]) < 1e-4 || std::abs(std::atan2(n[1], n[0])) > Pi - 1e-4;
    if (isNearSeam || std::abs(n[2]) > 0.9999)
    {
      continue;
    }
    for (const MapProjection projection :
      { MapProjection::LambertAzimuthal, MapProjection::Mollweide })
    {
      derivatives(n, projection, east, north);
      EXPECT_NEAR(area(), 1.0, 1e-6);
    }
    derivatives(n, MapProjection::Equirectangular, east, north);
    EXPECT_GT(area(), 0.0);
    // In the south Peirce's map is cut along four meridians.
    const double quarter = std::fmod(std::atan2(n[1], n[0]) + Pi, 0.5 * Pi);
    if (n[2] < 0.0 && (quarter < 1e-4 || quarter > 0.5 * Pi - 1e-4))
    {
      continue;
    }
    derivatives(n, MapProjection::PeirceQuincuncial, east, north);
    const double scale = east.squaredNorm();
    EXPECT_GT(area(), 0.0);
    EXPECT_NEAR(north.squaredNorm() / scale, 1.0, 1e-5) << n.transpose();
    EXPECT_NEAR(east.dot(north) / scale, 0.0, 1e-5);
  }
  Vector2 east, north;
  derivatives(Vector3(1e-4, 0, 1).normalized(), MapProjection::PeirceQuincuncial, east, north);
  EXPECT_NEAR(east.norm(), 1.0, 1e-6); // true to scale at the pole
}

// Mercator's map keeps angles up to its edge, where the latitude is atan(sinh(pi)).
TEST(MapProjection, MercatorKeepsAngles)
{
  const Points all = spheres::random(2000);
  const double edge = std::tanh(Pi);
  for (Index i = 0; i < all.rows(); ++i)
  {
    const Vector3 n = all.row(i);
    const Vector2 place = sphereToMap(n, MapProjection::Mercator, 33.0);
    EXPECT_LE(place.cwiseAbs().maxCoeff(), Pi);
    if (std::abs(n[2]) > edge - 1e-4 || std::abs(std::atan2(n[1], n[0])) > Pi - 1e-4)
    {
      continue;
    }
    Vector3 back;
    ASSERT_TRUE(mapToSphere(place, MapProjection::Mercator, 33.0, back));
    EXPECT_LT((back - n).norm(), 1e-13);
    Vector2 east, north;
    derivatives(n, MapProjection::Mercator, east, north);
    const double scale = 1.0 / (1.0 - n[2] * n[2]); // the secant of the latitude, squared
    EXPECT_NEAR(east.squaredNorm() / scale, 1.0, 1e-5);
    EXPECT_NEAR(north.squaredNorm() / scale, 1.0, 1e-5);
    EXPECT_GT(east[0] * north[1] - east[1] * north[0], 0.0);
  }
  EXPECT_EQ(sphereToMap(Vector3(0, 0, 1), MapProjection::Mercator, 0.0)[1], Pi);
}

// The capsule preserves areas, and angles on its cylinder, and comes back from the map.
TEST(MapProjection, CapsulesAreConformalToTheSphere)
{
  const Points all = spheres::random(2000);
  const MapProjection capsule = MapProjection::Capsule;
  for (const double aspect : { 1.0, 1.7, 6.0, 20.0 })
  {
    const Vector2 half = halfSizeOfMap(capsule, aspect);
    EXPECT_NEAR(half[1], aspect - 1.0 + 2.0 * std::sqrt(2.0), 1e-13);
    for (Index i = 0; i < all.rows(); ++i)
    {
      // Positions all over the map, since most of a long capsule is near the poles
      const Vector2 place(half[0] * all(i, 0), half[1] * all(i, 1));
      Vector3 n, right, up;
      const double h = 1e-5;
      if (!mapToSphere(place, capsule, 20.0, n, aspect) ||
        !mapToSphere(place + Vector2(h, 0), capsule, 20.0, right, aspect) ||
        !mapToSphere(place + Vector2(0, h), capsule, 20.0, up, aspect) ||
        std::abs(std::abs(place[1]) - (aspect - 1.0)) < 2.0 * h)
      {
        continue;
      }
      EXPECT_NEAR(n.norm(), 1.0, 1e-15);
      EXPECT_LT((sphereToMap(n, capsule, 20.0, aspect) - place).norm(), 1e-6);
      const Vector3 across = right - n, along = up - n;
      const double scale = conformal::capsuleScale(n, capsule, aspect);
      EXPECT_NEAR(across.cross(along).dot(n) * scale * scale / (h * h), 1.0, 2e-4);
      const double ratio = along.norm() / across.norm();
      if (std::abs(place[1]) < aspect - 1.0)
      {
        EXPECT_NEAR(ratio, 1.0, 1e-4);
        EXPECT_NEAR(across.dot(along) / across.squaredNorm(), 0.0, 1e-4);
      }
      EXPECT_LT(std::max(ratio, 1.0 / ratio), 2.0 + 1e-3);
    }
  }
}

// With the aspect of a sphere, the map is that of Lambert, with the hemispheres one above the
// other.
TEST(MapProjection, TheCapsuleOfASphereIsLambertsMap)
{
  const Points all = spheres::random(500);
  const double root = std::sqrt(2.0);
  for (Index i = 0; i < all.rows(); ++i)
  {
    const Vector3 n = all.row(i);
    const bool isNorth = n[2] > 0.0;
    const Vector2 lambert = sphereToMap(n, MapProjection::LambertAzimuthal, 0.0),
                  fromPole = lambert - Vector2(isNorth ? -root : root, 0.0),
                  upright = isNorth ? fromPole : Vector2(-fromPole);
    const Vector2 expected = upright + Vector2(0.0, isNorth ? root : -root);
    EXPECT_LT((sphereToMap(n, MapProjection::Capsule, 0.0, 1.0) - expected).norm(), 1e-12);
    EXPECT_NEAR(conformal::capsuleScale(n, MapProjection::Capsule, 1.0), 1.0, 1e-12);
  }
  EXPECT_EQ(
    sphereToMap(Vector3(0, 0, 1), MapProjection::Capsule, 0.0, 7.0), Vector2(0, 6.0 + root));
}

TEST(MapProjection, HasNothingBeyondItsOutline)
{
  Vector3 n(7, 7, 7);
  EXPECT_FALSE(mapToSphere({ 181, 0 }, Whole[0], 0.0, n));
  EXPECT_FALSE(mapToSphere({ 0.0, 1.4 }, Whole[1], 0.0, n));
  EXPECT_FALSE(mapToSphere({ 2.5, 1.2 }, Whole[2], 0.0, n));
  EXPECT_FALSE(mapToSphere({ 0.0, 1.5 }, Whole[2], 0.0, n));
  EXPECT_FALSE(mapToSphere({ 2.7, 0.0 }, Whole[3], 0.0, n));
  EXPECT_FALSE(mapToSphere({ 0.0, 3.2 }, MapProjection::Mercator, 0.0, n));
  EXPECT_FALSE(mapToSphere({ 3.2, 0.0 }, MapProjection::Capsule, 0.0, n, 3.0));
  EXPECT_FALSE(mapToSphere({ 1.5, 3.4 }, MapProjection::Capsule, 0.0, n, 3.0));
  EXPECT_FALSE(mapToSphere({ 0.0, 4.9 }, MapProjection::Capsule, 0.0, n, 3.0));
  EXPECT_EQ(n[0], 7.0);
}
