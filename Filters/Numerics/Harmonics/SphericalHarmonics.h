/// Real spherical harmonics at any directions.
/// Own construction: direct sums over blocks of directions, for arbitrary directions.

#ifndef ConformalSphericalHarmonics_h
#define ConformalSphericalHarmonics_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// The highest degree that functions of this room take: no table of theirs is more than some
/// hundred megabytes then.
constexpr int MaximumHarmonicDegree = 1024;

/// The harmonics of this library are real, orthonormal on the unit sphere, and without the
/// Condon-Shortley phase. With the height z, the longitude phi = atan2(y, x), and the functions
/// P_lm of LegendreFunctions, that of degree l in [0, L] and order m in [-l, l] is
///
///     Y_lm = P_lm(z) cos(m phi)    for m >= 0
///     Y_lm = P_l|m|(z) sin(|m| phi)  for m < 0.
///
/// Y_00 = 1 / sqrt(4 pi); Y_1,-1, Y_10 and Y_11 are sqrt(3 / (4 pi)) times y, z and x. Coefficients
/// are rows in the order of degrees, and of orders from -l to l.
constexpr Index harmonicIndex(int degree, int order)
{
  return static_cast<Index>(degree) * (degree + 1) + order;
}

/// (L + 1)^2.
constexpr Index numberOfHarmonics(int degree)
{
  return static_cast<Index>(degree + 1) * (degree + 1);
}

/// L of so many coefficients.
/// @throws std::invalid_argument if they are not (L + 1)^2, or L is more than the maximum
int degreeOfHarmonics(Index numberOfCoefficients);

/// Functions at given directions.
/// @param[in] coefficients  (L + 1)^2 by #C
/// @param[in] directions    #N by 3 unit vectors
/// @return #N by #C
/// @throws std::invalid_argument as degreeOfHarmonics
Columns evaluateHarmonics(
  const Columns& coefficients, const Points& directions, const Run& run = {});

/// Sums of values times harmonics over all directions: the transpose of evaluateHarmonics().
/// @param[in] directions  #N by 3 unit vectors
/// @param[in] values      #N by #C
/// @param[in] degree      L, in [0, MaximumHarmonicDegree]
/// @return (L + 1)^2 by #C
Columns harmonicMoments(
  const Points& directions, const Columns& values, int degree, const Run& run = {});

/// Sum of squares of the coefficients of each degree, over all columns: does not depend on how the
/// sphere is turned, nor on how the values are where columns are coordinates.
Eigen::VectorXd powerPerDegree(const Columns& coefficients);
}

#endif
