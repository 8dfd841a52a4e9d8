/// Conformal maps between triangles, vertices to vertices, \cite Liou2008 Eqs. 4 and 5.
///
/// A point passes through a half disk common to all triangles: any triangle -> half disk -> any
/// other. Barycentric coordinates go in and come out, so that no planes are needed.
///
/// Implementation note: the paper integrates over the whole unit disk. Three prevertices may lie
/// anywhere on its border, so the disk is replaced by its image that has most to give: the upper
/// half of the unit disk |s| <= 1, Im s >= 0, one corner of the triangle at s = 0, the next at 1,
/// the previous at -1, the edge opposite on the half circle. With the angles a, b, c of these
/// corners in units of pi, Eqs. 4 and 5 become
///     dz/ds = k 4^a s^(a-1) (1-s)^(2b-1) (1+s)^(2c-1),   k = pi D / (Gamma(a) Gamma(b) Gamma(c)),
/// D being the diameter of the circumcircle; the factor 1 + s^2 cancels since a + b + c = 1.
/// Nothing is left to be solved for, all coefficients are real, and of the three corners there is
/// always one that sees a point at |s| <= 2 - sqrt(3): 30 terms of a power series give all digits
/// of a double, whatever the shape of the triangle.

#ifndef ConformalSchwarzChristoffel_h
#define ConformalSchwarzChristoffel_h

#include "Base/Types.h"

#include <array>
#include <complex>

namespace conformal
{
/// A point of the half disk, as one corner of the triangle sees it.
struct HalfDiskPoint
{
  int Corner = 0;            ///< at s = 0; the next corner is at 1, the previous at -1
  std::complex<double> S;    ///< s, near enough to 0 for the series: |s| < 1/3
  std::complex<double> LogS; ///< log s, imaginary part in [0, pi], exactly 0 or pi on edges
};

/// A triangle up to similarity, and its conformal map to and from the half disk.
class TriangleShape
{
public:
  /// No shape: degenerate.
  TriangleShape() = default;

  /// Vertices in any plane, any unit.
  TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2);

  /// The angles are too small for a map (under 1e-9), or a coordinate is not finite.
  bool degenerate() const { return this->Degenerate; }

  /// Interior angles in units of pi.
  const std::array<double, 3>& angles() const { return this->Angles; }

  /// Triangle to half disk, by Newton's method on a univalent function. About 0.4 us.
  /// @param[in] barycentric  of sum 1; what is negative counts as 0
  /// @pre not degenerate
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;

  /// Half disk to triangle, by the series of the point's corner. About 0.1 us.
  /// @return barycentric coordinates, none negative; exactly 0 where an edge says so
  /// @pre not degenerate
  Vector3 fromHalfDisk(const HalfDiskPoint& point) const;

  /// dz/ds in the plane that has the point's corner at 0, the next corner on the positive real
  /// axis and the circumcircle's diameter as unit. The derivative of a map between two triangles
  /// is the quotient of theirs. Infinite at s = 0.
  /// @pre not degenerate
  std::complex<double> derivative(const HalfDiskPoint& point) const;

  /// Derivative of the map to another triangle, in barycentric coordinates, for changes of sum 0.
  /// @pre neither is degenerate, and the point is no corner
  Eigen::Matrix3d mapDerivative(const TriangleShape& to, const HalfDiskPoint& point) const;

  /// Ratio of the largest to the smallest stretch of the affine map to another triangle.
  /// @pre neither is degenerate
  double dilatation(const TriangleShape& to) const;

private:
  friend class NetworkShapes;
  friend class TriangleMap;

  /// From barycentric coordinates of the next and the previous corner to the plane of derivative().
  Eigen::Matrix2d plane(int corner) const;

  double leading(int corner) const { return this->Scale / this->Angles[corner]; }
  std::complex<double> logUniform(int corner, const Vector3& barycentric) const;
  int corner(const Vector3& barycentric, std::complex<double>& logUniform) const;
  HalfDiskPoint solve(
    int corner, std::complex<double> logUniform, const Vector3& barycentric) const;
  Vector3 place(const HalfDiskPoint& point, std::complex<double> series) const;

  std::array<double, 3> Angles{}; // units of pi
  std::array<double, 3> Sines{}; // also the length of the edge opposite, diameter of circumcircle 1
  std::array<double, 3> Cosines{};
  double Scale = 0.0; // k of the comment at the top
  bool Degenerate = true;
};
}

#endif
