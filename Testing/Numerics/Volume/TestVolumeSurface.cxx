#include "Volume/VolumeSurface.h"

#include "Runs.h"
#include "Volumes.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::sampleVolumeSurface;
using conformal::Vector3;
using conformal::VolumeImage;
using conformal::VolumeSurface;
using conformal::VolumeSurfaceOptions;

namespace
{
const Vector3 Spacing(0.5, 0.4, 0.8);

// A ball of radius 8 with a smooth side, off the middle of the image.
const Vector3 Center(0.3, -0.2, 0.1);

VolumeImage ball()
{
  return volumes::of({ 50, 60, 30 }, Spacing,
    [](const Vector3& x) { return 100.0 / (1.0 + std::exp(2.0 * ((x - Center).norm() - 8.0))); });
}

VolumeSurfaceOptions unsmoothed(double level)
{
  VolumeSurfaceOptions options;
  options.Smoothing = 0.0;
  options.UseOtsuLevel = false;
  options.Level = level;
  return options;
}
}

TEST(VolumeSurface, PointsOfABallLieOnItWithNormalsOutward)
{
  const VolumeSurface surface = sampleVolumeSurface(ball(), unsmoothed(50.0));
  ASSERT_GT(surface.Positions.rows(), 4000);
  double farthest = 0.0, mostTilted = 1.0;
  for (Index i = 0; i < surface.Positions.rows(); ++i)
  {
    const Vector3 x = surface.Positions.row(i).transpose() - Center;
    farthest = std::max(farthest, std::abs(x.norm() - 8.0));
    mostTilted = std::min(mostTilted, x.normalized().dot(surface.Normals.row(i)));
  }
  EXPECT_LT(farthest, 0.03); // in the slope, linear interpolation is nearly exact
  EXPECT_GT(mostTilted, 0.995);
  EXPECT_EQ(surface.CutFraction, 0.0);
  EXPECT_EQ(surface.Level, 50.0);
}

TEST(VolumeSurface, DirectionOfTheImageTurnsPointsAndNormals)
{
  VolumeImage turned = ball();
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const Vector3 shift(5.0, -3.0, 2.0);
  turned.Axes = rotation * turned.Axes;
  turned.Origin = rotation * turned.Origin + shift;
  const VolumeSurface one = sampleVolumeSurface(ball(), unsmoothed(50.0)),
                      two = sampleVolumeSurface(turned, unsmoothed(50.0));
  ASSERT_EQ(one.Positions.rows(), two.Positions.rows());
  const conformal::Points moved =
    (one.Positions * rotation.transpose()).rowwise() + shift.transpose();
  EXPECT_LT((moved - two.Positions).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((one.Normals * rotation.transpose() - two.Normals).cwiseAbs().maxCoeff(), 1e-12);
}

// Of a shell, only the outer surface has points, also if the shell has a narrow hole.
TEST(VolumeSurface, ShellsHaveOnlyTheirOuterSide)
{
  const VolumeImage shell = volumes::of({ 50, 50, 50 }, { 1.0, 1.0, 1.0 },
    [](const Vector3& x)
    {
      const bool isHole = x[0] > 0.0 && std::hypot(x[1], x[2]) < 1.5;
      return isHole ? 0.0 : std::exp(-0.125 * std::pow(x.norm() - 18.0, 2));
    });
  const VolumeSurface surface = sampleVolumeSurface(shell, unsmoothed(0.5));
  const double outer = 18.0 + std::sqrt(8.0 * std::log(2.0));
  for (Index i = 0; i < surface.Positions.rows(); ++i)
  {
    const double radius = surface.Positions.row(i).norm();
    ASSERT_TRUE(radius > outer - 1.0 && radius < outer + 0.3) << radius; // less in the hole's mouth
  }
  VolumeSurfaceOptions open = unsmoothed(0.5);
  open.ClosingRadius = 0.0;
  EXPECT_LT(sampleVolumeSurface(shell, open).Positions.rowwise().norm().minCoeff(), 17.0);
}

TEST(VolumeSurface, ObjectsThatTheImageCutsAreClosedAtItsBorder)
{
  const VolumeImage half = volumes::of(
    { 20, 20, 20 }, { 1.0, 1.0, 1.0 }, [](const Vector3& x) { return x[0] > 0.0 ? 1.0 : 0.0; });
  const VolumeSurface surface = sampleVolumeSurface(half, unsmoothed(0.5));
  // A block of 10 x 20 x 20 voxels: the side at x = 0 is not cut, the five others are.
  EXPECT_EQ(surface.Positions.rows(), 2 * 400 + 4 * 200);
  EXPECT_NEAR(surface.CutFraction, 1200.0 / 1600.0, 1e-15);
  EXPECT_NEAR(surface.Positions.colwise().maxCoeff().maxCoeff(), 10.0, 1e-12);
}

TEST(VolumeSurface, StatesWhetherAllValuesExceedTheLevel)
{
  EXPECT_FALSE(sampleVolumeSurface(ball(), unsmoothed(50.0)).ExceedsEverywhere);
  EXPECT_FALSE(sampleVolumeSurface(ball(), unsmoothed(200.0)).ExceedsEverywhere);
  const VolumeSurface all = sampleVolumeSurface(ball(), unsmoothed(-1.0));
  EXPECT_TRUE(all.ExceedsEverywhere);
  EXPECT_EQ(all.Positions.rows(), 0);
}

TEST(VolumeSurface, SameBitsOnAnyThreadsAndStops)
{
  const VolumeSurface one = sampleVolumeSurface(ball()),
                      two = sampleVolumeSurface(ball(), {}, runs::backwards());
  EXPECT_EQ(one.Positions, two.Positions);
  EXPECT_EQ(one.Normals, two.Normals);
  EXPECT_THROW(sampleVolumeSurface(ball(), {}, runs::stoppingAt(0.5)), conformal::Aborted);
  EXPECT_THROW(sampleVolumeSurface({}), std::invalid_argument);
  VolumeImage flat = ball();
  flat.Axes.col(2).setZero();
  EXPECT_THROW(sampleVolumeSurface(flat), std::invalid_argument);
  EXPECT_THROW(sampleVolumeSurface(ball(), unsmoothed(std::nan(""))), std::invalid_argument);
}
