/// Parser and writer of SPHARM-PDM's files of spherical-harmonic coefficients (.coef).

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
/// Read "{ N,{x, y, z},{x, y, z}, ...}" with blanks and line ends anywhere, N being (L + 1)^2.
///
/// The file has for each degree l the coefficients of order 0, then for m from 1 to l the "real"
/// and the "imaginary" ones: factors of N_lm P_lm cos(m phi) and N_lm P_lm sin(m phi), where P_lm
/// has the Condon-Shortley phase and N_lm^2 = (2 l + 1) / (4 pi) (l - m)! / (l + m)!, at cos(theta)
/// = z and phi = atan2(y, x) of the places in the file _para. So SPHARM-PDM's own sum over a file
/// is the sum of the array's tuples times real orthonormal harmonics without that phase, if for m >
/// 0 a number of the file is multiplied by (-1)^m / sqrt(2); and so is done here.
///
/// @return one point array, "Coefficients" (Float64, 3 components) of N tuples: for each degree l
///         the orders from -l (sin) to l (cos); no points
SurfaceResult parseSPHARMCoefficients(
  ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of such coefficients.
bool looksLikeSPHARMCoefficients(std::string_view start);

/// The file of an array as parseSPHARMCoefficients() returns it. Numbers have 15 digits: those that
/// were read with no more are written the same.
/// @throws std::invalid_argument if there are not (L + 1)^2 tuples of 3 finite Float64
/// @throws Aborted
std::string makeSPHARMCoefficients(const NamedArray& coefficients, const Run& run = {});
}

#endif
