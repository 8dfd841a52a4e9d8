/// Compute nodes and weights of Gauss-Legendre quadrature (numerical integration), by Newton
/// iteration as in \cite Hale2013.

#ifndef ConformalGaussLegendre_h
#define ConformalGaussLegendre_h

#include <vector>

namespace conformal
{
/// Quadrature rule for integrals over [-1, 1]. An integral is approximated by a weighted sum of the
/// function's values at the nodes.
struct GaussLegendre
{
  /// Zeros of the Legendre polynomial of degree n, in descending order, where n is the number of
  /// nodes.
  std::vector<double> Nodes;
  std::vector<double> Weights; ///< positive weight of each node; the sum of all weights is 2
};

/// Make the quadrature rule of n nodes. The rule integrates polynomials up to degree 2 n - 1
/// exactly.
/// @param[in] count  number n of nodes, at least 1
GaussLegendre makeGaussLegendre(int count);
}

#endif
