/// Evaluate real spherical harmonics in arbitrary directions.
///
/// Own construction, not from a publication: harmonics are summed directly, for blocks of
/// directions. The fast transforms of HarmonicGrid.h are only possible for directions on a grid.

#ifndef ConformalSphericalHarmonics_h
#define ConformalSphericalHarmonics_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Maximum degree of spherical harmonics. With this limit, each internal table has at most some
/// hundred megabytes.
constexpr int MaximumHarmonicDegree = 1024;

/// Return the row in a matrix of coefficients that belongs to the harmonic of degree l and order m.
/// Rows are sorted by degree, then by order.
///
/// The harmonics are real, orthonormal on the unit sphere, and without the Condon-Shortley phase,
/// the factor (-1)^m. Let (x, y, z) be a direction, and phi = atan2(y, x) its longitude. Let P_lm
/// be the functions of LegendreFunctions.h. The harmonic of degree l and order m is:
///
///     Y_lm = P_lm(z) cos(m phi)    for m >= 0
///     Y_lm = P_l|m|(z) sin(|m| phi)  for m < 0.
///
/// For example, Y_00 = 1 / sqrt(4 pi). Y_1,-1, Y_10 and Y_11 are sqrt(3 / (4 pi)) times y, z and x.
/// @param[in] degree  degree l, in [0, L], where L is the maximum degree in the matrix
/// @param[in] order   order m, in [-l, l]
constexpr Index harmonicIndex(int degree, int order)
{
  return static_cast<Index>(degree) * (degree + 1) + order;
}

/// Return the number of harmonics up to degree L: (L + 1)^2.
constexpr Index numberOfHarmonics(int degree)
{
  return static_cast<Index>(degree + 1) * (degree + 1);
}

/// Return the maximum degree L of a function with the given number of coefficients, which must be
/// (L + 1)^2.
/// @throws std::invalid_argument if the number is not (L + 1)^2 for an integer L in [0,
///   MaximumHarmonicDegree]
int degreeOfHarmonics(Index numberOfCoefficients);

/// Evaluate functions in given directions.
/// @param[in] coefficients  (L + 1)^2 by #C, coefficients of #C functions
/// @param[in] directions    #N by 3 unit vectors
/// @return #N by #C values
/// @throws std::invalid_argument if the number of rows of coefficients is not (L + 1)^2, see
///   degreeOfHarmonics()
Columns evaluateHarmonics(
  const Columns& coefficients, const Points& directions, const Run& run = {});

/// Sum values times harmonics over all directions. This operation is the transpose of
/// evaluateHarmonics().
/// @param[in] directions  #N by 3 unit vectors
/// @param[in] values      #N by #C values
/// @param[in] degree      maximum degree L of the harmonics, in [0, MaximumHarmonicDegree]
/// @return (L + 1)^2 by #C sums
Columns harmonicMoments(
  const Points& directions, const Columns& values, int degree, const Run& run = {});

/// Sum the squares of the coefficients of each degree over all columns. The sums do not change if
/// the sphere is rotated. If the columns are coordinates of a surface, the sums do not change if
/// the surface is rotated.
/// @return one sum for each degree from 0 to L
Eigen::VectorXd powerPerDegree(const Columns& coefficients);
}

#endif
