/// Fit spherical harmonics to values at the vertices of a surface that is mapped to the sphere. Own
/// construction: products are computed on a quadrature grid, because this needs no dense equations
/// such as those of \cite Brechbuehler1995.

#ifndef ConformalHarmonicFit_h
#define ConformalHarmonicFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Fit functions of degree L by least squares over the area of the surface.
///
/// A triangle is small if its sides on the sphere are at most pi / L, half of the shortest
/// wavelength. A small triangle is represented by its vertices, each with a third of the area. If
/// all triangles are small, functions of degree L are reproduced up to rounding. Larger triangles
/// would leave the functions undetermined between vertices. They are also sampled inside, with
/// linearly interpolated values.
///
/// The normal equations are solved by conjugate gradients \cite Hestenes1952. The matrix of these
/// equations represents a multiplication by an area density on the sphere. Only the part of the
/// density up to degree 2 L matters, so products are computed on a Gauss-Legendre grid. The cost is
/// O(#V L^2) once, and O(L^3) for each of about 20 iterations. No dense matrix is formed. The
/// preconditioner is a multiplication by the inverse of the area density of the triangles.
///
/// Implementation note: SPHARM-PDM, by M. Styner and others, Insight Journal 1071 (2006), solves
/// the dense equations of all vertices with equal weights.
///
/// @param[in] mesh    surface with a map that covers the sphere once without folds; the map may be
///   mirrored
/// @param[in] values  #V by #C values, for example positions
/// @param[in] degree  degree L, in [0, MaximumHarmonicDegree / 2]
/// @return (L + 1)^2 by #C coefficients, see SphericalHarmonics.h
/// @throws std::invalid_argument if the surface is open or has zero area, or its map does not cover
///   the sphere once
/// @throws std::invalid_argument if sums of values overflow
/// @throws NumericalFailure if the iteration does not converge
/// @throws Aborted
Columns fitHarmonics(
  const MappedMesh& mesh, const Columns& values, int degree, const Run& run = {});
}

#endif
