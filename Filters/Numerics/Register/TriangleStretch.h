/// Compute the stretch of a triangle between two metrics, by the symmetric Dirichlet energy of
/// \cite Smith2015.

#ifndef ConformalTriangleStretch_h
#define ConformalTriangleStretch_h

#include "Base/Types.h"

#include <array>

namespace conformal
{
/// Metric of a triangle with edge vectors p and q, stored as the products p.p, p.q and q.q.
using TriangleMetric = std::array<double, 3>;

double areaOf(const TriangleMetric& metric);

/// Compute the symmetric Dirichlet energy: (|J|^2 + |J^-1|^2 - 4) (a + b) / 2, where J maps the
/// triangle of one metric to that of the other, and a, b are their areas. The energy is 0 for equal
/// metrics, and infinite for a triangle of zero area.
double triangleStretch(const TriangleMetric& rest, const TriangleMetric& now);

/// Quadratic model of an energy at a state u = 0: Slope.u + u.Stiffness u / 2. The stiffness is
/// positive semidefinite.
struct TriangleForm
{
  Eigen::Matrix<double, 6, 1> Slope;
  Eigen::Matrix<double, 6, 6> Stiffness;
};

/// Two edge vectors of a triangle in six dimensions, and their derivatives by six unknowns.
struct MovingTriangle
{
  Eigen::Matrix<double, 6, 1> P, Q;
  Eigen::Matrix<double, 6, 6> PByUnknowns, QByUnknowns;
};

/// Compute the quadratic model of a triangle's energy for edges that change linearly: the gradient,
/// and the positive semidefinite part of the Hessian within the triangle's plane and across it.
TriangleForm triangleStretchForm(const TriangleMetric& rest, const MovingTriangle& now);
}

#endif
