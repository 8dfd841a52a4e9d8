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
  /// 0 is nearly conformal, 1 nearly preserves areas.
  double AreaBalance = 0.5;
  int NumberOfSweeps = 30;          ///< final sweeps over all vertices, at least 0
  int NumberOfSmoothingSweeps = 30; ///< later sweeps with more weight on the worst triangles
  /// Thin is needed where needles connect large parts by thin necks. Vertices of these parts cannot
  /// be inserted before the necks.
  QuadricCollapse::Needles SurfaceNeedles = QuadricCollapse::Needles::Keep;
  /// Maximum number of insertions that first relax their neighborhood; each may cost a second.
  Index MaximumNumberOfRelaxations = std::numeric_limits<Index>::max();
  /// For surfaces on which every other attempt fails: collapse and insert as if all triangles were
  /// equal and equilateral. Shapes of triangles count only in the final sweeps.
  bool ConnectivityFirst = false;
};

struct ProgressiveSphereMapResult
{
  Points Positions;                   ///< #V by 3 unit vectors
  Index NumberOfFlippedTriangles = 0; ///< 0; verified at the end
  Index NumberOfRelaxations = 0;      ///< insertions that first relaxed their neighborhood
  double Energy = 0.0;                ///< mean over the surface, at least 1; see SphereEnergy
};

/// Map a closed surface of genus zero one to one to the unit sphere \cite Praun2003. Triangles are
/// counter-clockwise seen from outside, as they are on the surface.
///
/// The surface is collapsed to a tetrahedron, which is placed around the center of the sphere. The
/// vertices are reinserted in reverse order, each into the kernel of its ring, so that no triangle
/// is flipped. Between and after the insertions, vertices move to reduce an energy of angles and
/// areas (SphereEnergy). No move may flip a triangle.
///
/// Implementation note: \cite Praun2003 minimizes stretch. Here the energy is the conformal energy
/// times a power of the area's shrinkage. One number thus blends from conformal to area-preserving.
///
/// @param[in] mesh  finite, all positions used; triangles may have zero area
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero, an
///   option is out of range, or points are not finite
/// @throws NumericalFailure if a vertex has no valid position, or there are fewer than four
///   triangles
/// @post the result depends only on the arguments: same input, same bits
ProgressiveSphereMapResult mapToSphere(
  const Mesh& mesh, const ProgressiveSphereMapOptions& options = {}, const Run& run = {});
}

#endif
