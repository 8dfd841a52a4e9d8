/// Parse and write files of spherical-harmonic coefficients (.coef) of the program SPHARM-PDM.

#ifndef ConformalSPHARMCoefficients_h
#define ConformalSPHARMCoefficients_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/NamedArray.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string>
#include <string_view>

namespace conformal
{
/// Read a file "{ N,{x, y, z},{x, y, z}, ...}" of N = (L + 1)^2 coefficients, where L is the
/// maximum degree. Blanks and line ends are allowed between all numbers, braces and commas.
///
/// Let l be the degree and m the order of a spherical harmonic. Let P_lm be the associated Legendre
/// function of cos(theta) with the Condon-Shortley phase. Let N_lm^2 = (2 l + 1) / (4 pi) (l - m)!
/// / (l + m)!. For each l, the file contains the coefficient of order 0. The "real" and the
/// "imaginary" coefficients of each m from 1 to l follow. Real coefficients are factors of N_lm
/// P_lm cos(m phi). Imaginary coefficients are factors of N_lm P_lm sin(m phi). A position (x, y,
/// z) on the unit sphere (file *_para of SPHARM-PDM) has the angles theta = acos(z) and phi =
/// atan2(y, x).
///
/// The parser multiplies the coefficients of each m > 0 by (-1)^m / sqrt(2). The result contains
/// coefficients of the real orthonormal harmonics without the Condon-Shortley phase. The sum of
/// these harmonics, each times its coefficient, equals the surface that SPHARM-PDM computes from
/// the file.
///
/// @return a surface without points. Its point array "Coefficients" (Float64, 3 components) has N
///   tuples: for each degree l, the orders from -l (sin) to l (cos)
SurfaceResult parseSPHARMCoefficients(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify a file of coefficients.
bool looksLikeSPHARMCoefficients(std::string_view start);

/// Write coefficients as text. The array must have the layout that parseSPHARMCoefficients()
/// returns. Numbers have 15 digits. A number that was read from a file with at most 15 digits is
/// thus written unchanged.
/// @throws std::invalid_argument if the array does not have (L + 1)^2 tuples of 3 finite Float64
/// @throws Aborted if the progress callback of `run` returns false
std::string makeSPHARMCoefficients(const NamedArray& coefficients, const Run& run = {});
}

#endif
