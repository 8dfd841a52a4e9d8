/// Evaluate real spherical harmonics in arbitrary directions. Own construction: harmonics are
/// summed directly over blocks of directions, because fast transforms need directions on a grid.

#ifndef ConformalSphericalHarmonics_h
#define ConformalSphericalHarmonics_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Maximum degree of spherical harmonics. It limits each internal table to some hundred megabytes.
constexpr int MaximumHarmonicDegree = 1024;

/// Return the row of the harmonic of degree l in [0, L] and order m in [-l, l] in a matrix of
/// coefficients. Rows are ordered by degree, then by order.
///
/// The harmonics of this library are real, orthonormal on the unit sphere, and without the
/// Condon-Shortley phase. With the height z, the longitude phi = atan2(y, x), and P_lm of
/// LegendreFunctions:
///
///     Y_lm = P_lm(z) cos(m phi)    for m >= 0
///     Y_lm = P_l|m|(z) sin(|m| phi)  for m < 0.
///
/// Y_00 = 1 / sqrt(4 pi); Y_1,-1, Y_10 and Y_11 are sqrt(3 / (4 pi)) times y, z and x.
constexpr Index harmonicIndex(int degree, int order)
{
  return static_cast<Index>(degree) * (degree + 1) + order;
}

/// Return the number of harmonics up to degree L, (L + 1)^2.
constexpr Index numberOfHarmonics(int degree)
{
  return static_cast<Index>(degree + 1) * (degree + 1);
}

/// Return the degree L of a number of coefficients, (L + 1)^2.
/// @throws std::invalid_argument if the number is not of this form, or L is above
///   MaximumHarmonicDegree
int degreeOfHarmonics(Index numberOfCoefficients);

/// Evaluate functions, given by coefficients, in given directions.
/// @param[in] coefficients  (L + 1)^2 by #C
/// @param[in] directions    #N by 3 unit vectors
/// @return #N by #C
/// @throws std::invalid_argument if degreeOfHarmonics() throws it
Columns evaluateHarmonics(
  const Columns& coefficients, const Points& directions, const Run& run = {});

/// Sum values times harmonics over all directions: the transpose of evaluateHarmonics().
/// @param[in] directions  #N by 3 unit vectors
/// @param[in] values      #N by #C
/// @param[in] degree      degree L, in [0, MaximumHarmonicDegree]
/// @return (L + 1)^2 by #C
Columns harmonicMoments(
  const Points& directions, const Columns& values, int degree, const Run& run = {});

/// Sum the squares of the coefficients of each degree over all columns. Rotations of the sphere do
/// not change the sums. If the columns are coordinates, rotations of the surface do not change them
/// either.
Eigen::VectorXd powerPerDegree(const Columns& coefficients);
}

#endif
