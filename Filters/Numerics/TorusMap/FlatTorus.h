/// Describe a flat torus: a parallelogram whose opposite sides are identified.

#ifndef ConformalFlatTorus_h
#define ConformalFlatTorus_h

#include "Base/Types.h"

#include <complex>

namespace conformal
{
/// Positions on a torus, one row for each point: fractions of the two periods.
using TorusPositions = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// Parallelogram of area 1 whose opposite sides are identified. The position (s, t) on the torus is
/// the point s w1 + t w2 of the plane, where w1 and w2 are the periods. The first period points in
/// direction x. The modulus tau is the ratio w2 / w1 as complex numbers; its imaginary part is
/// positive.
struct FlatTorus
{
  std::complex<double> Modulus{ 0.0, 1.0 };

  /// Return the periods, one in each column.
  Eigen::Matrix2d periods() const;
};

/// Reduced basis of a lattice.
struct ReducedBasis
{
  FlatTorus Torus;
  /// Unimodular matrix (determinant 1). Multiply fractions of the given periods by this matrix to
  /// get fractions of the reduced periods.
  Eigen::Matrix2i Change = Eigen::Matrix2i::Identity();
};

/// Reduce a basis of a lattice by the method of Lagrange and Gauss, \cite Nguyen2009. The reduced
/// first period is a shortest vector of the lattice. The second one is a shortest vector of those
/// that are not its multiples. The modulus is then in the fundamental domain of the modular group:
/// its real part is in (-1/2, 1/2], its absolute value is at least 1, and the real part is not
/// negative if the absolute value is 1. Differences up to a relative size of 1e-9 count as
/// rounding errors.
/// @param[in] gram  dot products of the two periods: symmetric and positive definite, of any scale.
///   The first period turns counter-clockwise to the second one.
/// @throws std::invalid_argument if the matrix is not positive definite
ReducedBasis reduceBasis(const Eigen::Matrix2d& gram);
}

#endif
