/// Nodes and weights of Gauss-Legendre quadrature.
/// Newton iteration as in \cite Hale2013.

#ifndef ConformalGaussLegendre_h
#define ConformalGaussLegendre_h

#include <vector>

namespace conformal
{
struct GaussLegendre
{
  std::vector<double> Nodes;   ///< zeros of the Legendre polynomial of their number, falling
  std::vector<double> Weights; ///< positive, sum 2
};

/// The rule of n nodes, which integrates polynomials of degree 2 n - 1 over [-1, 1] exactly.
/// @param[in] count  n, at least 1
GaussLegendre makeGaussLegendre(int count);
}

#endif
