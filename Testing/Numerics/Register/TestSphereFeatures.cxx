#include "Register/SphereFeatures.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Pi;
using conformal::Rows;

// On a sphere of radius 1 the mean distance is pi / 2, over the area's root sqrt(4 pi).
TEST(SphereFeatures, TheMeanDistanceOnASphereIsKnown)
{
  const Rows features = conformal::geodesicFeatures(conformal::makeGeodesicSphere(12));
  const double known = std::log(0.5 * Pi / std::sqrt(4.0 * Pi));
  EXPECT_NEAR(features.col(0).mean(), known, 0.04); // ways along edges are a little longer
  EXPECT_LT(features.col(0).maxCoeff() - features.col(0).minCoeff(), 0.1);
}

// Features do not depend on where a surface lies or on its size; they are largest at its ends.
TEST(SphereFeatures, MovingAndScalingChangesNothing)
{
  auto mesh = conformal::makeGeodesicSphere(10);
  mesh.Positions.col(2) *= 3.0;
  const Rows features = conformal::geodesicFeatures(mesh);
  Index farthest = 0;
  features.col(0).maxCoeff(&farthest);
  EXPECT_GT(std::abs(mesh.Positions(farthest, 2)), 2.9);
  const Eigen::VectorXd curvature = conformal::smoothMeanCurvature(mesh, 0.1);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, conformal::Vector3(1, 2, 3).normalized()).toRotationMatrix();
  mesh.Positions = (4.0 * mesh.Positions * turn.transpose()).eval();
  mesh.Positions.rowwise() += Eigen::RowVector3d(5.0, -6.0, 7.0);
  // Distances are of single precision.
  EXPECT_LT((conformal::geodesicFeatures(mesh) - features).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((conformal::smoothMeanCurvature(mesh, 0.1) - curvature).cwiseAbs().maxCoeff(), 1e-9);
}

// 1 / radius, times the root of the area.
TEST(SphereFeatures, TheMeanCurvatureOfASphereIsKnown)
{
  auto mesh = conformal::makeGeodesicSphere(16);
  const Eigen::VectorXd curvature = conformal::smoothMeanCurvature(mesh, 0.1);
  EXPECT_NEAR(curvature.minCoeff(), std::sqrt(4.0 * Pi), 0.03);
  EXPECT_NEAR(curvature.maxCoeff(), std::sqrt(4.0 * Pi), 0.03);
}

TEST(SphereFeatures, NormalizedOnesHaveMeanZeroAndVarianceOne)
{
  Rows features(4, 2);
  features << 1.0, 7.0, 2.0, 7.0, 5.0, 7.0, 9.0, 7.0;
  const Eigen::Vector4d weights(1.0, 2.0, 1.0, 0.5);
  conformal::normalizeFeatures(features, weights);
  EXPECT_NEAR(weights.dot(features.col(0)), 0.0, 1e-14);
  EXPECT_NEAR(weights.dot(features.col(0).cwiseAbs2()) / weights.sum(), 1.0, 1e-14);
  EXPECT_TRUE(features.col(1).isZero()); // says nothing
}

// On a long body, proximities to its two ends have the sum 1 before scaling, are equal halfway, and
// do not depend on the size.
TEST(SphereFeatures, ProximitiesToLandmarksAreRatios)
{
  auto mesh = conformal::makeGeodesicSphere(16);
  mesh.Positions.col(2) *= 4.0;
  conformal::Points ends(2, 3);
  ends << 0.0, 0.0, 4.0, 0.0, 0.0, -4.0;
  const Rows proximities = conformal::landmarkProximities(mesh, ends);
  const Eigen::VectorXd sums = proximities.rowwise().sum();
  EXPECT_LT(sums.maxCoeff() - sums.minCoeff(), 1e-9);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    if (std::abs(mesh.Positions(v, 2)) < 1e-9)
    {
      EXPECT_NEAR(proximities(v, 0) / sums[v], 0.5, 0.02);
    }
    if (mesh.Positions(v, 2) > 1.0)
    {
      EXPECT_GT(proximities(v, 0), proximities(v, 1));
    }
  }
  mesh.Positions *= 3.0;
  EXPECT_LT(
    (conformal::landmarkProximities(mesh, 3.0 * ends) - proximities).cwiseAbs().maxCoeff(), 1e-4);
}
