/// Map triangles conformally to other triangles, \cite Liou2008 Eqs. 4 and 5. Corners are mapped to
/// corners.
///
/// Every triangle has a conformal map to the same half disk. A map between two triangles is a
/// composition. The first triangle is mapped to the half disk, then the half disk is mapped to the
/// second triangle. Input and output are barycentric coordinates, so that no plane has to be
/// chosen.
///
/// Implementation note: \cite Liou2008 uses maps to the whole unit disk. On the border of the disk,
/// the images of the corners can be chosen freely. This file uses the upper half of the unit disk
/// instead. The whole disk has a conformal map to this half disk. Let s be the complex coordinate
/// of the half disk: |s| <= 1, Im s >= 0. One corner of the triangle is mapped to s = 0, the next
/// corner to 1, the previous corner to -1. The edge opposite the corner at 0 is mapped to the half
/// circle. Let a, b and c be the angles of these three corners, in units of pi. Let z be the
/// complex coordinate in the plane of the triangle. Eqs. 4 and 5 then become
///     dz/ds = k 4^a s^(a-1) (1-s)^(2b-1) (1+s)^(2c-1),   k = pi D / (Gamma(a) Gamma(b) Gamma(c)),
/// where D is the diameter of the circumcircle. A factor 1 + s^2 cancels, since a + b + c = 1. All
/// parameters of the formula are known real numbers. For every point, at least one choice of the
/// corner at 0 gives |s| <= 2 - sqrt(3). For this choice, 30 terms of a power series in s give full
/// double precision for any shape of the triangle.

#ifndef ConformalSchwarzChristoffel_h
#define ConformalSchwarzChristoffel_h

#include "Base/Types.h"

#include <array>
#include <complex>

namespace conformal
{
/// Point of the half disk, which is defined at the beginning of this file. The coordinate s depends
/// on which corner of the triangle is mapped to s = 0.
struct HalfDiskPoint
{
  int Corner = 0;         ///< corner at s = 0; the next corner is at 1, the previous corner at -1
  std::complex<double> S; ///< coordinate s; |s| < 1/3, so that the series converges fast
  /// Logarithm of s; its imaginary part is in [0, pi], and exactly 0 or pi on the diameter
  std::complex<double> LogS;
};

/// Shape of a triangle, defined by its angles, and the conformal map between the triangle and the
/// half disk.
class TriangleShape
{
public:
  /// Construct the shape of a degenerate triangle.
  TriangleShape() = default;

  /// Construct the shape of a triangle from three vertices, in any plane and any unit.
  TriangleShape(const Vector3& p0, const Vector3& p1, const Vector3& p2);

  /// Test whether the triangle has no conformal map. This is true if an angle is below 1e-9
  /// radians, or a coordinate is not finite.
  bool degenerate() const { return this->Degenerate; }

  /// Return the interior angles in units of pi.
  const std::array<double, 3>& angles() const { return this->Angles; }

  /// Map a point from the triangle to the half disk by Newton's method. One call needs about 0.4
  /// microseconds.
  /// @param[in] barycentric  coordinates with the sum 1; negative coordinates are replaced by 0
  /// @pre the triangle is not degenerate
  HalfDiskPoint toHalfDisk(const Vector3& barycentric) const;

  /// Map a point from the half disk to the triangle by a power series. One call needs about 0.1
  /// microseconds.
  /// @return barycentric coordinates, >= 0. If the point is on an edge, one coordinate is exactly
  ///   0.
  /// @pre the triangle is not degenerate
  Vector3 fromHalfDisk(const HalfDiskPoint& point) const;

  /// Compute the derivative dz/ds of the map from the half disk to the plane of the triangle. In
  /// this plane, the corner `point.Corner` is at z = 0. The next corner is on the positive real
  /// axis. The unit of z is the diameter of the circumcircle. The derivative of the map between two
  /// triangles is the quotient of the two triangles' derivatives. At s = 0, the result is infinite.
  /// @pre the triangle is not degenerate
  std::complex<double> derivative(const HalfDiskPoint& point) const;

  /// Compute the derivative of the conformal map to another triangle, in barycentric coordinates.
  /// Multiply the matrix only by a change of the coordinates: three numbers with the sum 0.
  /// @pre neither triangle is degenerate, and the point is not a corner
  Eigen::Matrix3d mapDerivative(const TriangleShape& to, const HalfDiskPoint& point) const;

  /// Compute the dilatation of the affine map to another triangle. The dilatation is the largest
  /// singular value of the linear part of the map, divided by the smallest.
  /// @pre neither triangle is degenerate
  double dilatation(const TriangleShape& to) const;

private:
  friend class NetworkShapes;
  friend class TriangleMap;

  /// Return the matrix that maps the barycentric coordinates of the next and the previous corner to
  /// a position in a plane. The comment of derivative() defines the plane.
  Eigen::Matrix2d plane(int corner) const;

  double leading(int corner) const { return this->Scale / this->Angles[corner]; }
  std::complex<double> logUniform(int corner, const Vector3& barycentric) const;
  int corner(const Vector3& barycentric, std::complex<double>& logUniform) const;
  HalfDiskPoint solve(
    int corner, std::complex<double> logUniform, const Vector3& barycentric) const;
  Vector3 place(const HalfDiskPoint& point, std::complex<double> series) const;

  std::array<double, 3> Angles{}; // interior angles in units of pi
  // Sines of the angles. Each sine is also the length of the opposite edge, in units of the
  // diameter of the circumcircle.
  std::array<double, 3> Sines{};
  std::array<double, 3> Cosines{};
  double Scale = 0.0; // constant k in the comment at the beginning of this file
  bool Degenerate = true;
};
}

#endif
