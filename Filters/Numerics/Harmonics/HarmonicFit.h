/// Fit spherical harmonics to values at the vertices of a surface that is mapped to the sphere.
///
/// Own construction, not from a publication: the equations of the fit are solved by iterations.
/// Each iteration multiplies a function by the area density (area of the surface per area of the
/// sphere). The multiplication uses a quadrature grid, a grid of directions for integrals over the
/// sphere. Unlike the method of \cite Brechbuehler1995, this method needs no dense matrix.

#ifndef ConformalHarmonicFit_h
#define ConformalHarmonicFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Fit functions on the sphere to values by least squares over the area of the surface. The
/// functions are sums of spherical harmonics up to degree L.
///
/// A triangle is small if its sides on the sphere are at most pi / L, half of the shortest
/// wavelength. A small triangle is represented by its vertices, each with a third of the area. If
/// all triangles are small, a fit to the values of a function of degree L reproduces this function
/// up to rounding. In larger triangles, vertices alone would leave the functions undetermined.
/// Larger triangles are therefore divided at the middles of their longest sides, until all parts
/// are small. Each part is represented by its center, with the linearly interpolated values. If the
/// map or the surface is rotated, the samples rotate, too. powerPerDegree() of the result then
/// changes only by rounding.
///
/// The normal equations are solved by conjugate gradients \cite Hestenes1952. The area density is
/// the area of the surface per area of the sphere. Let f be a function. The matrix of the equations
/// maps the coefficients of f to those of f times the area density. Only the part of the density up
/// to degree 2 L affects these coefficients. Products of the matrix and a vector can therefore be
/// computed exactly on a Gauss-Legendre grid (HarmonicGrid.h). No dense matrix is formed. The cost
/// is O(#V L^2) once, and O(L^3) for each of about 20 iterations. The preconditioner is an
/// approximate inverse of the matrix. It divides a function by a density that is constant on each
/// triangle: the triangle's area divided by its area on the sphere.
///
/// Implementation note: the software SPHARM-PDM, by M. Styner and others, Insight Journal 1071
/// (2006), solves dense equations instead. There, all vertices have equal weights.
///
/// @param[in] mesh    surface with a map that covers the sphere once without folds. The map may be
///   mirrored.
/// @param[in] values  #V by #C values, for example positions
/// @param[in] degree  degree L, in [0, MaximumHarmonicDegree / 2]
/// @return (L + 1)^2 by #C coefficients, see SphericalHarmonics.h
/// @throws std::invalid_argument if the surface is open or has zero area, or if its map does not
///   cover the sphere once
/// @throws std::invalid_argument if sums of the values exceed the range of doubles
/// @throws NumericalFailure if the iteration does not converge
/// @throws Aborted
Columns fitHarmonics(
  const MappedMesh& mesh, const Columns& values, int degree, const Run& run = {});
}

#endif
