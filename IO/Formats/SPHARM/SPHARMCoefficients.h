/// Parse and write files of spherical-harmonic coefficients of SPHARM-PDM (.coef).

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
/// Read "{ N,{x, y, z},{x, y, z}, ...}", where N = (L + 1)^2. Blanks and line ends may be anywhere.
///
/// For each degree l the file has the coefficients of order 0, then for each m from 1 to l the
/// "real" and the "imaginary" coefficients. Real coefficients are factors of N_lm P_lm cos(m phi),
/// imaginary coefficients are factors of N_lm P_lm sin(m phi), with N_lm^2 = (2 l + 1) / (4 pi) (l
/// - m)! / (l + m)!. P_lm has the Condon-Shortley phase; cos(theta) = z and phi = atan2(y, x) refer
/// to the positions in the file _para.
///
/// The parser multiplies the numbers for m > 0 by (-1)^m / sqrt(2). The sum of the tuples times
/// real orthonormal harmonics without that phase then equals the surface that SPHARM-PDM computes
/// from the file.
///
/// @return a surface without points, with the point array "Coefficients" (Float64, 3 components) of
///   N tuples: for each degree l the orders from -l (sin) to l (cos)
SurfaceResult parseSPHARMCoefficients(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a file of coefficients.
bool looksLikeSPHARMCoefficients(std::string_view start);

/// Write the array of parseSPHARMCoefficients() to a file. Numbers have 15 digits, so that numbers
/// read with at most 15 digits are written unchanged.
/// @throws std::invalid_argument if there are not (L + 1)^2 tuples of 3 finite Float64
/// @throws Aborted
std::string makeSPHARMCoefficients(const NamedArray& coefficients, const Run& run = {});
}

#endif
