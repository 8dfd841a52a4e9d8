#include "Sphere/ClosestMoebiusTransform.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::MoebiusTransform;
using conformal::Points;
using conformal::Vector3;

namespace
{
MoebiusTransform someTransform()
{
  MoebiusTransform transform;
  transform.Center = { 0.3, -0.5, 0.4 };
  transform.Rotation =
    Eigen::AngleAxisd(2.0, Vector3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  return transform;
}

Points sphere()
{
  return conformal::makeGeodesicSphere(6).Positions;
}

double maximumDistance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}
}

// Small circles' tangents keep their angles: the derivative is a rotation times a number.
TEST(MoebiusTransform, KeepsAnglesAndTheSphere)
{
  const MoebiusTransform transform = someTransform();
  const Points points = sphere();
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = points.row(i), u = x.unitOrthogonal(), v = x.cross(u);
    constexpr double h = 1e-6;
    const Vector3 place = transform(x);
    const auto slope = [&](const Vector3& along) -> Vector3
    {
      return (transform((x + h * along).normalized()) - transform((x - h * along).normalized())) /
        (2.0 * h);
    };
    const Vector3 a = slope(u), b = slope(v);
    EXPECT_NEAR(place.norm(), 1.0, 1e-15);
    EXPECT_NEAR(a.dot(b) / a.squaredNorm(), 0.0, 1e-8);
    EXPECT_NEAR(b.norm() / a.norm(), 1.0, 1e-8);
    EXPECT_GT(place.dot(a.cross(b)), 0.0);
  }
}

TEST(MoebiusTransform, LeavesTheDirectionOfItsCenter)
{
  MoebiusTransform transform;
  transform.Center = { 0.0, 0.0, 0.6 };
  EXPECT_LT((transform(Vector3::UnitZ()) - Vector3::UnitZ()).norm(), 1e-15);
  // In hyperbolic space the plane through the center and across it, which meets the sphere at the
  // height 2 c / (1 + c^2), goes to the equator's.
  const double height = 2.0 * 0.6 / (1.0 + 0.6 * 0.6);
  const Vector3 across(std::sqrt(1.0 - height * height), 0.0, height);
  EXPECT_LT((transform(across) - Vector3::UnitX()).norm(), 1e-14);
}

TEST(MoebiusTransform, CentersWhatAnotherOneHasMoved)
{
  const Points points = sphere();
  conformal::Random random(1);
  Eigen::VectorXd weights(points.rows());
  for (double& weight : weights)
  {
    weight = random.uniform();
  }
  for (double distance : { 0.0, 0.5, 0.99, 0.999999 })
  {
    MoebiusTransform away;
    away.Center = distance * Vector3(1.0, -2.0, 2.0) / 3.0;
    Points moved = points;
    away.applyTo(moved);
    conformal::centeringTransform(moved, weights).applyTo(moved);
    EXPECT_LT((weights.transpose() * moved).norm() / weights.sum(), 1e-9) << distance;
  }
}

// Half of all the weight in one point: there is no center, but no harm either.
TEST(MoebiusTransform, CentersOnePointAsWellAsPossible)
{
  Points points = sphere();
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.rows());
  weights[0] = 10.0 * static_cast<double>(points.rows());
  conformal::centeringTransform(points, weights).applyTo(points);
  EXPECT_TRUE(points.allFinite());
}

TEST(MoebiusTransform, IsFoundFromWhatItDid)
{
  const Points points = sphere();
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.rows());
  Points moved = points;
  someTransform().applyTo(moved);
  Points found = points;
  conformal::closestMoebiusTransform(points, moved, weights).applyTo(found);
  EXPECT_LT(maximumDistance(found, moved), 1e-7);

  Points turned = points;
  MoebiusTransform turn = someTransform();
  turn.Center.setZero();
  turn.applyTo(turned);
  EXPECT_LT((conformal::closestRotation(points, turned, weights) - turn.Rotation).norm(), 1e-12);
}
