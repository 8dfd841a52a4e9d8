#include "Measure/TriangleStretch.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
using Matrix2 = Eigen::Matrix2d;

// Compute 4 a^2 |J|^2, where a is the area of metric g and J the linear map from g to h. The result
// is linear in both metrics.
double mixed(const TriangleMetric& g, const TriangleMetric& h)
{
  return g[0] * h[2] + g[2] * h[0] - 2.0 * g[1] * h[1];
}

template <class Matrix>
Matrix withoutNegative(const Matrix& matrix)
{
  if (Eigen::LLT<Matrix>(matrix).info() == Eigen::Success)
  {
    return matrix;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
    solver.eigenvectors().transpose();
}
}

//------------------------------------------------------------------------------
double areaOf(const TriangleMetric& m)
{
  return 0.5 * std::sqrt(std::max(0.0, m[0] * m[2] - m[1] * m[1]));
}

//------------------------------------------------------------------------------
double triangleStretch(const TriangleMetric& rest, const TriangleMetric& now)
{
  const double a = areaOf(rest), b = areaOf(now);
  const double inverses = 1.0 / (a * a) + 1.0 / (b * b);
  return 0.5 * (a + b) * (0.25 * mixed(rest, now) * inverses - 4.0);
}

//------------------------------------------------------------------------------
TriangleForm triangleStretchForm(const TriangleMetric& rest, const MovingTriangle& now)
{
  const TriangleMetric h = { now.P.squaredNorm(), now.P.dot(now.Q), now.Q.squaredNorm() };
  const double a = areaOf(rest), b = areaOf(h), product = mixed(rest, h);
  const double inverses = 1.0 / (a * a) + 1.0 / (b * b), cube = b * b * b;
  // Derivatives of the energy by the product and by the area b.
  const double byProduct = 0.125 * (a + b) * inverses;
  const double byArea = 0.125 * product * inverses - 2.0 - 0.25 * (a + b) * product / cube;
  const double byBoth = 0.125 * inverses - 0.25 * (a + b) / cube;
  const double byAreaTwice = -0.5 * product / cube + 0.75 * (a + b) * product / (cube * b);
  // Derivatives of the product and of the area b by the entries of h.
  const Vector3 productSlope = { rest[2], -2.0 * rest[1], rest[0] },
                areaSlope = Vector3(h[2], -2.0 * h[1], h[0]) / (8.0 * b);
  Eigen::Matrix3d areaCurve = -areaSlope * areaSlope.transpose() / b;
  areaCurve(0, 2) += 0.125 / b;
  areaCurve(2, 0) += 0.125 / b;
  areaCurve(1, 1) -= 0.25 / b;
  const Vector3 slope = byProduct * productSlope + byArea * areaSlope;
  const Eigen::Matrix3d cross = productSlope * areaSlope.transpose();
  const Eigen::Matrix3d curve = byBoth * (cross + cross.transpose()) +
    byAreaTwice * areaSlope * areaSlope.transpose() + byArea * areaCurve;
  // In the triangle's plane, the edges are p = (length, 0) and q = (along, height).
  const double length = std::sqrt(h[0]);
  const Eigen::Matrix<double, 6, 1> first = now.P / length;
  const double along = now.Q.dot(first);
  const Eigen::Matrix<double, 6, 1> rise = now.Q - along * first;
  const double height = rise.norm();
  const Eigen::Matrix<double, 6, 1> second = rise / height;
  // Derivatives of the entries of h by the coordinates of p and q in the plane.
  Eigen::Matrix<double, 3, 4> entries;
  entries << 2.0 * length, 0.0, 0.0, 0.0, along, height, length, 0.0, 0.0, 0.0, 2.0 * along,
    2.0 * height;
  Matrix2 tension;
  tension << 2.0 * slope[0], slope[1], slope[1], 2.0 * slope[2];
  Eigen::Matrix4d inPlane = entries.transpose() * curve * entries;
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      inPlane.block<2, 2>(2 * i, 2 * j) += tension(i, j) * Matrix2::Identity();
    }
  }
  Eigen::Matrix<double, 4, 6> planar;
  planar.row(0) = first.transpose() * now.PByUnknowns;
  planar.row(1) = second.transpose() * now.PByUnknowns;
  planar.row(2) = first.transpose() * now.QByUnknowns;
  planar.row(3) = second.transpose() * now.QByUnknowns;
  TriangleForm form;
  form.Slope = (entries * planar).transpose() * slope;
  form.Stiffness = planar.transpose() * withoutNegative(inPlane) * planar;
  // For changes perpendicular to the plane, only the tension contributes.
  tension = withoutNegative(tension);
  const std::array<const Eigen::Matrix<double, 6, 6>*, 2> edges = { &now.PByUnknowns,
    &now.QByUnknowns };
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      form.Stiffness += tension(i, j) *
        (edges[i]->transpose() * *edges[j] -
          planar.middleRows<2>(2 * i).transpose() * planar.middleRows<2>(2 * j));
    }
  }
  return form;
}
}
