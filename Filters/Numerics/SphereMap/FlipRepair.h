/// Repairs flipped triangles of a map to the sphere.

#ifndef ConformalFlipRepair_h
#define ConformalFlipRepair_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/VertexRings.h"
#include "SphereMap/BoundedTriangles.h"

#include <vector>

namespace conformal
{
/// Of a map to the sphere: triangles with a determinant below this are called bad. Other programs
/// cannot tell smaller ones from flipped ones, since they round unit vectors by 1e-16.
constexpr double MinimumSafeDeterminant = 1e-14;

/// The energy of angles alone.
constexpr SphereEnergy AnglesOnly = { 0.0, 0.0, 1, 0.0 };

/// Ids of the bad triangles, ascending.
std::vector<int> badTriangles(const std::vector<Vector3>& positions, const Triangles& triangles);

/// Take the surroundings of each set of bad triangles, ring after ring, until they can be laid out
/// anew inside their border: by moving vertices into the kernels of their stars, or as a membrane
/// of strings made positive \cite Tutte1963 in the plane in which straight lines are great circles,
/// where triangles have the orientation they have on the sphere. At the ends of limbs, where
/// nothing of the kind is large enough, the strings are weaker the shorter they are, so that
/// triangles shrink less; and where only a few vertices lie around a limb, these are taken out and
/// put back one by one.
/// @param[in] strings        cotangentWeights of the surface
/// @param[in,out] positions  unit vectors; no good triangle becomes bad
/// @return whether none is bad any more
bool repairFlips(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const VertexRings& rings, const BoundedTriangles& shapes,
  const Run& run = {});
}

#endif
