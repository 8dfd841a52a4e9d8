/// Compute nodes and weights of Gauss-Legendre quadrature, by Newton iteration as in
/// \cite Hale2013.

#ifndef ConformalGaussLegendre_h
#define ConformalGaussLegendre_h

#include <vector>

namespace conformal
{
struct GaussLegendre
{
  /// Zeros of the Legendre polynomial of degree n, descending, for n nodes.
  std::vector<double> Nodes;
  std::vector<double> Weights; ///< weights of the nodes, positive, with sum 2
};

/// Make the quadrature rule of n nodes. It integrates polynomials of degree 2 n - 1 over [-1, 1]
/// exactly.
/// @param[in] count  number n of nodes, at least 1
GaussLegendre makeGaussLegendre(int count);
}

#endif
