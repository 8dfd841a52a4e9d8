/// Map the unit disk conformally to a square: the Schwarz-Christoffel map of the disk, an elliptic
/// integral, \cite Peirce1879. Carlson's algorithm computes the integral.

#ifndef ConformalLemniscate_h
#define ConformalLemniscate_h

#include <complex>

namespace conformal
{
/// Half the diagonal of the square onto which lemniscateArcsine() maps the unit disk: half the
/// lemniscate constant.
constexpr double HalfLemniscate = 0.5 * 2.62205755429211981;

/// Compute the integral of 1 / sqrt(1 - t^4) from 0 to a point of the unit disk. The image of the
/// disk is the square with corners at plus and minus HalfLemniscate, on both axes. The map is
/// conformal, except at the corners, which are the images of the fourth roots of 1.
std::complex<double> lemniscateArcsine(const std::complex<double>& s);

/// Compute the inverse of lemniscateArcsine(), for positions in the square.
std::complex<double> lemniscateSine(const std::complex<double>& z);
}

#endif
