/// Evaluate normalized associated Legendre functions of high degree. Small values are represented
/// with extended exponents, as in \cite Fukushima2012.

#ifndef ConformalLegendreFunctions_h
#define ConformalLegendreFunctions_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Number of heights at which functions are evaluated together, for vectorization. A height is the
/// z coordinate of a point on the unit sphere.
constexpr int LegendreLanes = 64;
/// One number for each of LegendreLanes heights.
using LegendreLane = Eigen::Array<double, LegendreLanes, 1>;

/// Values of the functions of one order m at LegendreLanes heights. Column l - m contains the
/// values of the function of degree l.
using LegendreBlock = Eigen::Matrix<double, LegendreLanes, Eigen::Dynamic>;

/// Associated Legendre functions P_lm of degree l and order m, without the Condon-Shortley phase,
/// the factor (-1)^m. Let z be the height of a point on the unit sphere, and phi its longitude. The
/// functions are normalized so that P_l0(z), P_lm(z) cos(m phi) and P_lm(z) sin(m phi) are
/// orthonormal on the sphere.
///
/// For each order m, a recursion computes functions of ascending degree, beginning with P_mm. The
/// recursion is stable: rounding errors do not grow. Near the poles, P_mm can be too small for
/// doubles even if functions of higher degree are not. There, the recursion multiplies values by a
/// power of two. The multiplication is undone as soon as the values are large enough for doubles.
class LegendreFunctions
{
public:
  /// @param[in] degree  maximum degree of the functions, at least 0
  explicit LegendreFunctions(int degree);

  int degree() const { return static_cast<int>(this->LogSectors.size()) - 1; }

  /// Evaluate the functions of one order at given heights, for all degrees from `order` to
  /// degree().
  /// @param[in] order      order m of the functions
  /// @param[in] heights    heights z in [-1, 1]
  /// @param[in] logRadii   logarithms to base 2 of sqrt(1 - z^2); minus infinity at the poles
  /// @param[out] values    one column of values for each degree. The matrix must have at least
  ///   degree() - order + 1 columns; further columns do not change.
  void evaluate(int order, const LegendreLane& heights, const LegendreLane& logRadii,
    LegendreBlock& values) const;

private:
  std::vector<double> LogSectors; ///< for each order m, logarithm to base 2 of P_mm at z = 0
};
}

#endif
