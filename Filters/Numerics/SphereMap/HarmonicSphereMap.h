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
  Points Positions;         ///< #V by 3 unit vectors, centered by area
  bool OneToOne = false;    ///< no triangle is bad (badTriangles); else Positions are of no use
  bool Repaired = false;    ///< folds were taken out
  Index NumberOfSolves = 0; ///< global ones
};

/// punctureToSphere; repairFlips where it folds; once more with another puncture, if the first one
/// lies on a limb or left too much to be repaired; vertices of misshapen triangles, or all of a
/// small mesh, moved to where angles are kept better.
/// @param[in] mesh  about of size one
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run = {});
}

#endif
