/// How far a triangle is stretched or squeezed between two metrics.
/// Symmetric Dirichlet energy of \cite Smith2015.

#ifndef ConformalTriangleStretch_h
#define ConformalTriangleStretch_h

#include "Base/Types.h"

#include <array>

namespace conformal
{
/// A triangle's metric: of two of its edges p and q the products p.p, p.q, q.q.
using TriangleMetric = std::array<double, 3>;

double areaOf(const TriangleMetric& metric);

/// The symmetric Dirichlet energy: (|J|^2 + |J^-1|^2 - 4) (a + b) / 2, where J maps the triangle
/// with the one metric to that with the other one and a, b are their areas; 0 if they are equal,
/// infinite for a triangle without area.
double triangleStretch(const TriangleMetric& rest, const TriangleMetric& now);

/// An energy near a state u = 0: Slope.u + u.Stiffness u / 2. The stiffness has no negative
/// eigenvalue.
struct TriangleForm
{
  Eigen::Matrix<double, 6, 1> Slope;
  Eigen::Matrix<double, 6, 6> Stiffness;
};

/// The two edges of a triangle, in six dimensions, and how they change with six unknowns.
struct MovingTriangle
{
  Eigen::Matrix<double, 6, 1> P, Q;
  Eigen::Matrix<double, 6, 6> PByUnknowns, QByUnknowns;
};

/// The energy of a triangle near where it is, edges that change linearly: its slope, and of its
/// second derivatives what is not negative, within the triangle's plane and across it.
TriangleForm triangleStretchForm(const TriangleMetric& rest, const MovingTriangle& now);
}

#endif
