/// Conformal maps between triangles, vertices to vertices, \cite Liou2008 Eqs. 4 and 5.
///
/// A point is mapped through a half disk common to all triangles: any triangle -> half disk -> any
/// other. Input and output are barycentric coordinates, so that no plane has to be chosen.
///
/// Implementation note: the paper integrates over the whole unit disk. Three prevertices may lie
/// anywhere on its border. The disk is therefore replaced by a conformal image: the upper half of
/// the unit disk, |s| <= 1, Im s >= 0. One corner of the triangle is at s = 0, the next at 1, the
/// previous at -1. The opposite edge is the half circle. With the angles a, b, c of these corners
/// in units of pi, Eqs. 4 and 5 become
///     dz/ds = k 4^a s^(a-1) (1-s)^(2b-1) (1+s)^(2c-1),   k = pi D / (Gamma(a) Gamma(b) Gamma(c)),
/// with D the diameter of the circumcircle. The factor 1 + s^2 cancels since a + b + c = 1. No
/// parameter has to be solved for, and all coefficients are real. Every point has |s| <= 2 -
/// sqrt(3) at one of the three corners or more. There 30 terms of a power series give full double
/// precision, for any shape of the triangle.

#ifndef ConformalSchwarzChristoffel_h
#define ConformalSchwarzChristoffel_h

#include "Base/Types.h"

#include <array>
#include <complex>

namespace conformal
{
/// Point of the half disk in the coordinate s of one corner of the triangle.
struct HalfDiskPoint
{
  int Corner = 0;            ///< corner at s = 0; the next corner is at 1, the previous at -1
  std::complex<double> S;    ///< s, close enough to 0 for the series: |s| < 1/3
  std::complex<double> LogS; ///< log s, imaginary part in [0, pi], exactly 0 or pi on edges
};

/// Triangle up to similarity, and its conformal map to and from the half disk.
class TriangleShape
{
public:
  /// Construct a degenerate triangle.
  TriangleShape() = default;

  /// Construct from vertices in any plane and any unit.
  TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2);

  /// Test whether an angle is too small for a map (under 1e-9), or a coordinate is not finite.
  bool degenerate() const { return this->Degenerate; }

  /// Return the interior angles in units of pi.
  const std::array<double, 3>& angles() const { return this->Angles; }

  /// Map a point from triangle to half disk, by Newton's method on a univalent function. About 0.4
  /// us.
  /// @param[in] barycentric  of sum 1; negative values count as 0
  /// @pre not degenerate
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;

  /// Map a point from half disk to triangle, by the series of its corner. About 0.1 us.
  /// @return barycentric coordinates, >= 0; exactly 0 on an edge
  /// @pre not degenerate
  Vector3 fromHalfDisk(const HalfDiskPoint& point) const;

  /// Compute dz/ds. In the plane of z the corner of the point is at 0 and the next corner on the
  /// positive real axis. The unit is the diameter of the circumcircle. The derivative of a map
  /// between two triangles is the quotient of their derivatives. The result is infinite at s = 0.
  /// @pre not degenerate
  std::complex<double> derivative(const HalfDiskPoint& point) const;

  /// Compute the derivative of the map to another triangle, in barycentric coordinates, for changes
  /// of sum 0.
  /// @pre neither triangle is degenerate, and the point is not a corner
  Eigen::Matrix3d mapDerivative(const TriangleShape& to, const HalfDiskPoint& point) const;

  /// Compute the ratio of the singular values of the affine map to another triangle, maximum to
  /// minimum.
  /// @pre neither triangle is degenerate
  double dilatation(const TriangleShape& to) const;

private:
  friend class NetworkShapes;
  friend class TriangleMap;

  /// Return the matrix from barycentric coordinates of the next and the previous corner to the
  /// plane of derivative().
  Eigen::Matrix2d plane(int corner) const;

  double leading(int corner) const { return this->Scale / this->Angles[corner]; }
  std::complex<double> logUniform(int corner, const Vector3& barycentric) const;
  int corner(const Vector3& barycentric, std::complex<double>& logUniform) const;
  HalfDiskPoint solve(
    int corner, std::complex<double> logUniform, const Vector3& barycentric) const;
  Vector3 place(const HalfDiskPoint& point, std::complex<double> series) const;

  std::array<double, 3> Angles{}; // units of pi
  // Also the length of the opposite edge for a circumcircle of diameter 1
  std::array<double, 3> Sines{};
  std::array<double, 3> Cosines{};
  double Scale = 0.0; // k of the comment at the beginning of this file
  bool Degenerate = true;
};
}

#endif
