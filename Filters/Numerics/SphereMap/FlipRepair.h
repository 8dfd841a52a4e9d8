/// Repair flipped triangles of a map to the sphere. The planar layout is that of \cite Tutte1963.

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
/// Determinant below which a triangle of a sphere map counts as bad. Other programs round unit
/// vectors by 1e-16, so they may classify smaller triangles as flipped.
constexpr double MinimumSafeDeterminant = 1e-14;

/// Energy of angles alone.
constexpr SphereEnergy AnglesOnly = { 0.0, 0.0, 1, 0.0 };

/// Return the ids of the bad triangles, ascending.
std::vector<int> badTriangles(const std::vector<Vector3>& positions, const Triangles& triangles);

/// Repair each set of bad triangles within the smallest sufficient neighborhood, which grows ring
/// by ring.
///
/// A neighborhood is laid out anew inside its border by one of these methods:
/// - Move vertices into the kernels of their stars.
/// - Solve for a membrane of strings with positive constants \cite Tutte1963. The gnomonic plane
///   maps great circles to lines and preserves the orientation of triangles.
/// - Near limb ends, where no membrane has enough area, weaken short strings so that triangles
///   shrink less.
/// - If only a few vertices lie around a limb, remove them and reinsert them one by one.
///
/// @param[in] strings        cotangentWeights() of the surface
/// @param[in,out] positions  unit vectors; no good triangle becomes bad
/// @return whether no triangle is bad
bool repairFlips(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const VertexRings& rings, const BoundedTriangles& shapes,
  const Run& run = {});
}

#endif
