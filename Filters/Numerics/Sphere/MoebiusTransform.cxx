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
constexpr int CenteringSteps = 100;
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
Vector3 insideBall(const Vector3& x)
{
  constexpr double farthest = 1.0 - 1e-9;
  const double length = x.norm();
  return length > farthest ? Vector3(farthest / length * x) : x;
}

//------------------------------------------------------------------------------
Vector3 combinedCenter(const Vector3& center, const Vector3& step)
{
  const double dot = center.dot(step);
  return insideBall(
    ((1.0 + 2.0 * dot + step.squaredNorm()) * center + (1.0 - center.squaredNorm()) * step) /
    (1.0 + 2.0 * dot + center.squaredNorm() * step.squaredNorm()));
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
  double minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i < CenteringSteps; ++i)
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
    if (!(mean.norm() < minimum))
    {
      break; // at the limit of rounding
    }
    minimum = mean.norm();
    best = transform;
    const Eigen::Matrix3d slope =
      2.0 * ((1.0 + 1e-9) * Eigen::Matrix3d::Identity() - squares / total);
    const Vector3 step = slope.ldlt().solve(mean);
    constexpr double longest = 0.5;
    transform.Center = combinedCenter(
      transform.Center, step * std::min(1.0, longest / std::max(step.norm(), longest)));
  }
  return best;
}

}
