/// Normalized associated Legendre functions of high degree.
/// Extended exponents as in \cite Fukushima2012.

#ifndef ConformalLegendreFunctions_h
#define ConformalLegendreFunctions_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// As many places as are evaluated together, which the compiler makes vectors of.
constexpr int LegendreLanes = 64;
using LegendreLane = Eigen::Array<double, LegendreLanes, 1>;

/// Functions of one order at places of one block: column l - m is that of degree l.
using LegendreBlock = Eigen::Matrix<double, LegendreLanes, Eigen::Dynamic>;

/// The associated Legendre functions without the Condon-Shortley phase, normalized so that
/// P_l0(z), P_lm(z) cos(m phi) and P_lm(z) sin(m phi) are orthonormal on the unit sphere.
///
/// For each order m the recursion goes up in degree from P_mm, which is stable. Near the poles P_mm
/// is less than the smallest double although functions of that order and a higher degree are not:
/// there numbers are multiplied by a power of two until they are large enough.
class LegendreFunctions
{
public:
  /// @param[in] degree  the highest, not negative
  explicit LegendreFunctions(int degree);

  int degree() const { return static_cast<int>(this->LogSectors.size()) - 1; }

  /// Degrees from order to degree(), written into that many columns.
  /// @param[in] heights    z in [-1, 1]
  /// @param[in] logRadii   base 2, of sqrt(1 - z^2); minus infinity at the poles
  /// @param[out] values    as many columns as there are degrees; others are left as they are
  void evaluate(int order, const LegendreLane& heights, const LegendreLane& logRadii,
    LegendreBlock& values) const;

private:
  std::vector<double> LogSectors; ///< for each m log2 of P_mm where the radius is 1
};
}

#endif
