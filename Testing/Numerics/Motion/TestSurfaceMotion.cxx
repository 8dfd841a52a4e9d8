#include "Motion/SurfaceMotion.h"

#include "Mesh/GeodesicSphere.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::computeMotion;
using conformal::Index;
using conformal::MovingSurface;
using conformal::SurfaceMotion;
using conformal::Vector3;

namespace
{
// Return a sphere whose points move by a function of position and time. The meshes of different
// frequencies do not share points.
template <typename Place>
MovingSurface at(double time, int frequency, Place place)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  MovingSurface moving;
  moving.Time = time;
  moving.Surface.SpherePositions = sphere.Positions;
  moving.Surface.Triangles = sphere.Triangles;
  moving.Surface.Positions =
    shapes::over(sphere.Positions, [&](const Vector3& n) { return place(n, time); });
  return moving;
}

template <typename Place>
SurfaceMotion central(Place place, double step = 0.01)
{
  return computeMotion(at(2.0 - step, 30, place), at(2.0, 24, place), at(2.0 + step, 30, place));
}
}

TEST(SurfaceMotion, GrowthHasTwiceItsRateAsAreaRate)
{
  const auto grows = [](const Vector3& n, double t) -> Vector3 { return std::exp(0.3 * t) * n; };
  const SurfaceMotion motion = central(grows);
  for (std::size_t v = 0; v < motion.Normal.size(); ++v)
  {
    EXPECT_NEAR(motion.AreaRates[v], 0.6, 0.01);
    EXPECT_NEAR(motion.ShearRates[v], 0.0, 0.06);
    EXPECT_NEAR(motion.Normal[v], 0.3 * std::exp(0.6), 0.01);
    EXPECT_LT(motion.Tangential.row(static_cast<Index>(v)).norm(), 0.02);
  }
}

TEST(SurfaceMotion, RatesBelongToTheVelocitiesAtTheEnds)
{
  const auto grows = [](const Vector3& n, double t) -> Vector3 { return (1.0 + 0.1 * t) * n; };
  const MovingSurface first = at(0.0, 12, grows), last = at(6.0, 12, grows);
  for (const bool isFirst : { true, false })
  {
    const MovingSurface& here = isFirst ? first : last;
    const SurfaceMotion motion = computeMotion(first, here, last);
    for (Index v = 0; v < here.Surface.Positions.rows(); ++v)
    {
      EXPECT_NEAR(motion.Velocities.row(v).norm(), 0.1, 1e-12);
      EXPECT_NEAR(motion.AreaRates[v], isFirst ? 0.2 : 0.2 / 1.6, 1e-10);
    }
  }
}

TEST(SurfaceMotion, RigidMotionHasNoStrain)
{
  const auto turns = [](const Vector3& n, double t) -> Vector3
  {
    const Vector3 place(n.x(), 0.7 * n.y(), 0.5 * n.z());
    return Eigen::AngleAxisd(0.4 * t, Vector3::UnitZ()) * place + t * Vector3(1.0, 2.0, 3.0);
  };
  // The same mesh at all times: there is no interpolation error.
  const MovingSurface here = at(2.0, 24, turns);
  const SurfaceMotion motion = computeMotion(at(1.99, 24, turns), here, at(2.01, 24, turns));
  for (Index v = 0; v < here.Surface.Positions.rows(); ++v)
  {
    EXPECT_NEAR(motion.AreaRates[v], 0.0, 1e-10);
    EXPECT_NEAR(motion.ShearRates[v], 0.0, 1e-6);
    const Vector3 fromAxis = Vector3(here.Surface.Positions.row(v)) - 2.0 * Vector3(1.0, 2.0, 3.0);
    const Vector3 expected = 0.4 * Vector3::UnitZ().cross(fromAxis) + Vector3(1.0, 2.0, 3.0);
    EXPECT_LT((Vector3(motion.Velocities.row(v)) - expected).norm(), 1e-5);
  }
}

TEST(SurfaceMotion, StretchOfAPlaneHasItsShearRate)
{
  // Near the poles of z, the surface is a plane that is stretched along x and shrunk along y.
  const auto stretches = [](const Vector3& n, double t) -> Vector3 {
    return { std::exp(0.2 * t) * n.x(), std::exp(-0.2 * t) * n.y(), n.z() };
  };
  const MovingSurface here = at(2.0, 24, stretches);
  const SurfaceMotion motion =
    computeMotion(at(1.99, 24, stretches), here, at(2.01, 24, stretches));
  int count = 0;
  for (Index v = 0; v < here.Surface.Positions.rows(); ++v)
  {
    if (std::abs(here.Surface.SpherePositions(v, 2)) > 0.995)
    {
      EXPECT_NEAR(motion.ShearRates[v], 0.2, 5e-3);
      EXPECT_NEAR(motion.AreaRates[v], 0.0, 5e-3);
      ++count;
    }
  }
  EXPECT_GT(count, 4);
}

TEST(SurfaceMotion, UnevenTimesHaveErrorsOfSecondOrder)
{
  const auto grows = [](const Vector3& n, double t) -> Vector3 { return std::exp(0.3 * t) * n; };
  double before = 0.0;
  for (const double step : { 0.2, 0.1 })
  {
    const SurfaceMotion motion =
      computeMotion(at(2.0 - step, 12, grows), at(2.0, 12, grows), at(2.0 + 3.0 * step, 12, grows));
    const double error = std::abs(motion.AreaRates.front() - 0.6);
    EXPECT_LT(error, 0.3 * step * step);
    EXPECT_TRUE(before == 0.0 || error < 0.3 * before);
    before = error;
  }
}

TEST(SurfaceMotion, NeedsAscendingTimes)
{
  const auto rests = [](const Vector3& n, double) -> Vector3 { return n; };
  const MovingSurface here = at(2.0, 8, rests);
  EXPECT_THROW(computeMotion(here, here, here), std::invalid_argument);
}

TEST(SurfaceMotion, InterpolatesInTime)
{
  const auto grows = [](const Vector3& n, double t) -> Vector3 { return (1.0 + t) * n; };
  const MovingSurface first = at(0.0, 24, grows), second = at(1.0, 24, grows);
  const conformal::Points between =
    conformal::positionsBetween(first.Surface, second.Surface, 0.25);
  EXPECT_LT((between - 1.25 * first.Surface.SpherePositions).rowwise().norm().maxCoeff(), 1e-12);
}
