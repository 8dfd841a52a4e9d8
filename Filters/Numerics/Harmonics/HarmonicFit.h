/// Fit spherical harmonics to values at the vertices of a surface that is mapped to the sphere.
/// Own construction: a quadrature grid replaces the dense equations of \cite Brechbuehler1995.

#ifndef ConformalHarmonicFit_h
#define ConformalHarmonicFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Fit functions of degree L by least squares over the area of the surface.
///
/// A triangle with sides of at most pi / L on the sphere, half of the shortest wavelength, is
/// represented by its vertices. Each gets a third of its area. On such a mesh, functions of degree
/// L are reproduced up to rounding. Larger triangles would leave the functions undetermined between
/// vertices. They are sampled inside, with linearly interpolated values.
///
/// The normal equations are solved by conjugate gradients \cite Hestenes1952. Their matrix is the
/// product with an area density. Only its part up to degree 2 L matters, so products are computed
/// on a Gauss-Legendre grid. The cost is O(#V L^2) once and O(L^3) for each of about 20 iterations;
/// no dense matrix is formed. The preconditioner is the product with the inverse of the triangles'
/// own density.
///
/// Implementation note: SPHARM-PDM, by M. Styner and others, Insight Journal 1071 (2006), solves
/// the dense equations of all vertices with equal weights.
///
/// @param[in] mesh    its map covers the sphere once without folds, mirrored or not
/// @param[in] values  #V by #C, for example positions
/// @param[in] degree  L, in [0, MaximumHarmonicDegree / 2]
/// @return (L + 1)^2 by #C, see SphericalHarmonics.h
/// @throws std::invalid_argument if the surface is open or has zero area, or its map does not cover
///   the sphere once
/// @throws std::invalid_argument if sums of values overflow
/// @throws NumericalFailure if the iteration does not converge
/// @throws Aborted
Columns fitHarmonics(
  const MappedMesh& mesh, const Columns& values, int degree, const Run& run = {});
}

#endif
