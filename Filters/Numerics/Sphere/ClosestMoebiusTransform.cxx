#include "Sphere/ClosestMoebiusTransform.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace conformal
{
namespace
{
constexpr int MaximumSteps = 100;

Eigen::Matrix3d rotationBy(const Vector3& vector)
{
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

// Compute the rotation that remains of two steps after one combined step. The two steps move
// `center` to 0, then `step` to 0; the combined one moves `both` to 0.
Eigen::Matrix3d leftRotation(const Vector3& center, const Vector3& step, const Vector3& both)
{
  const MoebiusTransform first = { center }, second = { step }, atOnce = { both };
  Points from(3, 3), to(3, 3);
  for (int k = 0; k < 3; ++k)
  {
    from.row(k) = atOnce(Vector3::Unit(k));
    to.row(k) = second(first(Vector3::Unit(k)));
  }
  return closestRotation(from, to, Eigen::Vector3d::Ones());
}

double squaredDistance(const MoebiusTransform& transform, const Points& from, const Points& to,
  const Eigen::VectorXd& weights)
{
  double sum = 0.0;
  for (Index i = 0; i < from.rows(); ++i)
  {
    sum += weights[i] * (transform(from.row(i)) - to.row(i).transpose()).squaredNorm();
  }
  return sum;
}
}

//------------------------------------------------------------------------------
// Method of Levenberg and Marquardt from the closest rotation, with six unknowns: a small center
// and a small rotation after the current transform.
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run)
{
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  MoebiusTransform best;
  best.Rotation = closestRotation(from, to, weights);
  double minimum = squaredDistance(best, from, to, weights), damping = 1e-3;
  constexpr double maximumDamping = 1e9;
  for (int i = 0; i < MaximumSteps && damping < maximumDamping; ++i)
  {
    // Remaining steps for progress, if no more of them succeeds.
    run.report(i / (i + std::log10(maximumDamping / damping)));
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (Index p = 0; p < from.rows(); ++p)
    {
      const Vector3 x = best.Rotation.transpose() * best(from.row(p));
      const Vector3 rest = best.Rotation.transpose() * to.row(p).transpose() - x;
      Eigen::Matrix<double, 3, 6> slope;
      slope.leftCols<3>() = 2.0 * (x * x.transpose() - Eigen::Matrix3d::Identity());
      slope.rightCols<3>() << 0.0, x[2], -x[1], -x[2], 0.0, x[0], x[1], -x[0], 0.0;
      normal += weights[p] * slope.transpose() * slope;
      right += weights[p] * slope.transpose() * rest;
    }
    normal.diagonal() += damping * Vector6::Constant(normal.trace() / 6.0 + 1e-300);
    const Vector6 step = normal.ldlt().solve(right);
    MoebiusTransform next = best;
    const Vector3 move = insideBall(step.head<3>());
    next.Center = combinedCenter(best.Center, move);
    next.Rotation =
      best.Rotation * rotationBy(step.tail<3>()) * leftRotation(best.Center, move, next.Center);
    const double distance = squaredDistance(next, from, to, weights);
    const bool better = distance < minimum;
    damping *= better ? 0.1 : 10.0;
    if (better)
    {
      best = next;
      minimum = distance;
    }
  }
  return best;
}
}
