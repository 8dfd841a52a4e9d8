/// Fold-free map of a closed surface to the sphere, by a progressive mesh.

#ifndef ConformalProgressiveSphereMap_h
#define ConformalProgressiveSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Mesh/QuadricCollapse.h"

#include <limits>

namespace conformal
{
struct ProgressiveSphereMapOptions
{
  /// From nearly conformal, 0, to nearly equal in area, 1.
  double AreaBalance = 0.5;
  int NumberOfSweeps = 30;          ///< over all vertices at the end, at least 0
  int NumberOfSmoothingSweeps = 30; ///< after these, with more weight on the worst triangles
  /// Thin is needed where bodies are joined by necks of needles: they cannot come before the necks.
  QuadricCollapse::Needles SurfaceNeedles = QuadricCollapse::Needles::Keep;
  /// Insertions that may have to make room, each of which can take a second.
  Index MaximumNumberOfRelaxations = std::numeric_limits<Index>::max();
  /// For surfaces on which nothing else finds room: collapse and insert as if all triangles were
  /// equal and equilateral; shapes count in the sweeps at the end only.
  bool ConnectivityFirst = false;
};

struct ProgressiveSphereMapResult
{
  Points Positions;                   ///< #V by 3 unit vectors
  Index NumberOfFlippedTriangles = 0; ///< 0; counted once more at the end
  Index NumberOfRelaxations = 0;      ///< insertions that first had to make room
  double Energy = 0.0;                ///< mean over the surface, at least 1; see SphereEnergy
};

/// Map a closed surface of genus zero to the unit sphere, one to one, triangles counter-clockwise
/// seen from outside as they are on the surface \cite Praun2003.
///
/// The surface is collapsed on to a tetrahedron, the tetrahedron laid around the sphere, and the
/// vertices put back in reverse order, each into the kernel of its ring, so that no triangle is
/// ever flipped. Between and after the insertions vertices move to where an energy of angles and
/// areas (SphereEnergy) is lowest; no step may flip a triangle.
///
/// Implementation note: instead of the stretch of \cite Praun2003 the energy is a product of the
/// conformal energy and a power of the area's shrinkage, so that one number leads from conformal
/// to equal in area.
///
/// @param[in] mesh  finite, all positions used; triangles may have no area
/// @throws std::invalid_argument with what is wrong, if the surface is not closed, manifold and of
///         genus zero, if an option is out of range, or points are not finite
/// @throws NumericalFailure if there is no room for a vertex, or there are fewer than four
/// triangles
/// @post the result depends only on the arguments: same input, same bits
ProgressiveSphereMapResult mapToSphere(
  const Mesh& mesh, const ProgressiveSphereMapOptions& options = {}, const Run& run = {});
}

#endif
