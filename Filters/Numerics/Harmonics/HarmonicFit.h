/// Fits spherical harmonics to values at the vertices of a surface that is mapped to the sphere.
/// Own construction: a quadrature grid replaces the dense equations of \cite Brechbuehler1995.

#ifndef ConformalHarmonicFit_h
#define ConformalHarmonicFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// The functions of degree L whose squared differences to the values are least in sum over the
/// surface. A triangle whose sides on the sphere are no longer than pi / L, half of the shortest
/// wave, stands for its vertices, each with a third of its area; so values that are such functions
/// give them back, exact to rounding, if the mesh is that fine. In larger triangles, where vertices
/// would leave the functions free, places all over the triangle count, with values linear in it.
///
/// The normal equations are solved by conjugate gradients. Their matrix is the product with a
/// density of area; of the point masses at vertices only the part up to degree 2 L matters, which
/// is a function. So products are taken on a Gauss-Legendre grid: O(#V L^2) once and O(L^3) for
/// each of some 20 steps, never a dense matrix. The preconditioner is the product with the inverse
/// of the triangles' own density.
///
/// Implementation note: SPHARM-PDM, by M. Styner and others, Insight Journal 1071 (2006), solves
/// the dense equations of all vertices, each counting as one.
///
/// @param[in] mesh    its map covers the sphere once without folds, or mirrors it so
/// @param[in] values  #V by #C, for example positions
/// @param[in] degree  L, in [0, MaximumHarmonicDegree / 2]
/// @return (L + 1)^2 by #C, see SphericalHarmonics
/// @throws std::invalid_argument if the surface is open or has no area, or if the map does not
/// cover
///         the sphere once
/// @throws std::invalid_argument if sums of values leave the range of doubles
/// @throws NumericalFailure if the steps do not come to an end
/// @throws Aborted
Columns fitHarmonics(
  const MappedMesh& mesh, const Columns& values, int degree, const Run& run = {});
}

#endif
