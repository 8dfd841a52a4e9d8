#include "Sphere/MoebiusTransform.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

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

// Back into the ball where a step has left it.
Vector3 inBall(const Vector3& x)
{
  constexpr double farthest = 1.0 - 1e-9;
  const double length = x.norm();
  return length > farthest ? Vector3(farthest / length * x) : x;
}

// The point that goes to `step` after `center` went to 0, that is the center of both in a row.
Vector3 combined(const Vector3& center, const Vector3& step)
{
  const double dot = center.dot(step);
  return inBall(
    ((1.0 + 2.0 * dot + step.squaredNorm()) * center + (1.0 - center.squaredNorm()) * step) /
    (1.0 + 2.0 * dot + center.squaredNorm() * step.squaredNorm()));
}

// What is left of moving `center` to 0 and then `step` to 0, after moving `both` to 0 instead: a
// rotation.
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
Vector3 MoebiusTransform::operator()(const Vector3& x) const
{
  const Vector3 moved = x - this->Center;
  const double scale = (1.0 - this->Center.squaredNorm()) / moved.squaredNorm();
  return (this->Rotation * (scale * moved - this->Center)).normalized();
}

//------------------------------------------------------------------------------
void MoebiusTransform::applyTo(Points& spherePositions) const
{
  for (Index i = 0; i < spherePositions.rows(); ++i)
  {
    spherePositions.row(i) = (*this)(spherePositions.row(i));
  }
}

//------------------------------------------------------------------------------
Eigen::Matrix3d closestRotation(
  const Points& from, const Points& to, const Eigen::VectorXd& weights)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (Index i = 0; i < from.rows(); ++i)
  {
    sum += weights[i] * to.row(i).transpose() * from.row(i);
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d, Eigen::NoQRPreconditioner> svd(
    sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3 signs(1.0, 1.0, 1.0);
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

//------------------------------------------------------------------------------
// Newton's method: near 0 a center c moves x by 2 (x.c) x - 2 c.
MoebiusTransform centeringTransform(const Points& spherePositions, const Eigen::VectorXd& weights)
{
  const double total = weights.sum();
  MoebiusTransform transform, best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < MaximumSteps; ++i)
  {
    Vector3 mean = Vector3::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (Index v = 0; v < spherePositions.rows(); ++v)
    {
      const Vector3 x = transform(spherePositions.row(v));
      mean += weights[v] * x;
      squares += weights[v] * x * x.transpose();
    }
    mean /= total;
    if (!(mean.norm() < least))
    {
      break; // as good as rounding lets it be
    }
    least = mean.norm();
    best = transform;
    const Eigen::Matrix3d slope =
      2.0 * ((1.0 + 1e-9) * Eigen::Matrix3d::Identity() - squares / total);
    const Vector3 step = slope.ldlt().solve(mean);
    constexpr double longest = 0.5;
    transform.Center =
      combined(transform.Center, step * std::min(1.0, longest / std::max(step.norm(), longest)));
  }
  return best;
}

//------------------------------------------------------------------------------
// Levenberg's and Marquardt's method from the closest rotation; six unknowns: a small center and a
// small rotation after the transform so far.
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run)
{
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  MoebiusTransform best;
  best.Rotation = closestRotation(from, to, weights);
  double least = squaredDistance(best, from, to, weights), damping = 1e-3;
  constexpr double maximumDamping = 1e9;
  for (int i = 0; i < MaximumSteps && damping < maximumDamping; ++i)
  {
    // As many steps as are left if no more of them succeeds.
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
    const Vector3 move = inBall(step.head<3>());
    next.Center = combined(best.Center, move);
    next.Rotation =
      best.Rotation * rotationBy(step.tail<3>()) * leftRotation(best.Center, move, next.Center);
    const double distance = squaredDistance(next, from, to, weights);
    const bool better = distance < least;
    damping *= better ? 0.1 : 10.0;
    if (better)
    {
      best = next;
      least = distance;
    }
  }
  return best;
}
}
