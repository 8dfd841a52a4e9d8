/// Conformal map of a closed surface to the sphere by linear solves and local repair.
/// Own construction: combines the punctured map and the repair of flips.

#ifndef ConformalHarmonicSphereMap_h
#define ConformalHarmonicSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct HarmonicSphereMap
{
  Points Positions;      ///< #V by 3 unit vectors, centered by area
  bool OneToOne = false; ///< no triangle is bad (badTriangles()); otherwise, Positions are invalid
  bool Repaired = false; ///< folds were repaired
  Index NumberOfSolves = 0; ///< number of global linear solves
};

/// Map a closed surface of genus zero conformally to the unit sphere.
///
/// 1. Map by punctureToSphere(), and repair folds by repairFlips().
/// 2. If the puncture lies on a limb, or repair fails, repeat once with another puncture.
/// 3. Move the vertices of misshapen triangles, or all vertices of a small mesh, to preserve angles
///    better.
///
/// @param[in] mesh  about of size one
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run = {});
}

#endif
