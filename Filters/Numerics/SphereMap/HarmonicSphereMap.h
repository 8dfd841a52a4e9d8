/// Conformal map of a closed surface to the sphere, by linear solves and local repairs. Own
/// construction: punctureToSphere() followed by repairFlips(), because the linear solution alone
/// may fold.

#ifndef ConformalHarmonicSphereMap_h
#define ConformalHarmonicSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct HarmonicSphereMap
{
  Points Positions; ///< #V by 3 unit vectors; their area-weighted mean is 0
  /// Whether badTriangles() finds no triangle; otherwise Positions are invalid
  bool OneToOne = false;
  bool Repaired = false;    ///< whether folds were repaired
  Index NumberOfSolves = 0; ///< number of global linear solves
};

/// Map a closed surface of genus zero conformally to the unit sphere.
///
/// 1. Map by punctureToSphere(), and repair folds by repairFlips().
/// 2. If the removed triangle (the puncture) lies on a limb, or repair fails, repeat step 1 once
///    with another triangle.
/// 3. Move the vertices of misshapen triangles to preserve angles better. On a small mesh, move all
///    vertices.
///
/// @param[in] mesh  mesh of size about 1
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run = {});
}

#endif
