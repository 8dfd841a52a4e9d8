/// Map a closed surface of genus zero conformally to the sphere, by linear equations and local
/// repairs. The combination of linear equations and repairs is our own construction. Repairs are
/// necessary, because the solution of the linear equations may have folds (flipped triangles).

#ifndef ConformalHarmonicSphereMap_h
#define ConformalHarmonicSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct HarmonicSphereMap
{
  Points Positions; ///< #V by 3 unit vectors; the mean, weighted by areas of the surface, is 0
  /// Whether the map is one-to-one: no triangle is flipped or too small, see badTriangles(). If
  /// false, do not use Positions.
  bool OneToOne = false;
  /// Whether the solution of the linear equations had folds that were repaired
  bool Repaired = false;
  Index NumberOfSolves = 0; ///< number of attempts (1 or 2), each with another removed triangle
};

/// Map a closed surface of genus zero conformally to the unit sphere, in these steps:
///
/// 1. Remove one triangle (the puncture), and map the rest of the surface by linear equations, see
///    punctureToSphere(). Repair folds (flipped triangles) locally, see repairFlips().
/// 2. If the repair fails, or the puncture is on a limb (long, thin part), repeat step 1 once with
///    another triangle.
/// 3. Find triangles whose angles are not preserved. Move the vertices of these triangles so that
///    angles are preserved better. If the mesh has fewer than 20,000 vertices, move all vertices.
///
/// @param[in] mesh  closed mesh of genus zero, with coordinates of magnitude about 1
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run = {});
}

#endif
