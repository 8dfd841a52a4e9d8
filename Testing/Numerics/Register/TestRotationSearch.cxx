#include "Register/RotationSearch.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Rows;
using conformal::SampledSurface;
using conformal::Vector3;

namespace
{
// A function of the direction that no rotation leaves as it is.
double height(const Vector3& n)
{
  return std::exp(2.0 * n[0]) + std::exp(1.5 * (0.6 * n[1] + 0.8 * n[2])) - 0.7 * n[1] * n[2];
}

SampledSurface sampled(int frequency, const Eigen::Matrix3d& rotation)
{
  SampledSurface surface;
  surface.Grid = conformal::SphereGrid(conformal::makeGeodesicSphere(frequency));
  surface.Values.resize(surface.Grid.size(), 4);
  surface.Values.leftCols<3>() = surface.Grid.mesh().Positions;
  for (Index i = 0; i < surface.Grid.size(); ++i)
  {
    surface.Values(i, 3) = height(rotation * surface.Grid.mesh().Positions.row(i).transpose());
  }
  return surface;
}

conformal::RegistrationWeights weightsOf(double feature, double landmarks)
{
  conformal::RegistrationWeights weights;
  weights.Features = { feature };
  weights.Landmarks = landmarks;
  return weights;
}
}

TEST(RotationSearch, FindsAKnownTurn)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.2, Vector3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  // What lies at n on the moving sphere lies at turn * n on the fixed one.
  const auto found = conformal::searchRotations(
    sampled(8, turn), sampled(16, Eigen::Matrix3d::Identity()), {}, weightsOf(1.0, 0.0), 5);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(Eigen::AngleAxisd(Eigen::Matrix3d(found[0].Rotation * turn.transpose())).angle(), 0.02);
  for (std::size_t i = 1; i < found.size(); ++i)
  {
    EXPECT_GE(found[i].Difference, found[i - 1].Difference);
    EXPECT_GT(
      Eigen::AngleAxisd(Eigen::Matrix3d(found[i].Rotation * turn.transpose())).angle(), 0.4);
  }
}

// Landmarks decide between two turns after which the features are equal, and pull the turn to
// themselves where features do not count.
TEST(RotationSearch, LandmarksCount)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.2, Vector3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  const SampledSurface moving = sampled(8, turn), fixed = sampled(16, Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d other =
    Eigen::AngleAxisd(1.0, Vector3(-0.6, 0.2, 0.4).normalized()).toRotationMatrix();
  std::vector<conformal::SpherePair> pairs;
  for (const Vector3& from :
    { Vector3(Vector3::UnitX()), Vector3(0.6, 0.8, 0.0), Vector3(0.0, 0.6, -0.8) })
  {
    pairs.push_back({ from, other * from });
  }
  const auto found = conformal::searchRotations(moving, fixed, pairs, weightsOf(0.0, 1.0), 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT((found[0].Rotation - other).norm(), 1e-6);
  EXPECT_LT(found[0].Difference, 1e-12);
  const auto weak = conformal::searchRotations(moving, fixed, pairs, weightsOf(1.0, 1e-9), 1);
  EXPECT_GT((weak[0].Rotation - other).norm(), 0.1);
}
