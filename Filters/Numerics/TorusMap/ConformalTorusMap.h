/// Map a closed surface of genus 1 to a flat torus, conformally, \cite GuYau2003.

#ifndef ConformalConformalTorusMap_h
#define ConformalConformalTorusMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "TorusMap/FlatTorus.h"

namespace conformal
{
struct ConformalTorusMapResult
{
  FlatTorus Torus;          ///< flat torus to which the surface is conformally equivalent
  TorusPositions Positions; ///< #V by 2 fractions of the periods, in [0, 1)
  double Energy = 0.0; ///< Dirichlet energy of the map; 1 for a conformal map, otherwise larger
  Index NumberOfSolves = 0; ///< number of factorized systems of equations
  /// Number of triangles that are flipped or have no area on the torus, in exact arithmetic
  Index NumberOfFlippedTriangles = 0;
  /// Number of edges whose opposite angles have a sum above pi, see StringConstants
  Index NumberOfNegativeStringConstants = 0;
  Index NumberOfInfiniteStringConstants = 0; ///< number of edges of triangles without area
  /// Mean of the quasi-conformal error K over the triangles; K is the ratio of the larger to the
  /// smaller singular value of the map of a triangle. Triangles without area are left out.
  double MeanQuasiConformalError = 1.0;
  /// Value that K does not exceed in 95 % of the triangles
  double QuasiConformalError95 = 1.0;
};

/// Map a closed surface of genus 1 to a flat torus. Seen from outside, triangles are
/// counter-clockwise on the surface and on the torus.
///
/// 1. Find two integer closed one-forms (ClosedForms.h).
/// 2. Add differences of a function to each form, so that the form becomes harmonic,
///    \cite GuYau2003 section 4.2. The functions are the solutions of linear equations with
///    cotangent weights, \cite Pinkall1993. Modulo 1, they are the coordinates of the map.
/// 3. The energies of the two harmonic forms determine the shape of the torus. Let E be the matrix
///    of their products. The dot products of the periods are the inverse of E, up to the scale.
///    This torus has the lowest energy of the map among all flat tori of area 1.
/// 4. Reduce the basis of periods, see reduceBasis().
/// 5. With positive weights, the map is one to one, \cite Gortler2006. Negative weights can flip
///    triangles. If triangles are flipped, repeat step 2 with a positive weight on each edge near
///    these triangles, and finally on all edges. The torus of step 3 is kept.
///
/// Implementation note: \cite GuYau2003 makes the second form of a conformal map perpendicular to
/// the first one by the Hodge star. Here, the second coordinate is a harmonic function of its own.
/// The map is then an affine map of a one-to-one map, and is conformal in the limit of small
/// triangles.
///
/// The position of vertex 0 is (0, 0). The map can be combined with a half turn of the plane, which
/// preserves the periods. The half turn is chosen by the moments of the gradients, so that it does
/// not depend on the numbering of the vertices.
/// @param[in] mesh  surface with finite positions, all of them used by triangles. Triangles may
///   have zero area.
/// @throws std::invalid_argument if the surface is not closed, manifold, connected, consistently
///   oriented and of genus 1, or a position is not finite
/// @throws NumericalFailure if the equations cannot be solved
/// @throws Aborted
/// @post the result does not depend on the number of threads
ConformalTorusMapResult mapToTorus(const Mesh& mesh, const Run& run = {});
}

#endif
