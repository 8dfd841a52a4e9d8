/// Evaluate normalized associated Legendre functions of high degree, with extended exponents as in
/// \cite Fukushima2012.

#ifndef ConformalLegendreFunctions_h
#define ConformalLegendreFunctions_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Number of heights evaluated together, for vectorization.
constexpr int LegendreLanes = 64;
using LegendreLane = Eigen::Array<double, LegendreLanes, 1>;

/// Values of the functions of one order m at one block of heights. Column l - m has degree l.
using LegendreBlock = Eigen::Matrix<double, LegendreLanes, Eigen::Dynamic>;

/// Associated Legendre functions without the Condon-Shortley phase, normalized so that P_l0(z),
/// P_lm(z) cos(m phi) and P_lm(z) sin(m phi) are orthonormal on the unit sphere.
///
/// For each order m, a recursion computes functions of ascending degree, beginning with P_mm. The
/// recursion is stable. Near the poles, P_mm underflows, but functions of higher degree do not.
/// There, values are scaled by a power of two until they are large enough.
class LegendreFunctions
{
public:
  /// @param[in] degree  maximum degree of the functions, at least 0
  explicit LegendreFunctions(int degree);

  int degree() const { return static_cast<int>(this->LogSectors.size()) - 1; }

  /// Evaluate the functions of one order, for all degrees from `order` to degree(). Each degree has
  /// one column.
  /// @param[in] heights    heights z in [-1, 1]
  /// @param[in] logRadii   logarithms to base 2 of sqrt(1 - z^2); minus infinity at the poles
  /// @param[out] values    values of the functions; has at least one column for each degree.
  ///   Further columns do not change.
  void evaluate(int order, const LegendreLane& heights, const LegendreLane& logRadii,
    LegendreBlock& values) const;

private:
  std::vector<double> LogSectors; ///< for each m, log2 of P_mm at z = 0
};
}

#endif
