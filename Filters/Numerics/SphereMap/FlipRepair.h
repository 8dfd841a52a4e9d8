/// Repair flipped triangles of a sphere map. Vertices around them get new positions by the planar
/// layout of \cite Tutte1963.

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
/// Minimum determinant of a triangle's three unit vectors; triangles below it count as bad. Other
/// programs may round unit vectors by 1e-16, which can flip smaller triangles.
constexpr double MinimumSafeDeterminant = 1e-14;

/// Sphere energy that depends on angles only, not on areas.
constexpr SphereEnergy AnglesOnly = { 0.0, 0.0, 1, 0.0 };

/// Return the ids of the bad triangles in ascending order. A triangle is bad if its determinant is
/// below MinimumSafeDeterminant.
std::vector<int> badTriangles(const std::vector<Vector3>& positions, const Triangles& triangles);

/// Repair each connected set of bad triangles by moving the vertices of a neighborhood. The
/// neighborhood grows ring by ring until the repair succeeds.
///
/// The border of the neighborhood is fixed. Vertices inside get new positions by one of these
/// methods:
/// - Move each vertex into the kernel of the polygon of its neighbors.
/// - Compute the equilibrium of a membrane of strings with positive constants, \cite Tutte1963. It
///   is computed in the gnomonic plane, since gnomonic projection maps great circles to lines and
///   preserves the orientation of triangles.
/// - Near limb ends, where the triangles of every membrane are too small, weaken short strings so
///   that triangles shrink less.
/// - If only a few vertices lie around a limb, remove them and insert them again one by one.
///
/// @param[in] strings        result of cotangentWeights() for the surface
/// @param[in,out] positions  #V unit vectors, the sphere map; no good triangle becomes bad
/// @return true if no bad triangle is left
bool repairFlips(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const VertexRings& rings, const BoundedTriangles& shapes,
  const Run& run = {});
}

#endif
