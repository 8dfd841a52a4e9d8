/// Measure how much a triangle is stretched from one shape to another, by the symmetric Dirichlet
/// energy of \cite Smith2015.

#ifndef ConformalTriangleStretch_h
#define ConformalTriangleStretch_h

#include "Base/Types.h"

#include <array>

namespace conformal
{
/// Metric of a triangle: the dot products p.p, p.q and q.q. Here p and q are the edge vectors from
/// the first corner to the second and third corner.
using TriangleMetric = std::array<double, 3>;

/// Compute the area of a triangle from its metric.
double areaOf(const TriangleMetric& metric);

/// Compute the stretch of a triangle between its metric at rest (before the deformation) and its
/// present metric (after the deformation). Let J be the linear map from the rest shape to the
/// present shape, and |J| its Frobenius norm. Let a and b be the areas of both shapes. The stretch
/// is (|J|^2 + |J^-1|^2 - 4) (a + b) / 2. The stretch is 0 for equal metrics, and infinite for a
/// triangle of zero area.
double triangleStretch(const TriangleMetric& rest, const TriangleMetric& now);

/// Quadratic model of an energy for a small change u of six unknowns (see MovingTriangle). The
/// energy changes by Slope^T u + (u^T Stiffness u) / 2. Stiffness is positive semidefinite.
struct TriangleForm
{
  Eigen::Matrix<double, 6, 1> Slope;     ///< gradient of the energy
  Eigen::Matrix<double, 6, 6> Stiffness; ///< approximate Hessian of the energy
};

/// Edge vectors of a triangle with moving corners. Each corner has a position on a surface, and is
/// mapped to a position on the unit sphere. An edge vector therefore has six coordinates: three on
/// the surface, then three on the sphere, multiplied by a factor. The corners move along the
/// sphere. The moves are six unknowns, two for each corner.
struct MovingTriangle
{
  Eigen::Matrix<double, 6, 1> P, Q; ///< edge vectors from the first corner
  /// Derivatives of P and Q by the unknowns, one unknown per column.
  Eigen::Matrix<double, 6, 6> PByUnknowns, QByUnknowns;
};

/// Compute the quadratic model of triangleStretch() for edge vectors that are linear in the
/// unknowns. Negative eigenvalues of the Hessian are removed. The eigenvalues are computed
/// separately for changes in the triangle's plane, and for changes perpendicular to the plane.
TriangleForm triangleStretchForm(const TriangleMetric& rest, const MovingTriangle& now);
}

#endif
