/// Repair flipped triangles of a sphere map (map of a surface to the unit sphere). Vertices near
/// flipped triangles get new positions by the planar layout of \cite Tutte1963, or are spread
/// evenly (own construction).

#ifndef ConformalFlipRepair_h
#define ConformalFlipRepair_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/VertexRings.h"
#include "SphereMap/BoundedTriangles.h"

#include <limits>
#include <vector>

namespace conformal
{
/// Determinant of the three unit vectors of a triangle above which it is not bad, of any shape. If
/// another program rounds the unit vectors to 16 digits, a bad triangle can become flipped.
constexpr double MinimumSafeDeterminant = 1e-14;

/// Parameters of SphereEnergy for an energy that depends on angles only, not on areas.
constexpr SphereEnergy AnglesOnly = { 0.0, 0.0, 1, 0.0 };

/// Copy sphere positions from rows to vectors, for repairs.
std::vector<Vector3> toVectors(const Points& points);

/// Copy sphere positions from vectors to rows.
Points toPoints(const std::vector<Vector3>& vectors);

/// Return the ids of the bad triangles in ascending order. A triangle is bad if its determinant is
/// below MinimumSafeDeterminant, and its height below MinimumSafeHeight.
std::vector<int> badTriangles(const std::vector<Vector3>& positions, const Triangles& triangles);

/// Repair each connected set of bad triangles by moving the vertices in a neighborhood of the set.
/// If the repair fails, the neighborhood is enlarged by the neighbors of its vertices, and the
/// repair is repeated.
///
/// Vertices at the border of the neighborhood are fixed. Vertices inside get new positions by the
/// first of these methods that succeeds:
/// - Move each vertex into the kernel of its neighbors' polygon: positions at which no triangle is
///   flipped, see kernelCentroid().
/// - Regard the edges as springs with positive weights, and move the vertices to the equilibrium of
///   the springs, \cite Tutte1963. The equilibrium is computed in the plane of a gnomonic
///   projection. This projection maps great circles to lines, and preserves the orientation of
///   triangles.
/// - Compute the equilibrium with lower weights for short springs, so that triangles shrink less.
///   This method is necessary near the ends of limbs (thin parts of a shape), where triangles are
///   otherwise too small.
/// - Remove all vertices of the neighborhood, and insert them again one by one. This method is
///   necessary on limbs that have only a few vertices around their circumference.
///
/// @param[in] strings        weights of the springs: result of cotangentWeights() for the surface.
///   To compute the equilibrium, weights are clamped to [0.05, 20].
/// @param[in] minimumHeight  height of a triangle over its longest side above which a triangle of a
///   repaired neighborhood may have a determinant below MinimumSafeDeterminant; by default none
///   may. With MinimumSafeHeight, also small parts of the map are repaired, which may be far from
///   conformal afterward.
/// @param[in,out] positions  #V unit vectors, the sphere map. Triangles that are not bad do not
///   become bad.
/// @return whether no bad triangles remain
bool repairFlips(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const VertexRings& rings, const BoundedTriangles& shapes,
  double minimumHeight = std::numeric_limits<double>::infinity(), const Run& run = {});

/// Move the vertices around bad triangles apart, so that their neighbors get space: each vertex
/// moves to the centroid of the kernel of its neighbors' polygon, see kernelCentroid(). Vertices
/// without a kernel wait. Each round moves the vertices of one ring more around the triangles that
/// are still bad. The result depends on neither angles nor areas of the surface.
///
/// For maps that are flipped where few long triangles bend, as those that are interpolated:
/// repairFlips() needs neighborhoods whose polygons are nearly convex.
///
/// @param[in,out] positions  #V unit vectors, the sphere map. Triangles that are not bad do not
///   become bad.
/// @return whether no bad triangles remain
bool evenOutFlips(std::vector<Vector3>& positions, const Triangles& triangles,
  const VertexRings& rings, const Run& run = {});
}

#endif
