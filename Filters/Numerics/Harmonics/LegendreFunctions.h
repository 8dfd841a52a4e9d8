/// Normalized associated Legendre functions of high degree.
/// Extended exponents as in \cite Fukushima2012.

#ifndef ConformalLegendreFunctions_h
#define ConformalLegendreFunctions_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Number of heights evaluated together, for vectorization.
constexpr int LegendreLanes = 64;
using LegendreLane = Eigen::Array<double, LegendreLanes, 1>;

/// Functions of one order at one block of heights: column l - m has degree l.
using LegendreBlock = Eigen::Matrix<double, LegendreLanes, Eigen::Dynamic>;

/// Associated Legendre functions without the Condon-Shortley phase, normalized so that P_l0(z),
/// P_lm(z) cos(m phi) and P_lm(z) sin(m phi) are orthonormal on the unit sphere.
///
/// For each order m, the recursion ascends in degree from P_mm, which is stable. Near the poles,
/// P_mm underflows although functions of higher degree do not. There, values are scaled by a power
/// of two until they are large enough.
class LegendreFunctions
{
public:
  /// @param[in] degree  maximum degree, at least 0
  explicit LegendreFunctions(int degree);

  int degree() const { return static_cast<int>(this->LogSectors.size()) - 1; }

  /// Evaluate the degrees from order to degree(), one column each.
  /// @param[in] heights    z in [-1, 1]
  /// @param[in] logRadii   base 2, of sqrt(1 - z^2); minus infinity at the poles
  /// @param[out] values    as many columns as there are degrees; further columns are unchanged
  void evaluate(int order, const LegendreLane& heights, const LegendreLane& logRadii,
    LegendreBlock& values) const;

private:
  std::vector<double> LogSectors; ///< for each m, log2 of P_mm at radius 1
};
}

#endif
