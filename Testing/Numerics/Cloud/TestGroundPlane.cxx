#include "Cloud/GroundPlane.h"

#include "Base/Random.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using conformal::findGround;
using conformal::Ground;
using conformal::Index;
using conformal::Points;
using conformal::RemoveGround;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
// Random points of a rectangle with a corner and two sides.
Points rectangle(
  const Vector3& corner, const Vector3& u, const Vector3& v, double spacing, unsigned int seed)
{
  conformal::Random random(seed);
  Points points(static_cast<Index>(u.norm() * v.norm() / (spacing * spacing)), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double a = random.uniform(), b = random.uniform();
    points.row(i) = corner + a * u + b * v;
  }
  return points;
}

Points together(const std::vector<Points>& parts)
{
  Points all(0, 3);
  for (const Points& part : parts)
  {
    const Index old = all.rows();
    all.conservativeResize(old + part.rows(), 3);
    all.bottomRows(part.rows()) = part;
  }
  return all;
}

// The six sides of a box.
Points box(const Vector3& low, const Vector3& size, double spacing)
{
  const Vector3 x = size[0] * Vector3::UnitX(), y = size[1] * Vector3::UnitY(),
                z = size[2] * Vector3::UnitZ();
  return together({ rectangle(low, x, y, spacing, 1), rectangle(low + z, x, y, spacing, 2),
    rectangle(low, x, z, spacing, 3), rectangle(low + y, x, z, spacing, 4),
    rectangle(low, y, z, spacing, 5), rectangle(low + x, y, z, spacing, 6) });
}

constexpr double Spacing = 0.02;

Points table(double side)
{
  return rectangle(Vector3(-0.5 * side, -0.5 * side, -1.0), side * Vector3::UnitX(),
    side * Vector3::UnitY(), Spacing, 9);
}

Ground groundOf(const Points& points, RemoveGround mode = RemoveGround::Automatic)
{
  return findGround(TrainingSamples(points), mode);
}

const Points& ball()
{
  static const Points points = sheets::pointsAbove(-1.0, 20000, 4);
  return points;
}
}

TEST(GroundPlane, ABallOnATableIsTheObject)
{
  for (const double side : { 4.0, 8.0 })
  {
    const Points scene = together({ ball(), table(side) });
    const TrainingSamples samples(scene);
    const Ground ground = findGround(samples, RemoveGround::Automatic);
    ASSERT_TRUE(ground.found());
    EXPECT_GT(ground.Normal[2], 0.999);
    Index ofBall = 0, ofTable = 0;
    for (Index i = 0; i < scene.rows(); ++i)
    {
      (i < ball().rows() ? ofBall : ofTable) += ground.hasObjectAt(samples[i]);
    }
    EXPECT_GT(ofBall, ball().rows() * 97 / 100);
    EXPECT_EQ(ofTable, 0);
  }
}

TEST(GroundPlane, OtherObjectsOnTheTableAreLeftOut)
{
  const Points other =
    0.3 * ball() + Points(Eigen::RowVector3d(1.8, 0.0, -0.7).replicate(ball().rows(), 1));
  const Points scene = together({ ball(), table(6.0), other });
  const TrainingSamples samples(scene);
  const Ground ground = findGround(samples, RemoveGround::Automatic);
  ASSERT_TRUE(ground.found());
  for (Index i = scene.rows() - other.rows(); i < scene.rows(); ++i)
  {
    EXPECT_FALSE(ground.hasObjectAt(samples[i]));
  }
}

TEST(GroundPlane, AFlatSideOfAnObjectIsNoGround)
{
  EXPECT_FALSE(groundOf(ball()).found());
  EXPECT_FALSE(groundOf(box(Vector3::Zero(), Vector3(1, 1, 1), Spacing)).found());
  EXPECT_FALSE(groundOf(box(Vector3::Zero(), Vector3(3, 2, 0.2), Spacing)).found());
  // A ball on a plinth.
  EXPECT_FALSE(
    groundOf(together({ ball(), box(Vector3(-1.5, -1.5, -1.4), Vector3(3, 3, 0.4), Spacing) }))
      .found());
  // A relief: a low cap on a plate.
  Points relief = sheets::pointsAbove(0.0, 20000, 3);
  relief.col(2) = 0.2 * relief.col(2).array() - 1.0;
  EXPECT_FALSE(groundOf(together({ relief, table(4.0) })).found());
}

TEST(GroundPlane, ThePlateOfATableIsNoGround)
{
  std::vector<Points> parts = { table(2.0) };
  for (const double x : { -0.8, 0.7 })
  {
    for (const double y : { -0.8, 0.7 })
    {
      parts.push_back(box(Vector3(x, y, -1.0), Vector3(0.1, 0.1, 0.6), Spacing));
    }
  }
  EXPECT_FALSE(groundOf(together(parts)).found());
  parts.resize(2);
  EXPECT_TRUE(groundOf(together(parts)).found()); // a stick on a plate
}

TEST(GroundPlane, OffAndOnAreObeyed)
{
  const Points scene = together({ ball(), table(6.0) });
  EXPECT_FALSE(groundOf(scene, RemoveGround::Off).found());
  EXPECT_TRUE(groundOf(scene, RemoveGround::On).found());
  EXPECT_TRUE(groundOf(box(Vector3::Zero(), Vector3(1, 1, 1), Spacing), RemoveGround::On).found());
}

TEST(GroundPlane, OnNeedsFewerPointsThanAutomatic)
{
  const Points scene = together({ sheets::pointsAbove(-1.0, 150, 4),
    rectangle(Vector3(-3, -3, -1), 6.0 * Vector3::UnitX(), 6.0 * Vector3::UnitY(), 0.4, 9) });
  ASSERT_LT(scene.rows(), 500);
  EXPECT_FALSE(groundOf(scene, RemoveGround::Automatic).found());
  const Ground ground = groundOf(scene, RemoveGround::On);
  ASSERT_TRUE(ground.found());
  EXPECT_GT(ground.Normal[2], 0.98);
}

TEST(GroundPlane, FewOrFlatPointsHaveNoGround)
{
  EXPECT_FALSE(groundOf(Points(0, 3), RemoveGround::On).found());
  EXPECT_FALSE(groundOf(sheets::pointsAbove(-1.0, 40, 3), RemoveGround::On).found());
  EXPECT_FALSE(groundOf(table(2.0), RemoveGround::On).found());
  // Points at few positions.
  Points rounded = 2.0 * sheets::pointsAbove(-1.0, 5000, 3);
  rounded = rounded.array().round();
  EXPECT_NO_THROW(groundOf(rounded));
  EXPECT_NO_THROW(groundOf(rounded, RemoveGround::On));
}
