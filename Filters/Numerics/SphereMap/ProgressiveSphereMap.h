/// Map a closed surface to the sphere without folds, by a progressive mesh.

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
  /// Balance between angles and areas: 0 gives a nearly conformal map, 1 nearly preserves areas
  double AreaBalance = 0.5;
  int NumberOfSweeps = 30; ///< number of final sweeps over all vertices, at least 0
  /// Number of later sweeps, which give more weight to the worst triangles
  int NumberOfSmoothingSweeps = 30;
  /// Priority of collapses at needles. Thin is required if necks made of needles connect large
  /// parts of the surface. The reason is that vertices of these parts cannot be inserted before the
  /// necks.
  QuadricCollapse::Needles SurfaceNeedles = QuadricCollapse::Needles::Keep;
  /// Maximum number of insertions for which vertices nearby are moved first; each may need a second
  Index MaximumNumberOfRelaxations = std::numeric_limits<Index>::max();
  /// Whether to collapse and insert as if all triangles were equilateral, with equal areas. The
  /// true shapes matter only in the final sweeps. For surfaces on which every other attempt fails
  bool ConnectivityFirst = false;
};

struct ProgressiveSphereMapResult
{
  Points Positions;                   ///< #V by 3 unit vectors
  Index NumberOfFlippedTriangles = 0; ///< number of flipped triangles, checked at the end; always 0
  /// Number of insertions for which vertices nearby were moved first
  Index NumberOfRelaxations = 0;
  double Energy = 0.0; ///< mean of SphereEnergy over the surface, at least 1
};

/// Map a closed surface of genus zero one-to-one to the unit sphere, \cite Praun2003. Triangles are
/// counter-clockwise seen from outside, both on the surface and on the sphere.
///
/// The surface is collapsed to a tetrahedron, whose four vertices are placed on the sphere. The
/// other vertices are then inserted in the reverse order of the collapses. Each one is placed in
/// the kernel of the polygon of its neighbors, so that no triangle is flipped. Between and after
/// the insertions, vertices move to reduce an energy of angles and areas (SphereEnergy). No move
/// may flip a triangle.
///
/// Implementation note: \cite Praun2003 minimizes stretch. Here the energy of a triangle is its
/// conformal energy times a power of the factor by which its area shrinks. One exponent thus blends
/// from conformal to area-preserving maps.
///
/// @param[in] mesh  surface; finite, without unused positions; triangles may have zero area
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero, an
///   option is out of range, or points are not finite
/// @throws NumericalFailure if a vertex has no valid position, or if there are fewer than four
///   triangles
/// @post the result depends only on the arguments: the same input gives the same bits
ProgressiveSphereMapResult mapToSphere(
  const Mesh& mesh, const ProgressiveSphereMapOptions& options = {}, const Run& run = {});
}

#endif
